#pragma once
/// Warnings that need the mesh, the supports and the loads of a case, not only the numbers of the design. Each is one line,
/// "location: problem; remedy". No design of designs/ triggers one. The checks:
///     size        a body shorter than 2 mm or longer than 3 m: lengths in a wrong unit
///     symmetry    a traction or gravity across a symmetry plane: the mirror image is loaded in the opposite direction, so the
///                 actuator is pulled apart instead of bent
///     outputs     a displacement of a face that supports fix in that direction: it stays 0
///     outside     a face is under pressure and the only cavity is not
///     openings    a cavity of a drawn or imported shape with several openings: a face of its wall has another name
///     gas         ambient pressure below 1 kPa or above 10 MPa, a density that no gas has at that pressure, a dead volume or a
///                 mass above a thousand times what the undeformed cavity contains
///     quality     a cell with a scaled Jacobian below 0.1
///     parts       a mesh from a file whose cells form several parts that share no node
/// Tested by geometry/case_warnings_test and Pipeline.MisleadingDesignsAreReported.
#include <string>
#include <vector>

#include "design/design.hpp"
#include "model/case.hpp"

namespace soft::geometry {

[[nodiscard]] std::vector<std::string> case_warnings(const design::Design& design, const model::Case& built);

}  // namespace soft::geometry
