#pragma once
/// Small meshes for the tests: one reference cell, and a row of cells.
#include <map>

#include "mesh/mesh.hpp"

namespace soft::mesh::sample {

inline constexpr std::array<CellType, 12> all_types{
    CellType::line2, CellType::line3, CellType::triangle3, CellType::triangle6, CellType::quad4,  CellType::quad9,
    CellType::tet4,  CellType::tet10, CellType::hex8,      CellType::hex27,     CellType::wedge6, CellType::wedge18};

/// A cell with its nodes at their reference coordinates.
inline Mesh reference_cell(CellType type) {
    Mesh mesh;
    const CellTopology& cell = topology(type);
    mesh.dimension = cell.dimension;
    mesh.region_names = {"rubber"};
    std::vector<Index> nodes;
    for (const auto& xi : cell.nodes) {
        nodes.push_back(static_cast<Index>(mesh.points.size()));
        mesh.points.push_back(xi);
    }
    add_cell(mesh, type, nodes, 0);
    return mesh;
}

/// `count` copies of the cell side by side along x, two units apart. Coincident nodes are merged.
inline Mesh row_of(CellType type, int count) {
    Mesh mesh;
    const CellTopology& cell = topology(type);
    mesh.dimension = cell.dimension;
    mesh.region_names = {"rubber"};
    std::map<Point, Index> numbers;
    for (int c = 0; c < count; ++c) {
        std::vector<Index> nodes;
        for (const auto& xi : cell.nodes) {
            const Point position{xi[0] + 2.0 * c, xi[1], xi[2]};
            const auto [entry, fresh] = numbers.try_emplace(position, static_cast<Index>(mesh.points.size()));
            if (fresh) mesh.points.push_back(position);
            nodes.push_back(entry->second);
        }
        add_cell(mesh, type, nodes, 0);
    }
    return mesh;
}

}  // namespace soft::mesh::sample
