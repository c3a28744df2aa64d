#pragma once
/// Faces of several disconnected pieces with one name in the file. Tested by geometry/imported_test.
#include "mesh/mesh.hpp"

namespace soft::meshing {

/// For every facet set of several pieces without common nodes, adds the sets <name>_1, <name>_2, ..., one per piece, in the order of
/// their lowest x (then y, z). Existing names are not changed.
void name_pieces(mesh::Mesh& mesh);

}  // namespace soft::meshing
