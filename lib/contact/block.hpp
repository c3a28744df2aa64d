#pragma once
/// First and second derivatives of the energy of contact between one facet and another one or an obstacle. Tested by contact/potential_test.
#include <array>
#include <span>
#include <vector>

#include "contact/closest_point.hpp"
#include "mesh/mesh.hpp"
#include "mesh/shape.hpp"

namespace soft::contact {

enum class Wanted { gradient, hessian };

struct Block {
    std::vector<mesh::Index> nodes;  ///< of the facet, then of the other facet
    int obstacle = -1;               ///< index in Case::obstacles: its displacement follows the nodes as one more
    std::size_t dimension = 3;
    std::vector<double> gradient;  ///< of E, [component][node]
    std::vector<double> hessian;   ///< of E, square, row-major; empty if not wanted

    [[nodiscard]] std::size_t points() const { return nodes.size() + (obstacle >= 0 ? 1 : 0); }
};

/// Adds a function of one vector r = sum over points of weight x position, with the derivatives g and H by r: of the energy, or a force and
/// its derivative [component of the force][of r].
void add_function(Block& block, std::span<const double> weights, const Vector3& g, const std::array<Vector3, 3>& H);

/// Adds to the Hessian `factor` times what the motion of the closest point along its facet contributes to that of half the squared
/// distance f: -v^T h^-1 v, with h = d2f/dxi dxi and v = d2f/dxi du. r: from the closest point, the facet's map at which is `y`, to the
/// point. `dN`: derivatives of the shape functions of the facet's nodes, the last of the block; empty for an obstacle, whose nodes do
/// not move relative to each other.
void add_sliding(Block& block, std::span<const double> weights, const FacetJet& y, const ClosestPoint& closest,
                 const Vector3& r, std::span<const mesh::ShapeValue> dN, double factor);

}  // namespace soft::contact
