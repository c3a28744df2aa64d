#pragma once
/// Where rubber has passed through itself because cells are inside out, the surface crosses itself as well, but no walls meet:
/// between its two sides is no air. Tested by surface/contact_test and surface/no_contact_test.
#include <array>
#include <span>

#include "mesh/mesh.hpp"

namespace soft::surface {

/// Of two facets that cross at `positions` (one a mesh point): each lies behind the other in the undeformed body and looks the
/// other way, as the sides of one wall do, and det F <= 0 at a node of a cell next to them.
[[nodiscard]] bool wall_is_inside_out(const mesh::Mesh& mesh, const std::array<mesh::Facet, 2>& facets,
                                      std::span<const mesh::Point> positions);

}  // namespace soft::surface
