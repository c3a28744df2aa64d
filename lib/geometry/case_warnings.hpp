#pragma once
/// What the mesh, the supports and the loads of a case show together and a design's numbers alone do not. Plain warnings, one
/// line each: "place: what is wrong; what would be right". None of them for any design of designs/.
///     size        a body shorter than 2 mm or longer than 3 m: lengths in a wrong unit
///     symmetry    a traction or gravity across a plane at which the model is cut: its mirror image is loaded the
///                 other way, and the actuator is torn apart in place of being bent
///     outputs     a displacement of a face that is held in that direction, which stays 0
///     outside     a face is pressed and the only cavity is not
///     openings    a cavity of a drawn or imported shape with more than one: a face of its wall has another name
///     gas         surroundings below 1 kPa or beyond 10 MPa, a density of no gas at that pressure, a dead volume or a mass
///                 beyond a thousand times what the undeformed cavity holds
///     parts       a mesh from a file whose cells hang together in several parts that share no node
/// Tested by geometry/case_warnings_test and Pipeline.MisleadingDesignsAreNamed.
#include <string>
#include <vector>

#include "design/design.hpp"
#include "model/case.hpp"

namespace soft::geometry {

[[nodiscard]] std::vector<std::string> case_warnings(const design::Design& design, const model::Case& built);

}  // namespace soft::geometry
