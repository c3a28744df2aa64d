#include "solver/line_search.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace soft::solver {
namespace {

using model::LineSearch;

// One spring with force atan(x): Newton's method overshoots where |x| > 1.392.
struct Arctangent {
    double x, dx = -std::atan(x) * (1.0 + x * x);
    int trials = 0;
    Trial operator()(double length) {
        ++trials;
        const double force = std::atan(x + length * dx);
        return {true, std::abs(force), 1e-12, force * dx};
    }
    [[nodiscard]] SearchStart start() const { return {std::abs(std::atan(x)), 1.0, std::atan(x) * dx}; }
};

TEST(LineSearch, BacktrackingHalvesUntilTheResidualFalls) {
    Arctangent spring{3.0};
    const auto found = search(LineSearch::backtracking, spring.start(), std::ref(spring));
    EXPECT_EQ(found.end, SearchEnd::found);
    EXPECT_LT(found.trial.residual, std::atan(3.0));
    EXPECT_EQ(found.length, std::exp2(-found.halvings));
    EXPECT_GT(found.halvings, 0);
}

TEST(LineSearch, SecantFindsTheZeroOfTheResidualAlongTheCorrection) {
    for (const double x : {3.0, 6.0}) {
        Arctangent spring{x};
        const auto found = search(LineSearch::secant, spring.start(), std::ref(spring));
        EXPECT_EQ(found.end, SearchEnd::found);
        EXPECT_LE(std::abs(found.trial.slope), 0.5 * std::abs(spring.start().slope));
    }
}

// Hardening: the first correction is too short, g keeps its sign and the zero lies beyond 1.
TEST(LineSearch, SecantGoesBeyondTheWholeCorrection) {
    const auto force = [](double length) { return Trial{true, std::abs(length - 2.5), 0.0, length - 2.5}; };
    const auto found = search(LineSearch::secant, {2.5, 1.0, -2.5}, force);
    EXPECT_NEAR(found.length, 2.5, 1e-12);
}

TEST(LineSearch, NoneTakesTheWholeCorrection) {
    Arctangent spring{3.0};
    const auto found = search(LineSearch::none, spring.start(), std::ref(spring));
    EXPECT_EQ(found.length, 1.0);
    EXPECT_GT(found.trial.residual, 0.0);
    EXPECT_EQ(spring.trials, 1);
}

TEST(LineSearch, EveryMethodKeepsTheJacobianPositive) {
    const auto inverts = [](double length) { return Trial{length < 0.3, 1.0 - length, 0.0, -(1.0 - length)}; };
    for (const auto kind : {LineSearch::backtracking, LineSearch::secant, LineSearch::none}) {
        const auto found = search(kind, {1.0, 1.0, -1.0}, inverts);
        EXPECT_EQ(found.end, SearchEnd::found);
        EXPECT_LT(found.length, 0.3);
        EXPECT_TRUE(found.trial.admissible);
    }
    const auto never = [](double) { return Trial{.admissible = false}; };
    EXPECT_EQ(search(LineSearch::none, {1.0, 1.0, -1.0}, never).end, SearchEnd::inverted);
}

TEST(LineSearch, BacktrackingReportsNoDescent) {
    const auto rises = [](double length) { return Trial{true, 1.0 + length, 0.0, 0.0}; };
    EXPECT_EQ(search(LineSearch::backtracking, {1.0, 1.0, 0.0}, rises).end, SearchEnd::no_descent);
}

}  // namespace
}  // namespace soft::solver
