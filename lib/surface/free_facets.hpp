#pragma once
/// The physical surface of the body: the boundary of the mesh without the facets on symmetry planes.
/// Tested by surface/wall_test and contact/contact_test.
#include <array>
#include <map>
#include <string>
#include <vector>

#include "model/case.hpp"

namespace soft::surface {

/// Coordinates d for which coordinate d = 0 is a mirror plane of the body: the symmetry planes, and the axis r = 0 of a section of
/// revolution.
[[nodiscard]] std::array<bool, 3> mirrors(const model::Case& model);

/// Boundary facets (of exactly one cell) that do not lie on a mirror plane in the undeformed body, in ascending order.
[[nodiscard]] std::vector<mesh::Facet> free_facets(const model::Case& model);

/// Face names for messages. The wall of a cavity takes precedence over other faces, which are in alphabetical order.
[[nodiscard]] std::map<mesh::Facet, std::string> face_names(const model::Case& model);

}  // namespace soft::surface
