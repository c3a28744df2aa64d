#pragma once
/// Uniform refinement: lines are divided into 2 cells, triangles and quadrilaterals into 4, tetrahedra, hexahedra and wedges
/// into 8 cells of the same type. The refined mesh is conforming.
/// Tetrahedra: four children at the corners, four from the octahedron between them, which is cut along the diagonal from the
/// midpoint of edge 0-2 to that of edge 1-3. The children are numbered so that repeated refinement produces at most three
/// similarity classes per tetrahedron (J. Bey, Tetrahedral grid refinement, Computing 55, 1995).
/// Tested by mesh/refine_test.
#include <span>
#include <vector>

#include "mesh/mesh.hpp"

namespace soft::mesh {

/// Positions of the new nodes of second-order cells.
///   parabola  given by the isoparametric map of the coarse cell: the discrete geometry does not change
///   circle    on the circle through the three nodes of an edge (mesh/arcs.hpp): the mesh converges to the original geometry if
///             that is bounded by lines, circular arcs, and surfaces swept from them; interior nodes follow the edges
enum class Curve { parabola, circle };

/// Points keep their numbers, and point sets keep their points. The children of cell c are 2^d c, 2^d c + 1, ..., in the region
/// of c. Facet sets contain the children of each facet. Throws std::logic_error for negative `times`.
[[nodiscard]] Mesh refine(const Mesh& mesh, int times, Curve curve = Curve::parabola);

/// A mesh refined once, with the interpolation from the coarse mesh: the value of a coarse nodal field at point p is the sum of
/// weights[k] x field[nodes[k]] for k in [offsets[p], offsets[p + 1]). The weights are the shape functions of the coarse cell;
/// zeros are omitted.
struct Refined {
    Mesh mesh;
    std::vector<Index> offsets{0}, nodes;
    std::vector<double> weights;
};
[[nodiscard]] Refined refine_once(const Mesh& mesh, Curve curve);

/// Interpolates a nodal field, [point x components], from the coarse mesh to the refined one. Existing points keep their values.
/// Exact for fields in the finite element space of the coarse mesh. Throws std::logic_error for a wrong number of values.
[[nodiscard]] std::vector<double> prolong(const Refined& refined, std::span<const double> field, int components);

}  // namespace soft::mesh
