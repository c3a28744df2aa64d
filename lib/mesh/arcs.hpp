#pragma once
/// Second-order cells with circular instead of parabolic edges: where refinement puts new nodes, so that straight lines and
/// circular arcs, and with them surfaces of revolution and extrusions, are reproduced at every level.
/// Along an edge the angle on the circle through its three nodes is the quadratic function of xi that has the nodes' values:
/// the quarter points of an arc whose mid node halves it, and the parabola's own point on a straight edge.
/// Quadrilaterals and hexahedra: rows of such edges along xi, of the results along eta, then zeta. Triangles and tetrahedra:
/// the cell's polynomial map plus sum over edges of 4 l_i l_j / (1 - (l_i - l_j)^2) x (arc - parabola) at l_j - l_i, with l the
/// barycentric coordinates (W. Gordon and C. Hall, Numer. Math. 21 (1973) 109, in the form for simplices of J. Hesthaven and
/// T. Warburton, Nodal Discontinuous Galerkin Methods (2008), 6.1). Wedges: triangles, then edges along zeta.
/// On a corner, edge or side only the nodes there matter, so neighbours agree up to the order of a side's two directions.
/// Tested by mesh/arcs_test and mesh/refine_test.
#include <span>
#include <vector>

#include "mesh/mesh.hpp"

namespace soft::mesh {

/// Point at xi in [-1, 1] of the edge with these ends and mid node, each half less than half a circle. An edge whose mid
/// node is nearer to the chord than 1e-9 of its length is taken as its parabola.
[[nodiscard]] Point arc_point(const Point& first, const Point& middle, const Point& last, double xi);

/// The map of a cell type; of first order it is the cell's own.
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
    std::vector<std::vector<std::size_t>> of_;
    std::array<std::size_t, 27> grid_{};  ///< tensor cells: node at the place (i, j, k) of {-1, 0, 1}, i + 3 j + 9 k
};

}  // namespace soft::mesh
