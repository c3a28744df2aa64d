#pragma once
/// Nodes duplicated per region: stress and stretch are discontinuous at the interface of two materials, so a node on the interface has
/// one value for each region. Nodal fields are arrays over these region points. Tested by post/step_fields_test.
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"

namespace soft::post {

struct RegionPoints {
    std::vector<mesh::Index> node;           ///< of each region point, ascending; region ascending at equal nodes
    std::vector<std::int32_t> region;        ///< index into mesh::Mesh::region_names
    std::vector<std::int32_t> connectivity;  ///< region point of each entry of mesh::Mesh::connectivity

    [[nodiscard]] std::size_t size() const noexcept { return node.size(); }
    /// Region points of a cell, in the order of its nodes.
    [[nodiscard]] std::span<const std::int32_t> of_cell(const mesh::Mesh& mesh, mesh::Index cell) const {
        const auto nodes = mesh.cell_nodes(cell);
        return {connectivity.data() + (nodes.data() - mesh.connectivity.data()), nodes.size()};
    }
};

/// One point for each pair of a node and a region with a cell at that node; nodes without cells have none.
[[nodiscard]] RegionPoints make_region_points(const mesh::Mesh& mesh);

}  // namespace soft::post
