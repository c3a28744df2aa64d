#pragma once
/// The surface of a body that is really there: the boundary of the mesh without the cuts through the whole actuator.
/// Tested by surface/wall_test and surface/contact_test.
#include <array>
#include <vector>

#include "model/case.hpp"

namespace soft::surface {

/// Coordinates whose zero is a mirror of the body: symmetry planes, and the axis r = 0 of a section.
[[nodiscard]] std::array<bool, 3> mirrors(const model::Case& model);

/// Facets of one cell only that do not lie on a mirror in the undeformed body, in ascending order.
[[nodiscard]] std::vector<mesh::Facet> free_facets(const model::Case& model);

}  // namespace soft::surface
