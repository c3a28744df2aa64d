#include "view/raster.hpp"

#include <gtest/gtest.h>

namespace soft::view {
namespace {

std::array<Corner, 3> triangle(double depth, double value) {
    return {{{{0, 0, depth}, value, 1}, {{40, 0, depth}, value, 1}, {{0, 40, depth}, value, 1}}};
}

int painted(const Raster& raster) {
    int count = 0;
    for (int y = 0; y < raster.height(); ++y)
        for (int x = 0; x < raster.width(); ++x) count += raster.colour(x, y).blue < 0.99;
    return count;
}

TEST(Raster, ATriangleCoversItsArea) {
    Raster raster(50, 50);
    raster.fill(triangle(0, 0.5));
    EXPECT_NEAR(painted(raster), 800, 40);  // pixels on the edge may count either way
    EXPECT_EQ(raster.colour(45, 45).red, 1.0);
}

TEST(Raster, TwoTrianglesWithACommonEdgeLeaveNoGap) {
    Raster raster(40, 40);
    raster.fill(triangle(0, 0.5));
    raster.fill({{{{40, 0, 0}, 0.5, 1}, {{40, 40, 0}, 0.5, 1}, {{0, 40, 0}, 0.5, 1}}});
    EXPECT_EQ(painted(raster), 1600);
}

TEST(Raster, TheNearerTriangleIsVisibleInEitherOrder) {
    Raster a(50, 50), b(50, 50), only(50, 50);
    only.fill(triangle(2, 0.9));
    a.fill(triangle(1, 0.1));
    a.fill(triangle(2, 0.9));
    b.fill(triangle(2, 0.9));
    b.fill(triangle(1, 0.1));
    EXPECT_EQ(a.reduced(1), only.reduced(1));
    EXPECT_EQ(b.reduced(1), only.reduced(1));
}

TEST(Raster, IntersectingTrianglesHideEachOtherPartly) {
    Raster raster(60, 10);
    raster.fill({{{{0, 0, 0}, 0, 1}, {{60, 0, 60}, 0, 1}, {{30, 30, 30}, 0, 1}}});  // rises to the right
    raster.fill({{{{0, 0, 60}, 1, 1}, {{60, 0, 0}, 1, 1}, {{30, 30, 30}, 1, 1}}});  // falls
    EXPECT_GT(raster.colour(15, 2).red, 0.9);  // the yellow end is in front on the left
    EXPECT_LT(raster.colour(45, 2).red, 0.5);
}

TEST(Raster, OpacityDoesNotAddUpWhereSegmentsOverlap) {
    Raster raster(40, 10);
    const Segment left{{{0, 5, 0}, {20, 5, 0}}}, right{{{20, 5, 0}, {40, 5, 0}}};
    const std::array<Segment, 2> both{left, right};
    raster.lines(both, {.colour = {0, 0, 0}, .width = 2, .in_front = 0.5, .behind = 0.5});
    EXPECT_NEAR(raster.colour(20, 5).red, 0.5, 0.5 / 255);
    EXPECT_NEAR(raster.colour(10, 5).red, 0.5, 0.5 / 255);
}

TEST(Raster, ALineBehindTheSurfaceIsFainter) {
    Raster raster(50, 50);
    raster.fill(triangle(0, 1.0));
    const Rgb before = raster.colour(10, 5);
    const Stroke stroke{.colour = {0, 0, 0}, .width = 2, .in_front = 1, .behind = 0.25};
    const std::array<Segment, 1> behind{{{{{0, 5, -1}, {40, 5, -1}}}}}, before_it{{{{{0, 15, 1}, {40, 15, 1}}}}};
    raster.lines(behind, stroke);
    raster.lines(before_it, stroke);
    EXPECT_NEAR(raster.colour(10, 5).red, 0.75 * before.red, 0.5 / 255);
    EXPECT_NEAR(raster.colour(10, 15).red, 0.0, 1e-6);
}

TEST(Raster, LinesBehindAHidingSurfaceAreOmitted) {
    Raster raster(50, 50), hiding(50, 50);
    hiding.hide({{{0, 0, 0}, {40, 0, 0}, {0, 40, 0}}});
    const std::array<Segment, 1> behind{{{{{0, 5, -1}, {49, 5, -1}}}}};
    raster.lines(behind, {.colour = {0, 0, 0}, .width = 2}, &hiding);
    EXPECT_EQ(raster.colour(10, 5).red, 1.0);
    EXPECT_EQ(raster.colour(45, 5).red, 0.0);
    EXPECT_EQ(painted(hiding), 0);
}

TEST(Raster, ReducingAveragesSquares) {
    Raster raster(4, 2);
    const std::array<Segment, 1> dot{{{{{0.5, 0.5, 0}, {0.5, 0.5, 0}}}}};
    raster.lines(dot, {.colour = {0, 0, 0}, .width = 1});
    const auto bytes = raster.reduced(2);
    ASSERT_EQ(bytes.size(), 6U);
    EXPECT_EQ(bytes[0], 191);  // three of four white
    EXPECT_EQ(bytes[3], 255);
}

}  // namespace
}  // namespace soft::view
