#include "meshing/body_walls.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "soups.hpp"

namespace soft::meshing {
namespace {

TEST(BodyWalls, ASphericalShellHasUniformThickness) {
    const BodySurface shell =
        test::made(test::joined(test::ball_soup({0, 0, 0}, 10, 96), test::ball_soup({0, 0, 0}, 8, 96)));
    const auto found = walls(shell.points, shell.triangles);
    EXPECT_NEAR(static_cast<double>(found.size()), 20000, 500);
    const WallStatistics figure = wall_statistics(found);
    EXPECT_NEAR(figure.thinnest.thickness_m, 2e-3, 2e-5);  // facets of a ball lie 0.05 % inside
    EXPECT_NEAR(figure.median_m, 2e-3, 1e-5);
}

TEST(BodyWalls, AdjacentSidesOfAPlateAreNotMeasuredAsAWall) {
    const BodySurface plate = test::made(test::box_soup({0, 0, 0}, {100, 60, 2}));
    const WallStatistics figure = wall_statistics(walls(plate.points, plate.triangles));
    EXPECT_NEAR(figure.thinnest.thickness_m, 2e-3, 1e-12);
    EXPECT_NEAR(figure.median_m, 2e-3, 1e-12);
}

/// Oracle: the definition, evaluated over all walls.
TEST(BodyWalls, SizesAreTheMinimumOverTheWallsPlusGrowthWithDistance) {
    const std::vector<Wall> found{{{0, 0, 0}, 2e-3}, {{10e-3, 0, 0}, 1e-3}, {{20e-3, 0, 0}, 50e-3}};
    const WallSizes sizes(found, {}, {0.1e-3, 4e-3, 2});
    for (int k = 0; k < 100; ++k) {
        const mesh::Point p{0.25e-3 * k, 1e-3 * std::sin(k), 0};
        double expected = 4e-3;
        for (const Wall& wall : found)
            expected = std::min(expected, wall.thickness_m / 2 + 0.5 * std::hypot(p[0] - wall.location[0], p[1], p[2]));
        EXPECT_NEAR(sizes(p), expected, 0.05 * expected);  // walls of similar size share a class
    }
    EXPECT_EQ(WallSizes(found, {}, {0.1e-3, 4e-3, 0})({0, 0, 0}), 4e-3);
    EXPECT_NEAR(WallSizes(found, {}, {0.8e-3, 4e-3, 2})({10e-3, 0, 0}), 0.8e-3, 0.04e-3);
}

TEST(BodyWalls, TheBendRadiusOfABallIsItsRadiusAndABoxHasNoBends) {
    std::vector<double> radii_m;
    for (const Bend& bend : bends(test::made(test::ball_soup({0, 0, 0}, 10, 96)))) radii_m.push_back(bend.radius_m);
    std::ranges::sort(radii_m);
    EXPECT_NEAR(radii_m[radii_m.size() / 4], 10e-3,
                0.5e-3);  // the diagonals of its quadrilaterals have a larger radius
    EXPECT_TRUE(bends(test::made(test::box_soup({0, 0, 0}, {1, 2, 3}))).empty());
    const WallSizes sizes({}, {{{0, 0, 0}, 1e-3}}, {0.5e-3, 4e-3, 0});
    EXPECT_NEAR(sizes({2e-3, 0, 0}), 2e-3, 0.1e-3);
}

}  // namespace
}  // namespace soft::meshing
