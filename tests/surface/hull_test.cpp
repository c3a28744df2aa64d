#include "surface/hull.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace soft::surface {
namespace {

TEST(Hull, OfABoxIgnoresInteriorPoints) {
    std::vector<mesh::Point> points;
    for (int i = 0; i < 27; ++i) points.push_back({0.01 * (i % 3), 0.02 * (i / 3 % 3), -0.005 * (i / 9)});
    EXPECT_NEAR(hull_volume_m3(points), 0.02 * 0.04 * 0.01, 1e-18);
}

TEST(Hull, OfPointsOnASphereApproximatesItsVolume) {
    std::vector<mesh::Point> points;
    constexpr int count = 4000;
    for (int i = 0; i < count; ++i) {  // a spiral of uniform density
        const double z = 1 - 2 * (i + 0.5) / count, r = std::sqrt(1 - z * z), a = 2.399963229728653 * i;
        points.push_back({r * std::cos(a), r * std::sin(a), z});
    }
    const double sphere = 4 * std::numbers::pi / 3;
    EXPECT_LT(hull_volume_m3(points), sphere);
    EXPECT_NEAR(hull_volume_m3(points) / sphere, 1.0, 2e-3);
}

TEST(Hull, OfCoplanarPointsIsZero) {
    EXPECT_EQ(hull_volume_m3({}), 0);
    EXPECT_EQ(hull_volume_m3(std::vector<mesh::Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), 0);
    EXPECT_EQ(hull_volume_m3(std::vector<mesh::Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5, 0.5, 0}}), 0);
    EXPECT_EQ(hull_volume_m3(std::vector<mesh::Point>{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}), 0);
}

}  // namespace
}  // namespace soft::surface
