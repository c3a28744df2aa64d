#include "shape_checks.hpp"

#include <gtest/gtest.h>

#include "../contact/contact_samples.hpp"

namespace soft::campaign {
namespace {

using contact::test::Cells;
using contact::test::displacement;
using contact::test::Motion;
using mesh::Point;
namespace bodies = contact::test;

std::string contact(const model::Case& model, const Motion& now, const Motion& before, double allowed_m = 0) {
    return ShapeChecks{model}.contact(displacement(model, now), displacement(model, before), allowed_m);
}

/// Three squares or cubes around an inner corner: its walls meet when every angle about it is scaled by 4/3.
TEST(ShapeChecks, CreaseClosesWhenItsWallsMeet) {
    const auto stretched = [](double factor) {
        return [factor](const Point& X) {
            const double middle = 0.75 * std::numbers::pi,
                         angle = std::remainder(std::atan2(X[1], X[0]) - middle, 2 * std::numbers::pi);
            const double r = std::hypot(X[0], X[1]);
            return Point{r * std::cos(middle + factor * angle), r * std::sin(middle + factor * angle), X[2]};
        };
    };
    for (const int dimension : {2, 3})
        for (const Cells cells : bodies::all_cells) {
            bodies::MeshBuilder builder(dimension);
            for (const auto& [x, y] :
                 {std::pair{bodies::Interval{0, 1}, bodies::Interval{0, 1}}, {{-1, 0}, {0, 1}}, {{-1, 0}, {-1, 0}}})
                builder.add_block(bodies::of_dimension(dimension, bodies::box(x, y, {0, 1})), 1, 1);
            const model::Case model =
                bodies::make_case(bodies::as(cells, builder.take()),
                                  dimension == 2 ? model::Kinematics::plane_strain : model::Kinematics::solid);
            EXPECT_EQ(contact(model, stretched(4 / 3.0 - 1e-6), stretched(1)), "") << dimension;
            EXPECT_NE(contact(model, stretched(4 / 3.0 + 1e-6), stretched(1.3)), "") << dimension;
        }
}

/// The top of two cells, x = 0, 1 and 2. The walls of the crease are parabolas from (0, 0) through (a, -0.1) down to (1, -1) and up again.
/// For a = 3/4 they are vertical at the bottom and touch there, although the chords are far apart.
Motion pinched(double a) {
    return [a](const Point& X) {
        if (X[1] < 1) return X;
        const double s = X[0] < 1 ? X[0] : 2 - X[0];
        const double middle = 4 * s * (1 - s), end = s * (2 * s - 1);
        const double x = a * middle + end;
        return Point{X[0] < 1 ? x : 2 - x, 1 - 0.1 * middle - end, X[2]};
    };
}

TEST(ShapeChecks, CreaseOfCurvedWallsClosesBetweenNodes) {
    for (const int dimension : {2, 3}) {
        const model::Case model =
            bodies::make_case(bodies::block(dimension, bodies::box({0, 2}, {-2, 1}, {0, 1}), {2, 1, 1}, "all"),
                              dimension == 2 ? model::Kinematics::plane_strain : model::Kinematics::solid);
        EXPECT_EQ(contact(model, pinched(0.7499), pinched(0.7)), "") << dimension;
        EXPECT_EQ(contact(model, pinched(0.7501), pinched(0.7)), "a crease closes") << dimension;
    }
}

/// A cell at the axis (x, r) whose upper side is the parabola r(s) through 0, `middle` and 1: it crosses the axis if middle < 1/4. Its x is
/// `tip` at the axis and 1 at the outer end.
Motion curved_side(double middle, double tip) {
    return [=](const Point& X) {
        if (X[0] < 1) return X;
        const double s = X[1];
        return Point{tip * (1 - s) * (1 - 2 * s) + 4 * s * (1 - s) + s * (2 * s - 1),
                     4 * middle * s * (1 - s) + s * (2 * s - 1), 0};
    };
}

TEST(ShapeChecks, CraterAtTheAxisClosesButASpikeDoesNot) {
    const model::Case model = bodies::make_case(bodies::block(2, bodies::box({0, 1}, {0, 1}), {1, 1, 1}, "all"),
                                                model::Kinematics::axisymmetric);
    EXPECT_EQ(contact(model, curved_side(0.2501, 0.5), curved_side(0.3, 0.6)), "");
    EXPECT_EQ(contact(model, curved_side(0.2499, 0.5), curved_side(0.3, 0.6)), "a crease closes");
    EXPECT_EQ(contact(model, curved_side(0.2, 0.5), curved_side(0.3, 0.6)), "a wall crosses a symmetry plane");
    const Motion closed = curved_side(0.2, 0.5);  // r = -0.2 s + 1.2 s^2 is -1/120 at least
    EXPECT_EQ(contact(model, closed, closed, 0.0082), "a wall crosses a symmetry plane");
    EXPECT_EQ(contact(model, closed, closed, 0.0084), "");
    EXPECT_EQ(contact(model, curved_side(0.2499, 2), curved_side(0.3, 1.9)), "");
    EXPECT_EQ(contact(model, curved_side(0.2, 2), curved_side(0.3, 1.9)), "");
}

TEST(ShapeChecks, IgnoresIntersectingSidesOfAnInvertedCell) {
    const model::Case model = bodies::make_case(bodies::block(2, bodies::box({0, 1}, {0, 1}), {1, 1, 1}, "all"),
                                                model::Kinematics::plane_strain);
    const auto sheared = [](double by) {
        return [by](const Point& X) { return Point{X[0], X[1] * (1 - by * X[0]), 0}; };
    };
    EXPECT_EQ(contact(model, sheared(1.5), sheared(0)), "");
}

}  // namespace
}  // namespace soft::campaign
