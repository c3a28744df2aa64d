#pragma once
/// Detects walls that are meshed with a single layer of cells: cells whose vertices all lie on the boundary. Such a mesh has no
/// vertex inside the wall, and its difference from the refined mesh may underestimate the discretisation error.
/// Tested by mesh/single_layer_test.
#include <span>
#include <string>

#include "mesh/mesh.hpp"

namespace soft::mesh {

/// Number of those cells divided by the number of all cells; 0 for an empty mesh. Facets in the sets named by `excluded` do not
/// count as boundary: symmetry planes, behind which the wall continues, and supported faces. Unknown names are ignored.
[[nodiscard]] double single_layer_fraction(const Mesh& mesh, std::span<const std::string> excluded);

}  // namespace soft::mesh
