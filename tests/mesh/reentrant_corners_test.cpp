#include "mesh/reentrant_corners.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

namespace soft::mesh {
namespace {

/// Those cells [i, i + 1] x [j, j + 1] (x [k, k + 1]) of a grid for which `includes` is true.
template <class Includes>
Mesh grid(int dimension, Includes includes) {
    Mesh mesh;
    mesh.dimension = dimension;
    mesh.region_names = {"rubber"};
    const CellType type = dimension == 2 ? CellType::quad4 : CellType::hex8;
    std::map<std::array<int, 3>, Index> numbers;
    for (int k = 0; k < (dimension == 2 ? 1 : 3); ++k)
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 3; ++i) {
                if (!includes(i, j, k)) continue;
                std::vector<Index> nodes;
                for (const auto& xi : topology(type).nodes) {
                    const auto step = [](double x) { return x > 0 ? 1 : 0; };
                    const std::array<int, 3> at{i + step(xi[0]), j + step(xi[1]), k + step(xi[2])};
                    const auto [entry, fresh] = numbers.try_emplace(at, static_cast<Index>(mesh.points.size()));
                    if (fresh) mesh.points.push_back({1.0 * at[0], 2.0 * at[1], 1.0 * at[2]});
                    nodes.push_back(entry->second);
                }
                add_cell(mesh, type, nodes, 0);
            }
    return mesh;
}

/// Half of a ring about the origin with two cells and radii 1 and 2.
Mesh half_ring(CellType type) {
    Mesh mesh;
    mesh.dimension = 2;
    mesh.region_names = {"rubber"};
    std::map<std::pair<int, int>, Index> numbers;
    for (int sector = 0; sector < 2; ++sector) {
        std::vector<Index> nodes;
        for (const auto& xi : topology(type).nodes) {
            const std::pair at{static_cast<int>(xi[0]), 2 * sector + static_cast<int>(xi[1])};
            const auto [entry, fresh] = numbers.try_emplace(at, static_cast<Index>(mesh.points.size()));
            const double angle = 0.25 * std::numbers::pi * (at.second + 1), radius = 1.5 + 0.5 * xi[0];
            if (fresh) mesh.points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
            nodes.push_back(entry->second);
        }
        add_cell(mesh, type, nodes, 0);
    }
    return mesh;
}

TEST(ReentrantCorners, FindsTheCornerOfAnLShapedSection) {
    const ReentrantCorners found = find_reentrant_corners(grid(2, [](int i, int j, int) { return i == 0 || j == 0; }));
    EXPECT_EQ(found.count, 1U);
    EXPECT_EQ(found.length_m, 0);
    EXPECT_DOUBLE_EQ(found.cell_m, 2);  // facet sizes 1 and 2: the upper median
    EXPECT_EQ(find_reentrant_corners(grid(2, [](int, int, int) { return true; })).count, 0U);
}

TEST(ReentrantCorners, FindsTheCavityEdgesOfAHollowBlock) {
    const ReentrantCorners found =
        find_reentrant_corners(grid(3, [](int i, int j, int k) { return i != 1 || j != 1 || k != 1; }));
    EXPECT_EQ(found.count, 12U);
    EXPECT_DOUBLE_EQ(found.length_m, 4 * (1 + 2 + 1));
    EXPECT_EQ(find_reentrant_corners(grid(3, [](int, int, int) { return true; })).count, 0U);
    // A slot has two edges along it.
    EXPECT_DOUBLE_EQ(find_reentrant_corners(grid(3, [](int i, int j, int) { return i != 1 || j == 0; })).length_m,
                     2 * 3);
}

TEST(ReentrantCorners, IgnoresABendOfCurvedCells) {
    EXPECT_EQ(find_reentrant_corners(half_ring(CellType::quad9)).count, 0U);
    EXPECT_EQ(find_reentrant_corners(half_ring(CellType::quad4)).count,
              1U);  // the two straight inner edges meet at 90 degrees
}

}  // namespace
}  // namespace soft::mesh
