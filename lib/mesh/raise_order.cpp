#include "mesh/raise_order.hpp"

#include <algorithm>

#include "mesh/shared_nodes.hpp"

namespace soft::mesh {
namespace {

/// Everything but points and cells.
Mesh frame_of(const Mesh& mesh) {
    Mesh result;
    result.dimension = mesh.dimension;
    result.region_names = mesh.region_names;
    result.facet_sets = mesh.facet_sets;
    result.point_sets = mesh.point_sets;
    return result;
}

/// For each mid node of the second-order type, the corners whose mean it is.
using MidNodes = std::vector<std::vector<CornerWeight>>;

MidNodes mid_nodes_of(CellType second_order) {
    const CellTopology& cell = topology(second_order);
    MidNodes result;
    for (std::size_t n = static_cast<std::size_t>(cell.vertex_count); n < cell.nodes.size(); ++n)
        result.push_back(corner_weights(second_order, cell.nodes[n]));
    return result;
}

Point mean_of(const Mesh& mesh, std::span<const Index> cell_nodes, const std::vector<CornerWeight>& corners) {
    Point mean{};
    for (const CornerWeight& part : corners) {
        const Point& corner = mesh.point(cell_nodes[static_cast<std::size_t>(part.corner)]);
        for (std::size_t d = 0; d < 3; ++d) mean[d] += corner[d] / static_cast<double>(corners.size());
    }
    return mean;
}

/// Registers the mid nodes of second-order cells so that raised neighbours reuse them.
void register_existing(const Mesh& mesh, const std::map<CellType, MidNodes>& tables, SharedNodes& shared) {
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        const CellTopology& cell = topology(mesh.cell_type(c));
        if (cell.order == 1) continue;
        const auto nodes = mesh.cell_nodes(c);
        const MidNodes& mids = tables.at(cell.type);
        for (std::size_t m = 0; m < mids.size(); ++m)
            if (mids[m].size() <= 4)
                static_cast<void>(
                    shared.number(nodes, mids[m], nodes[static_cast<std::size_t>(cell.vertex_count) + m]));
    }
}

}  // namespace

Mesh raise_order(const Mesh& mesh) {
    Mesh result = frame_of(mesh);
    result.points = mesh.points;
    std::map<CellType, MidNodes> tables;
    for (const CellType type : mesh.cell_types) {
        const CellType raised = with_order(type, 2);
        if (!tables.contains(raised)) tables.emplace(raised, mid_nodes_of(raised));
    }
    SharedNodes shared;
    register_existing(mesh, tables, shared);
    std::vector<Index> nodes;
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        const auto old = mesh.cell_nodes(c);
        const CellType raised = with_order(mesh.cell_type(c), 2);
        nodes.assign(old.begin(), old.end());
        if (raised != mesh.cell_type(c)) {
            for (const auto& corners : tables.at(raised)) {
                const auto next = static_cast<Index>(result.points.size());
                const bool inside = corners.size() > 4;  // the centre of a hexahedron is not shared
                const Index node = inside ? next : shared.number(old, corners, next);
                if (node == next) result.points.push_back(mean_of(mesh, old, corners));
                nodes.push_back(node);
            }
        }
        add_cell(result, raised, nodes, mesh.cell_regions[static_cast<std::size_t>(c)]);
    }
    return result;
}

Mesh lower_order(const Mesh& mesh) {
    Mesh result = frame_of(mesh);
    result.points = mesh.points;
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        const CellType lowered = with_order(mesh.cell_type(c), 1);
        add_cell(result, lowered, mesh.cell_nodes(c).first(static_cast<std::size_t>(node_count(lowered))),
                 mesh.cell_regions[static_cast<std::size_t>(c)]);
    }
    drop_unused_points(result);
    return result;
}

}  // namespace soft::mesh
