#pragma once
/// Conversion from Gmsh's node order to VTK's, which mesh::Mesh uses. Private to the module. Tested by meshing/import_test.
#include <vector>

#include "meshing/msh_file.hpp"

namespace soft::meshing {

/// For each node of the cell (VTK's order) its number in Gmsh's element, or `missing_node` if the element lacks it.
inline constexpr int missing_node = -1;
[[nodiscard]] std::vector<int> gmsh_node_numbers(const MshType& type);

/// A node that serendipity elements lack, interpolated from their nodes: X = sum weight X_node. The weights on a side are
/// -1/4 for its corners and 1/2 for its mid-edge nodes; at the centre of a cell -1/4 and 1/4. `node` and `parts` use the
/// numbering of the cell (VTK's order).
struct Completion {
    int node;
    std::vector<std::pair<int, double>> parts;
    std::vector<int> corners;  ///< the node is the mean of these corners; four on a side
};
[[nodiscard]] std::vector<Completion> completions(const MshType& type);

/// Node order of the mirrored cell: new node a is old node mirrored_order(type)[a].
[[nodiscard]] std::vector<int> mirrored_order(mesh::CellType type);

}  // namespace soft::meshing
