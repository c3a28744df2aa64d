#pragma once
/// Uniform refinement: a line into 2 cells, triangles and quadrilaterals into 4, tetrahedra, hexahedra and wedges into 8,
/// of the same type. New nodes lie where the cell's own map puts them, so the shape is reproduced exactly: curved
/// second-order edges stay on their parabola, and neighbours match.
/// Tetrahedra: four at the corners, four from the octahedron between them, cut along the diagonal from the middle of edge
/// 0-2 to that of 1-3; the children are numbered so that repeated refinement gives at most three shapes of a tetrahedron
/// (J. Bey, Tetrahedral grid refinement, Computing 55, 1995).
/// Held by mesh/refine_test.
#include "mesh/mesh.hpp"

namespace soft::mesh {

/// Points keep their numbers, and point sets their points; the children of cell c are 2^d c, 2^d c + 1, ..., in its
/// region; facet sets are carried over to the pieces of each facet. Throws std::logic_error for negative `times`.
[[nodiscard]] Mesh refine(const Mesh& mesh, int times);

}  // namespace soft::mesh
