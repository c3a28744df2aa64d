#include "view/obstacle_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace soft::view {
namespace {

constexpr double radius_m = 0.01;
const Window window{{-0.05, -0.05, -0.05}, {0.05, 0.05, 0.05}};

model::Case case_with(const model::Obstacle& obstacle, model::Kinematics kinematics) {
    model::Case model;
    model.kinematics = kinematics;
    model.obstacles = {obstacle};
    return model;
}

/// All ends of the lines satisfy `lies`, are inside the window, and there are some.
void expect_lines(const model::Case& model, const Vector3& shift, Extent extent,
                  const std::function<double(const Point&)>& distance_m) {
    const auto lines = obstacle_lines(model, model.obstacles[0], shift, window, extent);
    EXPECT_GT(lines.size(), 50u);
    for (const Line& line : lines)
        for (const Point& p : line) {
            EXPECT_NEAR(distance_m(p), 0, 1e-12);
            for (std::size_t d = 0; d < 3; ++d) EXPECT_TRUE(p[d] >= window.low[d] && p[d] <= window.high[d]);
        }
}

TEST(ObstacleLines, LieOnTheSurfaceInSpace) {
    const Vector3 normal{0.6, 0, 0.8}, shift{0, 0, 0.003};
    expect_lines(case_with({"table", model::Plane{{0.01, 0, 0}, normal}}, model::Kinematics::solid), shift,
                 Extent::whole, [&](const Point& p) {
                     return dot(difference(p, along({0.01, 0, 0}, 1, shift)), normal);
                 });
    const Vector3 axis{0, 1, 0};
    expect_lines(case_with({"post", model::Cylinder{{0.02, 0, -0.01}, axis, radius_m}}, model::Kinematics::solid),
                 shift, Extent::whole,
                 [&](const Point& p) { return std::hypot(p[0] - 0.02, p[2] + 0.007) - radius_m; });
    expect_lines(case_with({"ball", model::Sphere{{0, 0.01, 0}, radius_m}}, model::Kinematics::solid), shift,
                 Extent::modelled, [&](const Point& p) {
                     return norm(difference(p, {0, 0.01, 0.003})) - radius_m;
                 });
}

TEST(ObstacleLines, AreRevolvedWithASectionButNotInItsPlane) {
    const model::Case model = case_with({"sleeve", model::Cylinder{{}, {1, 0, 0}, radius_m, model::Side::inside}},
                                        model::Kinematics::axisymmetric);
    expect_lines(model, {}, Extent::opened, [](const Point& p) { return std::hypot(p[1], p[2]) - radius_m; });
    expect_lines(model, {}, Extent::flat, [](const Point& p) { return std::hypot(p[1] - radius_m, p[2]); });
}

TEST(ObstacleLines, AreMirroredWithTheActuator) {
    model::Case model = case_with({"plate", model::Plane{{0, 0.02, 0}, {0, -1, 0}}}, model::Kinematics::solid);
    model.symmetry_planes = {false, true, false};
    const Vector3 shift{};
    for (const bool mirrored : {true, false}) {
        const auto lines =
            obstacle_lines(model, model.obstacles[0], shift, window, mirrored ? Extent::whole : Extent::modelled);
        EXPECT_EQ(std::ranges::any_of(lines, [](const Line& line) { return line[0][1] < 0; }), mirrored);
    }
    model.kinematics = model::Kinematics::plane_strain;  // drawn as modelled
    for (const Line& line : obstacle_lines(model, model.obstacles[0], shift, window, Extent::opened))
        EXPECT_GT(line[0][1], 0);
}

}  // namespace
}  // namespace soft::view
