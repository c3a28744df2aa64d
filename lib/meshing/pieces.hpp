#pragma once
/// Faces that lie apart but carry one name in the file. Tested by geometry/imported_test.
#include "mesh/mesh.hpp"

namespace soft::meshing {

/// Adds to every facet set of several pieces without a common node the sets <name>_1, <name>_2, ..., one a piece, in the
/// order of their lowest x (then y, z). A name that is taken is left as it is.
void name_pieces(mesh::Mesh& mesh);

}  // namespace soft::meshing
