#pragma once
/// Gmsh's node order and ours. Private to the module. Tested by meshing/import_test.
#include <vector>

#include "meshing/msh_file.hpp"

namespace soft::meshing {

/// For each node of the cell (VTK's order) its place in Gmsh's element, or `lacking` where the element has none.
inline constexpr int lacking = -1;
[[nodiscard]] std::vector<int> gmsh_places(const MshType& type);

/// A node that serendipity elements lack, from those they have: X = sum weight X_node. Q2 of the nodes of a side is
/// -1/4 of its corners and 1/2 of its mid-edge nodes; at the centre -1/4 and 1/4 of the whole cell's. `node`, `parts`
/// in the cell's (VTK's) order.
struct Completion {
    int node;
    std::vector<std::pair<int, double>> parts;
    std::vector<int> corners;  ///< whose mean it is; four on a side
};
[[nodiscard]] std::vector<Completion> completions(const MshType& type);

/// Node order of the mirrored cell: new node a is old node mirrored_order(type)[a].
[[nodiscard]] std::vector<int> mirrored_order(mesh::CellType type);

}  // namespace soft::meshing
