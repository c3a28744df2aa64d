#include "surface/wall.hpp"

#include <gtest/gtest.h>

#include "sample_meshes.hpp"

namespace soft::surface {
namespace {

WallThickness thinnest(const model::Case& model) { return min_wall(model, model.cavities.front()).value(); }

TEST(MinWall, OfABoxIsItsThinnestSide) {
    test::BoxLines lines;
    lines.y = {-1.6, -0.5, 0.5, 1.25};
    const WallThickness wall = thinnest(test::hollow_box(test::Hole::none, lines));
    EXPECT_NEAR(wall.thickness_m, 0.75, 1e-12);
    EXPECT_NEAR(wall.location[1], 0.5, 1e-12);
}

TEST(MinWall, OfASphereIsTheDifferenceOfTheRadii) {
    EXPECT_NEAR(thinnest(test::sphere_shell(4)).thickness_m, 1.0, 2e-3);
}

TEST(MinWall, OfAnEccentricBallLiesAtItsPole) {
    test::Annulus ball;
    ball.shift = {0.4, 0};
    const WallThickness wall = thinnest(test::annulus_section(ball, 24));
    EXPECT_NEAR(wall.thickness_m, 0.6, 1e-4);
    EXPECT_NEAR(wall.location[0], 1.4, 1e-3);
    EXPECT_LT(wall.location[1], 0.02);
}

TEST(MinWall, OfAnEccentricRingLiesWhereTheCirclesAreNearest) {
    test::Annulus ring;
    ring.centre_r = 9;
    ring.shift = {0.36, -0.48};  // 0.6 off, along (0.6, -0.8)
    const WallThickness wall = thinnest(test::annulus_section(ring, 32));
    EXPECT_NEAR(wall.thickness_m, 0.4, 1e-4);
    EXPECT_NEAR(wall.location[0], 0.36 + 0.6, 0.02);
    EXPECT_NEAR(wall.location[1], 9 - 0.48 - 0.8, 0.02);
}

TEST(MinWall, ContinuesBehindTheAxis) {
    // cavity between r = 0.5 and 1 around a solid core, thick outside: the thinnest rubber is the core's diameter, 1 m
    test::MeshBuilder builder(2);
    const std::array<double, 4> x{0, 2, 5, 7}, r{0, 0.5, 1, 4};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            if (i == 1 && j == 1) continue;
            builder.add_block(
                [&](double u, double v, double) {
                    return mesh::Point{std::lerp(x[i], x[i + 1], u), std::lerp(r[j], r[j + 1], v), 0};
                },
                2, 2);
        }
    builder.name_facets("cavity",
                        [](const mesh::Point& p) { return p[0] >= 2 && p[0] <= 5 && p[1] >= 0.5 && p[1] <= 1; });
    const WallThickness wall = thinnest(test::make_case(builder.take(), model::Kinematics::axisymmetric));
    EXPECT_NEAR(wall.thickness_m, 1.0, 1e-12);
    EXPECT_NEAR(wall.location[1], 0.5, 1e-12);
}

TEST(MinWall, ContinuesBehindASymmetryPlane) {
    // a hollow beside the plane y = 0: 0.2 m to the plane are 0.4 m of rubber to its mirror image
    test::BoxLines lines;
    lines.y = {0, 0.2, 1.2, 1.7};
    model::Case model = test::hollow_box(test::Hole::none, lines);
    model.symmetry_planes = {false, true, false};
    model.model_fraction = 0.5;
    const WallThickness wall = thinnest(model);
    EXPECT_NEAR(wall.thickness_m, 0.4, 1e-12);
    EXPECT_NEAR(wall.location[1], 0.2, 1e-12);
}

}  // namespace
}  // namespace soft::surface
