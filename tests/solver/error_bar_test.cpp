#include "solver/error_bar.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace soft::solver {
namespace {

/// A balloon's pressure over its elongation: a limit point at m = 1, p = 1.
double exact(double m) { return m * std::exp(1 - m); }
double slope(double m) { return (1 - m) * std::exp(1 - m); }

using ErrorOfRow = std::function<double(double m, double h)>;  ///< of the load at equal measure

enum class Levels { two, three };

/// Rows of a path reported on cells of size h = 1, judged by h = 1/2, and with three levels by h = 2 as well.
std::vector<LevelRow> rows_of(const ErrorOfRow& error, Levels levels = Levels::two, double last = 0.8, int count = 40) {
    std::vector<LevelRow> rows;
    for (int i = 0; i <= count; ++i) {
        const double m = last * i / count;
        const auto on = [&](double h) { return CurvePoint{exact(m) + error(m, h), m}; };
        LevelRow row{on(1), on(0.5), {}, {slope(m), 1}};
        if (levels == Levels::three) row.before = on(2);
        rows.push_back(row);
    }
    return rows;
}

struct Quality {
    double least = 1e300, largest = 0;  ///< bar over true error, row by row
    double width = 0;                   ///< root mean squares of the bars over that of the errors
};

Quality quality(const std::vector<LevelRow>& rows, const ErrorOfRow& error) {
    const std::vector<ErrorBar> bars = error_bars(rows);
    Quality result;
    double bar2 = 0, error2 = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const double truth = std::abs(error(rows[i].reported.measure, 1)), bar = bars[i].load;
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

TEST(ErrorBar, OfTwoMeshesCoversEveryRateAndIsAtMostTwiceTooWide) {
    for (const double rate : {0.9, 1.0, 1.5, 2.0, 3.0, 4.0})
        for (const double sign : {1.0, -1.0}) {
            const ErrorOfRow error = [=](double m, double h) { return sign * shape(m) * std::pow(h, rate); };
            const Quality q = quality(rows_of(error), error);
            EXPECT_GT(q.least, 1.02) << rate;
            EXPECT_LT(q.largest, 2.15) << rate;
        }
}

TEST(ErrorBar, IsNarrowedByTheMeasuredRate) {
    for (const double rate : {1.0, 2.0, 4.0}) {
        const ErrorOfRow error = [=](double m, double h) { return shape(m) * std::pow(h, rate); };
        const Quality q = quality(rows_of(error, Levels::three), error);
        EXPECT_GT(q.least, 1.04) << rate;
        EXPECT_LT(q.largest, rate == 4.0 ? 1.3 : 1.85) << rate;
    }
}

/// A fast and a slow part: the rate still falls from level to level, so that the measured one is too high.
TEST(ErrorBar, CoversASmoothPartWithACorners) {
    for (const double corner : {1.0, 1.2})
        for (double share = 1e-3; share < 100; share *= 2)
            for (const Levels levels : {Levels::two, Levels::three}) {
                const ErrorOfRow error = [=](double m, double h) {
                    return shape(m) * (std::pow(h, 4) + share * std::pow(h, corner));
                };
                const Quality q = quality(rows_of(error, levels), error);
                EXPECT_GT(q.least, 1.0) << corner << ' ' << share;
                EXPECT_LT(q.width, 3) << corner << ' ' << share;
            }
}

/// An error that passes through zero does so on all meshes; there no bar can be narrow against it.
TEST(ErrorBar, GoesOnWhereTheErrorPassesThroughZero) {
    for (const double rate : {1.0, 2.0, 4.0})
        for (const Levels levels : {Levels::two, Levels::three}) {
            const ErrorOfRow error = [=](double m, double h) { return 1e-3 * m * std::cos(5 * m) * std::pow(h, rate); };
            const Quality q = quality(rows_of(error, levels), error);
            EXPECT_GT(q.least, 1.0) << rate;
            EXPECT_LT(q.width, 3) << rate;
        }
}

/// Two parts of opposite sign and different shape, which may nearly cancel in the difference over a whole neighbourhood: the
/// known limit of two meshes.
TEST(ErrorBar, OfPartsThatNearlyCancelIsAtLeastHalfTheError) {
    for (double share = 0.1; share < 3; share *= 1.5) {
        const ErrorOfRow error = [=](double m, double h) {
            return shape(m) * ((1 - 1.5 * m) * h * h * h * h - share * (1 + m) * h * h);
        };
        const Quality q = quality(rows_of(error), error);
        EXPECT_GT(q.least, 0.5) << share;
        EXPECT_LT(q.width, 3) << share;
    }
}

TEST(ErrorBar, OfACaseThatAnyMeshHoldsIsTheSolversTolerance) {
    const auto bars = error_bars(rows_of([](double, double) { return 0.0; }));
    for (const ErrorBar& bar : bars) {
        EXPECT_LE(bar.load, 10 * solved_to);
        EXPECT_LE(bar.measure, 10 * solved_to);
    }
    EXPECT_GT(bars[5].load, 0);
}

/// The same errors with the finer mesh at another point of its curve.
TEST(ErrorBar, DoesNotMindWhereOnItsCurveTheFinerMeshStands) {
    const ErrorOfRow error = [](double m, double h) { return shape(m) * h * h; };
    const std::vector<LevelRow> rows = rows_of(error);
    std::vector<LevelRow> moved = rows;
    for (LevelRow& row : moved) {
        const double m = row.reported.measure * (1 + 0.002);
        row.finer = {exact(m) + error(m, 0.5), m};
    }
    const auto at_equal = error_bars(rows), elsewhere = error_bars(moved);
    for (std::size_t i = 1; i < rows.size(); ++i)
        EXPECT_NEAR(elsewhere[i].load / at_equal[i].load, 1, 0.01) << i;  // the shift's square is left
}

TEST(ErrorBar, OfTheMeasureIsThatOfTheLoadOverTheSlope) {
    const ErrorOfRow error = [](double m, double h) { return 0.01 * shape(m) * h * h; };
    const std::vector<LevelRow> rows = rows_of(error, Levels::two, 0.6);
    const auto bars = error_bars(rows);
    for (std::size_t i = 1; i < rows.size(); ++i)
        EXPECT_NEAR(bars[i].measure * slope(rows[i].reported.measure) / bars[i].load, 1, 0.01);
}

/// At the maximum p = 1 - (m - 1)^2 / 2: a load too high by c moves m by sqrt(2 c).
TEST(ErrorBar, StaysFiniteAtALimitPointOfTheLoad) {
    const ErrorOfRow error = [](double m, double h) { return shape(m) * h * h; };
    const std::vector<LevelRow> rows = rows_of(error, Levels::two, 1.6, 64);
    const auto bars = error_bars(rows);
    const std::size_t top = 40;
    ASSERT_NEAR(slope(rows[top].reported.measure), 0, 1e-12);
    EXPECT_NEAR(bars[top].measure / std::sqrt(2 * bars[top].load), 1, 0.1);
    for (const ErrorBar& bar : bars) EXPECT_LT(bar.measure, 2.2 * std::sqrt(2 * bars[top].load));
}

/// A load that does not change along the path says nothing of where the measure is.
TEST(ErrorBar, IsAtMostTheWholeRange) {
    std::vector<LevelRow> rows;
    for (int i = 0; i <= 10; ++i) {
        const double m = 0.1 * i, p = i == 0 ? 0 : 1;
        rows.push_back({{p, m}, {p * 0.999, m}, {}, {i == 0 ? 1.0 : 0.0, i == 0 ? 0.0 : 1.0}});
    }
    for (const ErrorBar& bar : error_bars(rows)) EXPECT_LE(bar.measure, 1);
    EXPECT_TRUE(error_bars({}).empty());
}

}  // namespace
}  // namespace soft::solver
