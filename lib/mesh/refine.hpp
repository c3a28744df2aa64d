#pragma once
/// Uniform refinement: a line into 2 cells, triangles and quadrilaterals into 4, tetrahedra, hexahedra and wedges into 8,
/// of the same type, so that neighbours match.
/// Tetrahedra: four at the corners, four from the octahedron between them, cut along the diagonal from the middle of edge
/// 0-2 to that of 1-3; the children are numbered so that repeated refinement gives at most three shapes of a tetrahedron
/// (J. Bey, Tetrahedral grid refinement, Computing 55, 1995).
/// Tested by mesh/refine_test.
#include <span>
#include <vector>

#include "mesh/mesh.hpp"

namespace soft::mesh {

/// Where the new nodes of second-order cells lie.
///   parabola  where the cell's own map puts them: the discrete body keeps its shape exactly, edges stay on their parabolas
///   circle    on the circle through an edge's three nodes (mesh/arcs.hpp): the body that was meshed, where lines, circular
///             arcs and what is swept from them bound it, is met ever better; the cells' inside follows
enum class Curve { parabola, circle };

/// Points keep their numbers, and point sets their points; the children of cell c are 2^d c, 2^d c + 1, ..., in its
/// region; facet sets are carried over to the pieces of each facet. Throws std::logic_error for negative `times`.
[[nodiscard]] Mesh refine(const Mesh& mesh, int times, Curve curve = Curve::parabola);

/// A mesh halved once, and where its points are in the cells it was made from: the value of a nodal field of the coarse mesh
/// at point p is the sum of weights[k] x field[nodes[k]] for k in [offsets[p], offsets[p + 1]) (the coarse cell's shape
/// functions; zeros are left out).
struct Refined {
    Mesh mesh;
    std::vector<Index> offsets{0}, nodes;
    std::vector<double> weights;
};
[[nodiscard]] Refined refine_once(const Mesh& mesh, Curve curve);

/// A nodal field, [point x components], from the coarse mesh to the refined one; points that were there keep their values.
/// Exact for what the coarse cells can hold. std::logic_error for another number of values.
[[nodiscard]] std::vector<double> prolong(const Refined& refined, std::span<const double> field, int components);

}  // namespace soft::mesh
