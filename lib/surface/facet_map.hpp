#pragma once
/// The curved shape of a facet: the Lagrange map of its nodes. An edge of a section is extruded along z, so that sections and
/// solids use the same geometry functions. Tested by surface/facet_map_test.
#include <array>
#include <span>

#include "math/vector.hpp"
#include "mesh/mesh.hpp"

namespace soft::surface {

/// Reference coordinates on a facet; for a line the first is the reference coordinate and the second runs along z.
using FacetPoint = std::array<double, 2>;

/// Whether a point lies in the reference facet, at least `margin` from its boundary.
[[nodiscard]] bool is_inside(mesh::Shape shape, const FacetPoint& xi, double margin);

struct FacetMap {
    mesh::CellType type;
    std::array<mesh::Point, 9> nodes{};  ///< the first node_count(type)

    struct Value {
        mesh::Point x;
        Vector3 t1, t2;  ///< dx/dxi; t1 x t2 points out of the cell (of a line: t2 is the unit vector z)
    };
    [[nodiscard]] Value operator()(const FacetPoint& xi) const;
};

/// `positions`: one per mesh point (mesh.points, or points + displacement).
[[nodiscard]] FacetMap facet_map(const mesh::Mesh& mesh, const mesh::Facet& facet,
                                 std::span<const mesh::Point> positions);

}  // namespace soft::surface
