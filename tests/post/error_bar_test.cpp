#include "post/error_bar.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace soft::post {
namespace {

/// A balloon's pressure over its elongation: a limit point at m = 1, p = 1.
double exact(double m) { return m * std::exp(1 - m); }
double slope(double m) { return (1 - m) * std::exp(1 - m); }

using Error = std::function<double(double m, double h)>;  ///< of the load at equal measure

/// Rows of a path whose meshes have cells of size h = 1, 1/2, 1/4.
std::vector<LevelRow> rows_of(const Error& error, double last = 0.8, int count = 40) {
    std::vector<LevelRow> rows;
    for (int i = 0; i <= count; ++i) {
        const double m = last * i / count;
        LevelRow row{{}, {slope(m), 1}};
        for (std::size_t k = 0; k < 3; ++k)
            row.levels[k] = {exact(m) + error(m, std::ldexp(1.0, -static_cast<int>(k))), m};
        rows.push_back(row);
    }
    return rows;
}

struct Quality {
    double least = 1e300, largest = 0;  ///< bar over true error, row by row
    double width = 0;                   ///< root mean squares of the bars over that of the errors
};

Quality quality(const std::vector<LevelRow>& rows, const Error& error, int order = 2) {
    const std::vector<ErrorBar> bars = error_bars(rows, order);
    Quality result;
    double bar2 = 0, error2 = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const double truth = std::abs(error(rows[i].levels[2].measure, 0.25)), bar = bars[i].load.value();
        result.least = std::min(result.least, bar / truth);
        result.largest = std::max(result.largest, bar / truth);
        bar2 += bar * bar;
        error2 += truth * truth;
    }
    result.width = std::sqrt(bar2 / error2);
    return result;
}

/// Errors grow with the load and bend on the way.
double shape(double m) { return 1e-3 * m * (1 + 0.5 * m); }

TEST(ErrorBar, CoversOneRateAndIsAtMostThreeTimesTooWide) {
    for (const double rate : {1.0, 1.1, 1.2, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0})
        for (const double sign : {1.0, -1.0}) {
            const Error error = [=](double m, double h) { return sign * shape(m) * std::pow(h, rate); };
            const Quality q = quality(rows_of(error), error);
            EXPECT_GT(q.least, 1.3) << rate;
            EXPECT_LT(q.largest, 3) << rate;
        }
}

TEST(ErrorBar, KnowsThatFirstOrderCellsHaveRateTwoAtBest) {
    for (const double rate : {1.0, 1.3, 1.6, 2.0}) {
        const Error error = [=](double m, double h) { return shape(m) * std::pow(h, rate); };
        const Quality q = quality(rows_of(error), error, 1);
        EXPECT_GT(q.least, 1.3) << rate;
        EXPECT_LT(q.largest, 3) << rate;
    }
}

TEST(ErrorBar, OfASmoothPartWithACornersIsAtLeastTwoThirdsOfTheError) {
    for (const double corner : {1.0, 1.1, 1.2})
        for (double share = 1e-4; share < 100; share *= 2) {  // of the corner's part on the coarse mesh
            const Error error = [=](double m, double h) {
                return shape(m) * (std::pow(h, 4) + share * std::pow(h, corner));
            };
            const Quality q = quality(rows_of(error), error);
            EXPECT_GT(q.least, share < 5e-3 || share > 2 ? 1.0 : 2 / 3.0) << corner << ' ' << share;
            EXPECT_LT(q.largest, 3) << corner << ' ' << share;
        }
}

/// The two parts have opposite signs and different shapes: differences pass through zero at other places than the error.
TEST(ErrorBar, OfPartsOfOppositeSignIsAtLeastHalfTheError) {
    for (const double corner : {1.0, 1.2})
        for (double share = 0.1; share < 3; share *= 1.5) {
            const Error error = [=](double m, double h) {
                return shape(m) * ((1 - 1.5 * m) * std::pow(h, 4) - share * (1 + m) * std::pow(h, corner));
            };
            const Quality q = quality(rows_of(error), error);
            EXPECT_GT(q.least, 0.5) << corner << ' ' << share;
            EXPECT_LT(q.width, 3) << corner << ' ' << share;
        }
}

/// An error that passes through zero does so on all meshes; there no bar can be narrow against it.
TEST(ErrorBar, GoesOnWhereTheErrorPassesThroughZero) {
    for (const double rate : {1.0, 2.0, 4.0}) {
        const Error error = [=](double m, double h) { return 1e-3 * m * std::cos(5 * m) * std::pow(h, rate); };
        const std::vector<LevelRow> rows = rows_of(error);
        const Quality q = quality(rows, error);
        EXPECT_GT(q.least, 1.2) << rate;
        EXPECT_LT(q.width, 3) << rate;
        for (const ErrorBar& bar : error_bars(rows, 2)) EXPECT_LT(bar.load.value(), 3.2e-3 * std::pow(0.25, rate));
    }
}

TEST(ErrorBar, TakesTheLastDifferenceWhereTheRateIsNotMeasured) {
    const Error error = [](double m, double h) {
        return h == 1 ? 0.0 : shape(m) * h;
    };  // the coarse mesh hits by chance
    const std::vector<LevelRow> rows = rows_of(error);
    const std::vector<ErrorBar> bars = error_bars(rows, 2);
    for (std::size_t i = 1; i < rows.size(); ++i)
        EXPECT_NEAR(bars[i].load.value(), 1.4 * shape(rows[i].levels[2].measure) / 4, 0.03 * bars[i].load.value());
}

TEST(ErrorBar, OfACaseThatAnyMeshHoldsIsTheSolversTolerance) {
    const std::vector<LevelRow> rows = rows_of([](double, double) { return 0.0; });
    for (const ErrorBar& bar : error_bars(rows, 2)) {
        EXPECT_LE(bar.load.value(), 10 * solved_to);
        EXPECT_LE(bar.measure.value(), 10 * solved_to);
    }
    EXPECT_GT(error_bars(rows, 2)[5].load.value(), 0);
}

/// The same errors with every mesh at another point of its curve.
TEST(ErrorBar, DoesNotMindWhereOnTheirCurvesTheMeshesStand) {
    const Error error = [](double m, double h) { return shape(m) * h * h; };
    const std::vector<LevelRow> rows = rows_of(error);
    std::vector<LevelRow> moved = rows;
    for (LevelRow& row : moved)
        for (std::size_t k = 0; k < 2; ++k) {
            const double m = row.levels[2].measure * (1 + 0.01 * static_cast<double>(2 - k));
            row.levels[k] = {exact(m) + error(m, std::ldexp(1.0, -static_cast<int>(k))), m};
        }
    const std::vector<ErrorBar> at_equal = error_bars(rows, 2), elsewhere = error_bars(moved, 2);
    for (std::size_t i = 1; i < rows.size(); ++i)
        EXPECT_NEAR(elsewhere[i].load.value() / at_equal[i].load.value(), 1, 0.6) << i;  // the shift's square is left
}

TEST(ErrorBar, OfTheMeasureIsThatOfTheLoadOverTheSlope) {
    const Error error = [](double m, double h) { return 0.01 * shape(m) * h * h; };
    const std::vector<LevelRow> rows = rows_of(error, 0.6);
    const std::vector<ErrorBar> bars = error_bars(rows, 2);
    for (std::size_t i = 1; i < rows.size(); ++i)
        EXPECT_NEAR(bars[i].measure.value() * slope(rows[i].levels[2].measure) / bars[i].load.value(), 1, 0.01);
}

/// At the maximum p = 1 - (m - 1)^2 / 2: a load too high by c moves m by sqrt(2 c).
TEST(ErrorBar, StaysFiniteAtALimitPointOfTheLoad) {
    const Error error = [](double m, double h) { return shape(m) * h * h; };
    const std::vector<LevelRow> rows = rows_of(error, 1.6, 64);
    const std::vector<ErrorBar> bars = error_bars(rows, 2);
    const std::size_t top = 40;
    ASSERT_NEAR(slope(rows[top].levels[2].measure), 0, 1e-12);
    EXPECT_NEAR(bars[top].measure.value() / std::sqrt(2 * bars[top].load.value()), 1, 0.1);
    for (const ErrorBar& bar : bars) EXPECT_LT(bar.measure.value(), 2.2 * std::sqrt(2 * bars[top].load.value()));
}

TEST(ErrorBar, StaysFiniteWhereTheMeasureTurnsBack) {
    std::vector<LevelRow> rows;  // a quarter of a circle and on: m = sin t, p = 1 - cos t + error
    for (int i = 0; i <= 60; ++i) {
        const double t = 2.4 * i / 60;
        LevelRow row{{}, {std::sin(t), std::cos(t)}};
        for (std::size_t k = 0; k < 3; ++k)
            row.levels[k] = {1 - std::cos(t), std::sin(t) + 1e-3 * t * std::pow(0.25, static_cast<double>(k))};
        rows.push_back(row);
    }
    for (const ErrorBar& bar : error_bars(rows, 2)) {
        EXPECT_LT(bar.load.value(), 0.1);
        EXPECT_LT(bar.measure.value(), 0.1);
    }
}

TEST(ErrorBar, LeavesOutWhatAPlateauCannotSay) {
    std::vector<LevelRow> rows;
    for (int i = 0; i <= 10; ++i) {
        LevelRow row{{}, {i == 0 ? 1.0 : 0.0, i == 0 ? 0.0 : 1.0}};
        for (std::size_t k = 0; k < 3; ++k)
            row.levels[k] = {i == 0 ? 0.0 : 1 + std::pow(0.25, 3.0 + static_cast<double>(k)), 0.1 * i};
        rows.push_back(row);
    }
    const std::vector<ErrorBar> bars = error_bars(rows, 2);
    EXPECT_FALSE(bars[5].measure);
    EXPECT_TRUE(bars[5].load);
}

TEST(ErrorBar, FindsTangentsFromTheRowsWhereThereAreNone) {
    const Error error = [](double m, double h) { return shape(m) * h; };
    std::vector<LevelRow> rows = rows_of(error);
    const std::vector<ErrorBar> known = error_bars(rows, 2);
    for (LevelRow& row : rows) row.tangent = {0, 0};
    const std::vector<ErrorBar> found = error_bars(rows, 2);
    for (std::size_t i = 1; i + 1 < rows.size(); ++i)
        EXPECT_NEAR(found[i].load.value() / known[i].load.value(), 1, 0.02) << i;
}

TEST(ErrorBar, DoesNotDependOnUnits) {
    const Error error = [](double m, double h) { return shape(m) * h; };
    std::vector<LevelRow> rows = rows_of(error);
    const std::vector<ErrorBar> before = error_bars(rows, 2);
    for (LevelRow& row : rows) {
        for (PathPoint& point : row.levels) point = {26e3 * point.load, -0.13 * point.measure};
        row.tangent = {26e3 * row.tangent.load, -0.13 * row.tangent.measure};
    }
    const std::vector<ErrorBar> after = error_bars(rows, 2);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_NEAR(after[i].load.value(), 26e3 * before[i].load.value(), 26e3 * 1e-12);
        EXPECT_NEAR(after[i].measure.value(), 0.13 * before[i].measure.value(), 0.13 * 1e-12);
    }
}

TEST(ErrorBar, RefusesAnotherOrder) {
    EXPECT_THROW((void)error_bars({}, 3), std::logic_error);
    EXPECT_TRUE(error_bars({}, 2).empty());
}

}  // namespace
}  // namespace soft::post
