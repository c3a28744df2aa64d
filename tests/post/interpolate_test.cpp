#include "post/interpolate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <span>
#include <vector>

#include "path_samples.hpp"
#include "post/monotone_slopes.hpp"

namespace soft::post {
namespace {

/// A curve in the plane (pressure, growth), both with range 1, so that the metric is Euclidean.
Curve planar(const std::vector<std::array<double, 4>>& points_and_slopes) {
    std::vector<model::Step> steps;
    for (const auto& [x, y, dx, dy] : points_and_slopes) {
        model::Step step;
        step.outputs = {x * 1e-3};
        step.pressure_Pa = y * 1e3;
        step.tangent_outputs = {dx * 1e-3};
        step.tangent_pressure = dy * 1e3;
        steps.push_back(step);
    }
    return make_curve(test::growth, steps);
}

TEST(Hermite, ReproducesACubicExactly) {
    const auto cubic = [](double t) { return 3 - 2 * t + 5 * t * t - 4 * t * t * t; };
    const auto slope = [](double t) { return -2 + 10 * t - 12 * t * t; };
    const Hermite piece{cubic(0), cubic(1), slope(0), slope(1)};
    for (int i = 0; i <= 20; ++i) EXPECT_NEAR(piece(i / 20.0), cubic(i / 20.0), 1e-15);
}

TEST(Hermite, SplitsWhereTheSlopeVanishes) {
    const Hermite piece{0, 0, 1, 1};  // t (1 - t)(1 - 2 t)
    const auto ends = piece.monotone_pieces();
    ASSERT_EQ(ends.size(), 4u);
    EXPECT_NEAR(ends[1], (3 - std::sqrt(3.0)) / 6, 1e-15);
    EXPECT_NEAR(ends[2], (3 + std::sqrt(3.0)) / 6, 1e-15);
}

// A path with the goal 130 mm ends at 130 mm up to rounding, slightly before or beyond it: the crossing must be found once.
TEST(Crossings, FindTheGoalOfThePathOnce) {
    for (const double end : {129.99999999999997, 130.0, 130.00000000000003}) {
        const auto curve = planar({{0, 0, 1, 1}, {60, 0.5, 1, 1}, {end, 1, 1, 1}});
        EXPECT_EQ(Path(curve).crossings(test::index_of(curve, "growth"), 130).size(), 1u) << end;
        EXPECT_TRUE(Path(curve).crossings(test::index_of(curve, "growth"), 130.001).empty());
    }
}

void expect_within_neighbours(const std::vector<double>& s, const std::vector<double>& q) {
    const auto slopes = monotone_slopes(s, q);
    for (std::size_t i = 0; i + 1 < s.size(); ++i) {
        const double ds = s[i + 1] - s[i];
        const Hermite piece{q[i], q[i + 1], slopes[i] * ds, slopes[i + 1] * ds};
        for (int k = 1; k < 50; ++k) {
            EXPECT_GE(piece(k / 50.0), std::min(q[i], q[i + 1]) - 1e-14);
            EXPECT_LE(piece(k / 50.0), std::max(q[i], q[i + 1]) + 1e-14);
        }
    }
}

TEST(MonotoneSlopes, KeepTheInterpolantBetweenNeighbours) {
    expect_within_neighbours({0, 0.1, 0.5, 0.6, 2, 2.1}, {1, 1.01, 1.02, 3, 3, 2.5});
    std::mt19937 engine(1);  // same numbers on every platform
    const auto up_to_1 = [&] { return static_cast<double>(engine()) / std::mt19937::max(); };
    for (const std::size_t rows : {2u, 3u, 4u, 5u, 9u})
        for (int round = 0; round < 100; ++round) {
            std::vector<double> s{0}, q{up_to_1()};
            while (s.size() < rows) s.push_back(s.back() + 0.01 + up_to_1()), q.push_back(std::pow(up_to_1(), 3));
            expect_within_neighbours(s, q);
            std::sort(q.begin(), q.end());
            expect_within_neighbours(s, q);
        }
}

TEST(MonotoneSlopes, AreExactForAParabolaAndAtTheEndsForACubic) {
    const std::vector<double> s{1, 1.1, 1.35, 1.6,
                                2.5};  // increasing; neighbouring secants differ by less than a factor of three
    std::vector<double> squares, cubes;
    for (const double x : s) squares.push_back(x * x), cubes.push_back(x * x * x);
    for (std::size_t i = 0; i < s.size(); ++i) EXPECT_NEAR(monotone_slopes(s, squares)[i], 2 * s[i], 1e-13);
    EXPECT_NEAR(monotone_slopes(s, cubes).front(), 3, 1e-12);
    EXPECT_NEAR(monotone_slopes(s, cubes).back(), 3 * 2.5 * 2.5, 1e-12);
    const std::span<const double> three(s.data(), 3), values(squares.data(), 3);
    EXPECT_NEAR(monotone_slopes(three, values).back(), 2 * 1.35, 1e-13);
}

// Values that are not monotonic near an end may have a kink; a cubic would oscillate there.
TEST(MonotoneSlopes, UseTheParabolaIfTheValuesAreNotMonotonic) {
    const std::vector<double> s{0, 1, 2, 3}, q{4, 2, 0, 1};  // the parabola through the last three: 1.5 x^2 - 6.5 x + 7
    EXPECT_NEAR(monotone_slopes(s, q).back(), 2.5, 1e-13);
}

TEST(Path, PassesThroughEveryRow) {
    const Curve curve = make_curve(test::growth, test::sphere_path(9, 3));
    const Path path(curve);
    const auto s = path.row_parameters();
    ASSERT_EQ(s.size(), 9u);
    for (std::size_t row = 0; row < 9; ++row) {
        const auto values = path.at(s[row]);
        for (std::size_t i = 0; i < curve.columns.size(); ++i) EXPECT_EQ(values[i], curve.columns[i].values[row]);
    }
}

TEST(Path, ReproducesARotatedParabolaExactly) {
    // (t, t^2) rotated by 30 degrees, so that neither coordinate is a quadratic function of the other
    const double c = std::cos(std::numbers::pi / 6), s = std::sin(std::numbers::pi / 6);
    const auto x = [&](double u, double v) { return c * u - s * v; };
    const auto y = [&](double u, double v) { return s * u + c * v; };
    std::vector<std::array<double, 4>> rows;
    for (const double t : {0.0, 0.4, 0.7, 1.2}) rows.push_back({x(t, t * t), y(t, t * t), x(1, 2 * t), y(1, 2 * t)});
    const Curve curve = planar(rows);
    const Path path(curve);
    for (int i = 0; i <= 100; ++i) {
        const auto row = path.at(path.length() * i / 100);
        const double px = row[test::index_of(curve, "growth")], py = row[test::index_of(curve, "pressure")];
        const double t = c * px + s * py;
        EXPECT_NEAR(c * py - s * px, t * t, 1e-13);
    }
}

TEST(Path, PassesAnInflectionWithoutALoop) {
    std::vector<std::array<double, 4>> rows;
    for (const double t : {-1.0, 0.5, 1.0}) rows.push_back({t, t * t * t, 1, 3 * t * t});
    const Curve curve = planar(rows);
    const Path path(curve);
    double last = -2;
    for (int i = 0; i <= 100; ++i) {
        const double x = path.at(path.length() * i / 100)[test::index_of(curve, "growth")];
        EXPECT_GT(x, last);
        last = x;
    }
}

double worst_pressure_error(int rows) {
    const Curve curve = make_curve(test::growth, test::sphere_path(rows, 3));
    const Path path(curve);
    const std::size_t g = test::index_of(curve, "growth"), p = test::index_of(curve, "pressure");
    double worst = 0;
    for (int i = 1; i <= 1000; ++i) {
        const auto row = path.at(path.length() * i / 1000);
        worst = std::max(worst, std::abs(row[p] * 1e3 - test::sphere_pressure_Pa(1 + row[g] / 1e3)) / 0.816424);
    }
    return worst;
}

TEST(Path, ConvergesToTheThickSphereWithFourthOrder) {
    EXPECT_LT(worst_pressure_error(11), 6e-4);  // the first interval covers 60 % of the pressure range
    EXPECT_LT(worst_pressure_error(41), 4e-6);
    const double order = std::log2(worst_pressure_error(41) / worst_pressure_error(81));
    EXPECT_GT(order, 3.7);
    EXPECT_LT(order, 4.5);
}

TEST(Path, FindsTheLimitPressureBetweenTheRows) {
    const Curve curve = make_curve(test::growth, test::sphere_path(13, 3));
    const Path path(curve);
    EXPECT_NEAR(path.range(test::index_of(curve, "pressure")).highest, 0.816424e-3, 0.816424e-3 * 5e-5);
    EXPECT_GT(path.range(test::index_of(curve, "pressure")).highest,
              *std::max_element(curve.find("pressure")->values.begin(), curve.find("pressure")->values.end()));
}

/// Loading along p = 2 x - x^2 to x = 0.8 in stage 0, then unloading along p = 1.5 x^2 in stage 1, as with another pressure supply. Each
/// stage ends with a row, and each row has the direction of its own stage.
std::vector<model::Step> two_stages(int rows_per_stage) {
    std::vector<model::Step> steps;
    const auto add = [&](int stage, double x, double p, double dx, double dp) {
        model::Step step;
        step.stage = stage;
        step.outputs = {x};
        step.pressure_Pa = p;
        step.tangent_outputs = {dx};
        step.tangent_pressure = dp;
        steps.push_back(step);
    };
    constexpr double turn = 0.8;
    for (int i = 0; i <= rows_per_stage; ++i) {
        const double x = turn * i / rows_per_stage;
        add(0, x, 2 * x - x * x, 1, 2 - 2 * x);
    }
    constexpr double slope = (2 * turn - turn * turn) / (turn * turn);  // both curves meet at x = turn
    for (int i = 1; i <= rows_per_stage; ++i) {
        const double x = turn * (1 - static_cast<double>(i) / rows_per_stage);
        add(1, x, slope * x * x, -1, -2 * slope * x);
    }
    return steps;
}

Curve two_stage_curve(int rows_per_stage) {
    model::Case model = test::growth;
    model.path.stages.resize(2);
    return make_curve(model, two_stages(rows_per_stage));
}

/// Largest error of the pressure in the first interval of the second stage, relative to the exact curve.
double error_after_stage_change(int rows_per_stage) {
    const Curve curve = two_stage_curve(rows_per_stage);
    const Path path(curve);
    const auto s = path.row_parameters();
    const auto turn = static_cast<std::size_t>(rows_per_stage);
    double worst = 0;
    for (int k = 1; k < 50; ++k) {
        const auto row = path.at(s[turn] + (s[turn + 1] - s[turn]) * k / 50);
        const double x = row[test::index_of(curve, "growth")] / 1e3, p = row[test::index_of(curve, "pressure")] * 1e3;
        worst = std::max(worst, std::abs(p - 1.5 * x * x));
    }
    return worst;
}

TEST(Path, IgnoresTheDirectionOfThePreviousStageAfterAStageChange) {
    const Curve curve = two_stage_curve(4);
    const Path path(curve);
    // no coordinate overshoots the stage change, as it would with the previous direction
    EXPECT_EQ(path.range(test::index_of(curve, "growth")).highest, 800);
    EXPECT_EQ(path.range(test::index_of(curve, "pressure")).highest, curve.find("pressure")->values[4]);
    EXPECT_EQ(path.crossings(test::index_of(curve, "growth"), 700).size(), 2u);
    EXPECT_EQ(path.crossings(test::index_of(curve, "growth"), 800).size(), 1u);
}

TEST(Path, ConvergesWithThirdOrderAfterAStageChange) {
    constexpr double step = 0.1, straight = 1.5 * step * step / 4;  // error of the chord
    EXPECT_LT(error_after_stage_change(8), straight / 10);
    const double order = std::log2(error_after_stage_change(8) / error_after_stage_change(16));
    EXPECT_GT(order, 2.7);
}

TEST(Path, AssignsTheIntervalAfterAStageChangeToTheNextStage) {
    const Curve curve = two_stage_curve(4);
    const Path path(curve);
    const auto s = path.row_parameters();
    const std::size_t stage = test::index_of(curve, "stage");
    EXPECT_EQ(path.at(s[3] * 0.5 + s[4] * 0.5)[stage], 1);
    EXPECT_EQ(path.at(s[4])[stage], 1);
    EXPECT_EQ(path.at(s[4] * 0.999 + s[5] * 0.001)[stage], 2);
}

TEST(Path, IsStraightAfterAStageChangeIfTheDirectionDoesNotFit) {
    auto steps = two_stages(4);
    steps[5].tangent_outputs = {1};  // away from the stage change
    steps[5].tangent_pressure = 0.1;
    model::Case model = test::growth;
    model.path.stages.resize(2);
    const Curve curve = make_curve(model, steps);
    const Path path(curve);
    const auto s = path.row_parameters();
    const auto middle = path.at((s[4] + s[5]) / 2);
    for (const char* quantity : {"growth", "pressure"}) {
        const auto& values = curve.find(quantity)->values;
        EXPECT_NEAR(middle[test::index_of(curve, quantity)], (values[4] + values[5]) / 2, 1e-12);
    }
}

/// Loading along p = 2 x - x^2 to x = 0.8, where an obstacle stops the output: the row there has the direction after it.
double error_before_kink(int rows, bool is_known) {
    auto steps = two_stages(rows);
    const auto kink = static_cast<std::size_t>(rows);
    steps.resize(kink + 1);
    steps[kink].tangent_outputs = {0.01};
    steps[kink].tangent_pressure = 1;
    for (int i = 1; i <= 3; ++i) {
        steps.push_back(steps[kink]);
        steps.back().outputs[0] += 0.001 * i;
        steps.back().pressure_Pa += 0.1 * i;
    }
    model::PathEnd end;
    end.first_contacts.emplace_back().at.step = rows;
    const Curve curve = make_curve(test::growth, steps, is_known ? end : model::PathEnd{});
    const Path path(curve);
    const auto s = path.row_parameters();
    double worst = 0;
    for (int k = 1; k < 50; ++k) {
        const auto row = path.at(s[kink - 1] + (s[kink] - s[kink - 1]) * k / 50);
        const double x = row[test::index_of(curve, "growth")] / 1e3, p = row[test::index_of(curve, "pressure")] * 1e3;
        worst = std::max(worst, std::abs(p - (2 * x - x * x)));
    }
    return worst;
}

TEST(Path, ConvergesWithThirdOrderBeforeAFirstContact) {
    const double coarse = error_before_kink(8, true), fine = error_before_kink(16, true);
    EXPECT_LT(coarse, 2e-4);
    EXPECT_GT(error_before_kink(8, false), 10 * coarse);
    EXPECT_GT(std::log2(coarse / fine), 2.7);
}

/// Derivatives along the path jump where a stage begins. A stage ends where the solver meets its goal, up to rounding.
TEST(Path, ExtrapolatesColumnsThatJumpIntoTheFirstIntervalOfAStage) {
    const auto curve_of = [](std::size_t rows) {
        Curve curve;
        const auto add = [&](const char* name, Role role, const std::vector<double>& values) {
            Column column{.name = name, .quantity = name, .unit = ""};
            column.role = role;
            column.values.assign(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rows));
            curve.columns.push_back(std::move(column));
        };
        add("x", Role::coordinate, {0, 1, 2, 3, 4});
        add("stage", Role::stage, {1, 1, 1, 2, 2});
        add("slope", Role::dependent, {1, 1, 1, 5, 6});
        curve.columns.back().jumps = true;
        return curve;
    };
    const auto slope_at = [&](std::size_t rows, double x) {
        const Curve curve = curve_of(rows);
        const Path path(curve);
        return path.at(x / 2 * path.row_parameters()[2])[2];
    };
    for (const double x : {0.5, 1.5, 2.0, 2 + 1e-9}) EXPECT_NEAR(slope_at(5, x), 1, 1e-12) << x;
    EXPECT_NEAR(slope_at(5, 2.5), 4.5, 1e-9);
    EXPECT_NEAR(slope_at(5, 3), 5, 1e-9);
    EXPECT_NEAR(slope_at(5, 3.5), 5.5, 1e-9);
    EXPECT_NEAR(slope_at(4, 2.5), 5, 1e-9) << "the only row of its stage";
}

/// The row at a first contact has the derivatives after it.
TEST(Path, ExtrapolatesColumnsThatJumpIntoTheIntervalBeforeAKink) {
    Curve curve;
    const auto add = [&](const char* name, Role role, std::vector<double> values) {
        Column& column = curve.columns.emplace_back();
        column.name = column.quantity = name;
        column.role = role;
        column.values = std::move(values);
    };
    add("x", Role::coordinate, {0, 1, 2, 3, 4});
    add("slope", Role::dependent, {1, 2, 30, 31, 32});
    curve.columns.back().jumps = true;
    curve.kinks = {2};
    const Path path(curve);
    const auto slope_at = [&](double x) { return path.at(x / 4 * path.length())[1]; };
    for (const double x : {0.5, 1.0, 1.5, 1.9}) EXPECT_NEAR(slope_at(x), 1 + x, 1e-9) << x;
    for (const double x : {2.0, 2.5, 3.5, 4.0}) EXPECT_NEAR(slope_at(x), 28 + x, 1e-9) << x;
    curve.kinks = {1};
    EXPECT_NEAR(Path(curve).at(0.5 / 4 * path.length())[1], 1.5, 1e-9) << "a single row before the kink";
}

TEST(Path, OmitsAStageInWhichNothingChanges) {
    auto steps = two_stages(4);
    steps.insert(steps.begin() + 5, steps[4]);
    steps[5].stage = 1;
    for (std::size_t i = 6; i < steps.size(); ++i) steps[i].stage = 2;
    model::Case model = test::growth;
    model.path.stages.resize(3);
    const Curve with_hold = make_curve(model, steps), without = two_stage_curve(4);
    const Path a(with_hold), b(without);
    ASSERT_EQ(a.row_parameters().size(), 9u);
    for (int i = 0; i <= 40; ++i)
        EXPECT_EQ(a.at(a.length() * i / 40)[test::index_of(with_hold, "pressure")],
                  b.at(b.length() * i / 40)[test::index_of(without, "pressure")]);
}

/// On the arc (cos a, sin a) the third column is a itself. One of the four directions is wrong by 20 degrees, as can happen near a
/// bifurcation, so that the speeds of its interval differ by a factor of two.
TEST(Path, InterpolatesColumnsWithoutSlopesInTheProgressAlongThePath) {
    Curve curve;
    for (const char* name : {"x", "y", "a"}) {
        Column& column = curve.columns.emplace_back();
        column.name = column.quantity = name;
        column.role = *name == 'a' ? Role::dependent : Role::coordinate;
    }
    for (int row = 0; row < 4; ++row) {
        const double a = 0.4 * row, direction = a + (row == 2 ? 0.35 : 0);
        curve.columns[0].values.push_back(std::cos(a));
        curve.columns[1].values.push_back(std::sin(a));
        curve.columns[2].values.push_back(a);
        curve.columns[0].slopes.push_back(-std::sin(direction));
        curve.columns[1].slopes.push_back(std::cos(direction));
    }
    const Path path(curve);
    for (double s = 0; s < path.length(); s += path.length() / 50) {
        const std::vector<double> at = path.at(s);
        EXPECT_NEAR(at[2], std::atan2(at[1], at[0]), 0.02) << s;  // the error of the wrong direction has this size
    }
}

}  // namespace
}  // namespace soft::post
