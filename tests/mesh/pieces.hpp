#pragma once
/// Meshes with several cells of every type that share edges, triangles and quadrilaterals, and checks for valid meshes.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>

#include "blocks.hpp"
#include "mesh/cell_map.hpp"
#include "mesh/split.hpp"

namespace soft::mesh::sample {

/// First-order cells given by the positions of their corners. Coincident corners are merged.
inline Mesh mesh_of(int dimension, const std::vector<std::pair<CellType, std::vector<Point>>>& cells) {
    Mesh mesh;
    mesh.dimension = dimension;
    mesh.region_names = {"left", "right"};
    std::map<Point, Index> numbers;
    for (const auto& [type, corners] : cells) {
        std::vector<Index> nodes;
        for (const Point& corner : corners) {
            const auto [entry, fresh] = numbers.try_emplace(corner, static_cast<Index>(mesh.points.size()));
            if (fresh) mesh.points.push_back(corner);
            nodes.push_back(entry->second);
        }
        add_cell(mesh, type, nodes, mesh.cell_count() % 2 == 0 ? 0 : 1);
    }
    for (const Facet& facet : boundary_facets(mesh))
        mesh.facet_sets[facet.cell == 0 ? "first" : "others"].push_back(facet);
    mesh.point_sets["corner"] = {1};
    return mesh;
}

/// A quadratic map (total degree two) that is injective on the samples.
inline Point bent(const Point& p) {
    return {p[0] + 0.04 * p[1] * p[1] - 0.03 * p[2] * p[0], p[1] + 0.05 * p[0] * p[1] + 0.02 * p[2] * p[2],
            1.1 * p[2] + 0.03 * p[0] * p[0]};
}

inline Point bent_in_plane(const Point& p) {
    const Point q = bent({p[0], p[1], 0});
    return {q[0], q[1], 0};
}

/// A hexahedron with two wedges side by side on its right and one more wedge on top of these.
inline Mesh wedges_and_hexahedra() {
    const auto column = [](std::vector<std::array<double, 2>> base, double low, double high) {
        std::vector<Point> corners;
        for (const double z : {low, high})
            for (const auto& p : base) corners.push_back({p[0], p[1], z});
        return corners;
    };
    return mesh_of(3, {{CellType::hex8, column({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0, 1)},
                       {CellType::wedge6, column({{1, 0}, {2, 0}, {1, 1}}, 0, 1)},
                       {CellType::wedge6, column({{2, 1}, {1, 1}, {2, 0}}, 0, 1)},
                       {CellType::wedge6, column({{2, 1}, {1, 1}, {2, 0}}, 1, 2.5)}});
}

inline Mesh triangles_and_quadrilaterals() {
    return mesh_of(2, {{CellType::quad4, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}},
                       {CellType::triangle3, {{1, 0, 0}, {2, 0, 0}, {1, 1, 0}}},
                       {CellType::triangle3, {{2, 1, 0}, {1, 1, 0}, {2, 0, 0}}}});
}

/// Two cubes of six tetrahedra each.
inline Mesh tetrahedra() {
    Mesh cubes = row_of(CellType::hex8, 2);
    for (const Facet& facet : boundary_facets(cubes))
        cubes.facet_sets[facet.cell == 0 ? "first" : "others"].push_back(facet);
    cubes.point_sets["corner"] = {1};
    return split_into_simplices(cubes);
}

/// Sum of the outward area vectors of facets.
inline std::array<double, 3> vector_area(const Mesh& mesh, const std::vector<Facet>& facets) {
    std::array<double, 3> sum{};
    for (const Facet& facet : facets)
        for (const QuadraturePoint& p : volume_rule(facet_type(mesh, facet))) {
            const auto n = facet_normal(mesh, facet, shape_values(facet_type(mesh, facet), p.xi));
            for (std::size_t d = 0; d < 3; ++d) sum[d] += p.weight * n[d];
        }
    return sum;
}

/// Every facet belongs to one or two cells, and two cells that share a facet have the same nodes on it, mid nodes included.
inline void expect_conforming(const Mesh& mesh) {
    std::map<std::set<Index>, std::vector<std::set<Index>>> sides;
    for (Index cell = 0; cell < mesh.cell_count(); ++cell)
        for (int local = 0; local < static_cast<int>(topology(mesh.cell_type(cell)).facets.size()); ++local) {
            const auto nodes = facet_nodes(mesh, {cell, local});
            const int corners = topology(facet_type(mesh, {cell, local})).vertex_count;
            sides[{nodes.begin(), nodes.begin() + corners}].push_back({nodes.begin(), nodes.end()});
        }
    for (const auto& [corners, found] : sides) {
        EXPECT_LE(found.size(), 2u);
        EXPECT_EQ(found.front(), found.back());
    }
    const std::set<Point> positions(mesh.points.begin(), mesh.points.end());
    EXPECT_EQ(positions.size(), mesh.points.size()) << "two nodes at the same position";
    const std::set<Index> used(mesh.connectivity.begin(), mesh.connectivity.end());
    EXPECT_EQ(used.size(), mesh.points.size()) << "a node without a cell";
}

}  // namespace soft::mesh::sample
