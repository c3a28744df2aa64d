#pragma once
/// Splits quadrilaterals, hexahedra and wedges into triangles and tetrahedra on the same nodes:
/// quad9 -> 2 triangle6, hex27 -> 6 tet10, wedge18 -> 3 tet10 (first-order cells likewise, without mid nodes). Every
/// quadrilateral face is cut along the diagonal from its corner with the smallest number, so the mesh is conforming.
/// Source: J. Dompierre et al., How to subdivide pyramids, prisms and hexahedra into tetrahedra (1999); the mid nodes of
/// the diagonals are the mid-face and centre nodes. Tested by mesh/split_test.
#include "mesh/mesh.hpp"

namespace soft::mesh {

/// Points, regions and point sets are kept. Facet sets contain the pieces of each facet.
[[nodiscard]] Mesh split_into_simplices(const Mesh& mesh);

}  // namespace soft::mesh
