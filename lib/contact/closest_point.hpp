#pragma once
/// Closest point of a curved facet, in its interior, on one of its edges or at a corner, and the derivatives of the distance.
/// Tested by contact/closest_point_test.
#include <array>

#include "contact/patch.hpp"

namespace soft::contact {

/// A facet with first and second derivatives of its map.
struct FacetJet {
    mesh::Point y{};
    std::array<Vector3, 2> first{};                  ///< dy/dxi_i
    std::array<std::array<Vector3, 2>, 2> second{};  ///< d2y/dxi_i dxi_j
};
[[nodiscard]] FacetJet jet(const Patch& facet, const surface::FacetPoint& xi);

struct ClosestPoint {
    double distance_m = 0;
    surface::FacetPoint xi{};
    /// Directions in which the point moves along the facet: both coordinates in its interior, one along an edge, none at a corner.
    std::array<surface::FacetPoint, 2> directions{};
    int free = 0;
    std::size_t edge = 0;  ///< on which the point lies, if free is 1 in a surface
    bool is_interior = false;
};

/// The corners that edge k of a facet connects. A line has no edges.
[[nodiscard]] std::array<std::size_t, 2> edge_corners(mesh::CellType facet, std::size_t k);
/// Closest point of one edge, its ends included, or the corner itself.
[[nodiscard]] ClosestPoint closest_on_edge(const Patch& facet, std::size_t k, const mesh::Point& x);
[[nodiscard]] ClosestPoint at_corner(const Patch& facet, std::size_t corner, const mesh::Point& x);

/// The search starts at the closest node, so that a strongly curved facet may give a local minimum.
[[nodiscard]] ClosestPoint closest_point(const Patch& facet, const mesh::Point& x);

}  // namespace soft::contact
