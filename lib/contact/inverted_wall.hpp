#pragma once
/// Distinguishes inverted walls from contact: inverted cells also make the surface intersect itself, but no air is between the two
/// sides. Tested by contact/contact_test and contact/no_contact_test.
#include <array>
#include <span>

#include "mesh/mesh.hpp"

namespace soft::contact {

/// For two facets that intersect at `positions` (one per mesh point): true if they are the two sides of one wall (in the undeformed body
/// each lies behind the other and they face opposite ways) and det F <= 0 at a node of an adjacent cell.
[[nodiscard]] bool is_wall_inverted(const mesh::Mesh& mesh, const std::array<mesh::Facet, 2>& facets,
                                    std::span<const mesh::Point> positions);
/// Whether det F <= 0 at a node of a cell that shares a node with one of the facets.
[[nodiscard]] bool has_inverted_cell(const mesh::Mesh& mesh, std::span<const mesh::Facet> facets,
                                     std::span<const mesh::Point> positions);

}  // namespace soft::contact
