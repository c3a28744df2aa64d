#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "meshing/outline.hpp"

namespace soft::meshing {
namespace {

using std::numbers::pi;
using Shape = OutlineEdge::Shape;

Loop polygon(const std::vector<PlanePoint>& points) {
    Loop loop;
    for (std::size_t i = 0; i < points.size(); ++i)
        loop.push_back({Shape::line, {points[i], points[(i + 1) % points.size()]}, {"side"}, i + 1});
    return loop;
}

const std::vector<PlanePoint> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
const std::vector<PlanePoint> hole{{1, 1}, {1, 3}, {3, 3}, {3, 1}};

TEST(OutlineArcs, ThreePointsGiveCentreRadiusAndOrientation) {
    for (const double turn : {0.3, 2.0, 4.5, -0.3, -2.0, -4.5}) {
        const auto at = [&](double share) {
            return PlanePoint{3 + 2 * std::cos(0.7 + share * turn), -1 + 2 * std::sin(0.7 + share * turn)};
        };
        const OutlineArc arc = arc_of({Shape::arc, {at(0), at(0.35), at(1)}, {}, 1});
        EXPECT_NEAR(arc.centre[0], 3, 1e-12);
        EXPECT_NEAR(arc.centre[1], -1, 1e-12);
        EXPECT_NEAR(arc.radius_m, 2, 1e-12);
        EXPECT_NEAR(arc.turn_rad, turn, 1e-12);
        EXPECT_NEAR(arc.at(0.35)[0], at(0.35)[0], 1e-12);
    }
}

TEST(OutlineArcs, ContributeToTheArea) {
    // A half disc of radius 2.
    const OutlineEdge arc{Shape::arc, {{2, 0}, {0, 2}, {-2, 0}}, {}, 1}, base{Shape::line, {{-2, 0}, {2, 0}}, {}, 2};
    EXPECT_NEAR(area_m2({arc, base}), 2 * pi, 1e-13);
}

/// Quadratics are reproduced: the tangent (P2 - P0)/2 is exact for evenly spaced points.
TEST(Splines, ReproduceAParabolaBetweenInnerPoints) {
    std::vector<PlanePoint> points;
    for (int i = 0; i <= 5; ++i) points.push_back({1.0 * i, 1.0 * i * i});
    for (double t = 1; t <= 4; t += 0.125) {
        EXPECT_NEAR(spline_at(points, t)[0], t, 1e-13);
        EXPECT_NEAR(spline_at(points, t)[1], t * t, 1e-13);
    }
}

TEST(Splines, InterpolateTheirPointsAndCloseSmoothly) {
    std::vector<PlanePoint> points;
    for (int i = 0; i < 12; ++i) points.push_back({std::cos(2 * pi * i / 12), std::sin(2 * pi * i / 12)});
    points.push_back(points.front());
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_NEAR(spline_at(points, static_cast<double>(i))[1], points[i][1], 1e-15);
    const double h = 1e-6;
    const PlanePoint first = spline_at(points, h), last = spline_at(points, 12 - h);
    EXPECT_NEAR(first[0], last[0], 1e-11);  // the tangent of the circle is vertical there
    EXPECT_NEAR(first[1], -last[1], 1e-11);
}

TEST(Outlines, SquareWithAHoleIsValid) {
    EXPECT_FALSE(fault_of({{polygon(square)}}));
    EXPECT_FALSE(fault_of({{polygon(square), polygon(hole)}}));
    EXPECT_FALSE(fault_of({{polygon(hole), polygon(square)}}));
    EXPECT_NEAR(area_m2(polygon(square)), 16, 1e-15);
}

std::string fault_text(const Outline& outline) {
    const auto fault = fault_of(outline);
    return fault ? std::to_string(fault->row) + ": " + fault->problem : "valid";
}

TEST(Outlines, ErrorsNameTheirRow) {
    EXPECT_EQ(fault_text({{polygon({{0, 0}, {0, 4}, {4, 4}, {4, 0}})}}),
              "1: the outline is clockwise: the solid would lie outside it");
    EXPECT_EQ(fault_text({{polygon({{0, 0}, {4, 4}, {4, 0}, {0, 4}})}}),
              "1: the edge crosses, touches or runs back over the edge of line 3 near (4000, 0) mm");
    EXPECT_EQ(fault_text({{polygon({{0, 0}, {4, 0}, {4, 0}, {4, 4}})}}),
              "2: the point (4000, 0) mm appears twice in a row");
    EXPECT_EQ(fault_text({{polygon({{0, 0}, {4, 0}, {2, 0}, {2, 4}})}}),
              "1: the edge crosses, touches or runs back over the edge of line 2 near (4000, 0) mm");
    EXPECT_EQ(fault_text({{polygon({{0, 0}, {4, 0}})}}),
              "1: the edge crosses, touches or runs back over the edge of line 2 near (4000, 0) mm");
    EXPECT_EQ(fault_text({{polygon(square), polygon({{1, 1}, {3, 1}, {3, 3}, {1, 3}})}}),
              "1: the loop of the hole is counter-clockwise: the solid would lie inside it");
    EXPECT_EQ(fault_text({{polygon(square), polygon({{6, 1}, {6, 3}, {8, 3}, {8, 1}})}}),
              "1: this loop lies outside the largest one");
    EXPECT_EQ(fault_text({{polygon(square), polygon(hole), polygon({{1.5, 1.5}, {1.5, 2}, {2, 2}, {2, 1.5}})}}),
              "1: this loop lies inside another hole");
}

/// A point of one edge that lies on another edge, and an arc that crosses a line.
TEST(Outlines, TouchingAndCurvedEdgesAreDetected) {
    EXPECT_NE(fault_text({{polygon({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}})}}), "valid");
    Loop bulging = polygon(square);
    bulging[2] = {Shape::arc, {{4, 4}, {2, 2.5}, {0, 4}}, {"side"}, 3};
    EXPECT_EQ(fault_text({{bulging}}), "valid");
    bulging[2].points[1] = {2, -1};
    EXPECT_NE(fault_text({{bulging}}), "valid");
}

}  // namespace
}  // namespace soft::meshing
