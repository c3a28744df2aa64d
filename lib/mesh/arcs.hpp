#pragma once
/// Second-order cells with circular instead of parabolic edges. Refinement uses them to position new nodes: straight lines and
/// circular arcs, and therefore surfaces of revolution and extrusions, are reproduced at every level.
/// Along an edge, the angle on the circle through its three nodes is the quadratic function of xi that interpolates the nodes.
/// It gives the quarter points of an arc whose mid node halves it, and the point of the parabola on a straight edge.
/// Quadrilaterals and hexahedra: arcs along xi, then arcs through their results along eta, then along zeta.
/// Triangles and tetrahedra: the cell's polynomial map plus the sum over edges of
/// 4 l_i l_j / (1 - (l_i - l_j)^2) x (arc - parabola) at l_j - l_i, where l are the barycentric coordinates
/// (W. Gordon and C. Hall, Numer. Math. 21 (1973) 109, in the form for simplices of J. Hesthaven and
/// T. Warburton, Nodal Discontinuous Galerkin Methods (2008), 6.1). Wedges: triangles, then arcs along zeta.
/// A point on a corner, edge or facet depends only on the nodes there, so neighbouring cells agree, except that on a facet the
/// order of its two directions matters.
/// Tested by mesh/arcs_test and mesh/refine_test.
#include <span>
#include <vector>

#include "mesh/mesh.hpp"

namespace soft::mesh {

/// Point at xi in [-1, 1] of the edge with these end nodes and mid node. Each half must be less than half a circle. An edge
/// whose mid node is closer to the chord than 1e-9 of the chord length is treated as a parabola.
[[nodiscard]] Point arc_point(const Point& first, const Point& middle, const Point& last, double xi);

/// The map of a cell type. For first-order cells it is the isoparametric map.
class ArcMap {
public:
    explicit ArcMap(CellType type);
    /// `nodes`: positions of the cell's nodes. `xi` as in mesh/cell_type.hpp.
    [[nodiscard]] Point operator()(std::span<const Point> nodes, const std::array<double, 3>& xi) const;

private:
    [[nodiscard]] Point on_simplex(std::span<const Point> nodes, const std::array<double, 3>& xi,
                                   std::size_t level) const;

    const CellTopology* cell_;
    const CellTopology* simplex_ = nullptr;  ///< the cell itself, or the triangle of a wedge
    /// Wedge: its nodes at each level of zeta, in the triangle's order; simplex: one level.
    std::vector<std::vector<std::size_t>> level_nodes_;
    /// Tensor cells: the node with reference coordinates (i, j, k) - 1 has the entry i + 3 j + 9 k.
    std::array<std::size_t, 27> grid_nodes_{};
};

}  // namespace soft::mesh
