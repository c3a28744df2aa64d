#pragma once
/// Cells that reach through a wall alone: every vertex of theirs lies on the boundary. Such a mesh has no node inside the wall,
/// and its differences from the halved mesh need not show its error. Tested by mesh/single_cells_test.
#include <span>
#include <string>

#include "mesh/mesh.hpp"

namespace soft::mesh {

/// Number of those cells over the number of all, 0 of an empty mesh. Facets in the sets named by `held` do not count as
/// boundary: planes of symmetry, behind which the wall goes on, and faces that a support holds. Names of no set are ignored.
[[nodiscard]] double single_cell_share(const Mesh& mesh, std::span<const std::string> held);

}  // namespace soft::mesh
