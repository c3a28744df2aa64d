/// Searches with functions whose optimum is known.
#include "optimize/search.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "samples.hpp"

namespace soft::optimize {
namespace {

using test::silent;
using test::variable;

Goal goal_of(std::vector<Variable> variables, std::vector<Condition> conditions, bool minimizes) {
    Goal goal;
    goal.variables = std::move(variables);
    goal.conditions = std::move(conditions);
    if (minimizes) goal.minimize = Measure{};
    return goal;
}
Condition condition(Condition::Relation relation, double value, double within = 1e-3) {
    Condition one;
    one.relation = relation;
    one.value_SI = one.scale_SI = value;
    one.within = within;
    return one;
}
constexpr auto equal = Condition::Relation::equal, below = Condition::Relation::below;
/// Smallest x^2 + y^2 with x y = 1 (a hyperbola): x = y = 1.
Trial hyperbola(const std::vector<double>& v) {
    return {"", {{v[0] * v[1], {v[1], v[0]}}}, {v[0] * v[0] + v[1] * v[1], {2 * v[0], 2 * v[1]}}, true};
}

/// x + y = 1.5 and (x - y)/10 = 0.25 at x = 2, y = -0.5; its projection onto the ranges is the corner x = 1, y = 0. The nearest point in the
/// ranges is x = 1, y = 0.97/2.02, where 2 (y - 0.5) + 0.2 (0.15 + 0.1 y) = 0.
TEST(Search, LeavesACornerThatIsNotTheNearest) {
    Condition sum = condition(equal, 1.5), difference = condition(equal, 0.25);
    sum.scale_SI = difference.scale_SI = 1;
    const Goal goal = goal_of({variable("x", 0, 1), variable("y", 0, 1)}, {sum, difference}, false);
    const auto plane = [](const std::vector<double>& v) {
        return Trial{"", {{v[0] + v[1], {1, 1}}, {(v[0] - v[1]) / 10, {0.1, -0.1}}}, {}, true};
    };
    const Found found = search(goal, {0.5, 0.5}, {1}, plane, silent);
    EXPECT_NEAR(found.values[0], 1, 1e-6);
    EXPECT_NEAR(found.values[1], 0.97 / 2.02, 1e-3);
}

TEST(Search, FindsAConstrainedMinimum) {
    const Goal goal = goal_of({variable("x", 0.1, 4), variable("y", 0.1, 4)}, {condition(equal, 1)}, true);
    const Found found = search(goal, {3, 0.2}, {1}, hyperbola, silent);
    EXPECT_EQ(found.violation, 0);
    EXPECT_NEAR(found.values[0], 1, 2e-2);  // flat: the objective is what converges
    EXPECT_NEAR(found.trial.objective.value_SI, 2, 3e-3);
}

/// Smallest x with x y >= 500: the first steps from x = 5 follow the bound x = 2 outside of what is allowed, with equal objectives.
TEST(Search, GoesOnAlongABoundWhereTheConditionIsNotMet) {
    const Goal goal = goal_of({variable("x", 2, 12), variable("y", 20, 400)}, {condition(below, 1)}, true);
    const auto stretch = [](const std::vector<double>& v) {
        const double c = 500 / (v[0] * v[1]);
        return Trial{"", {{c, {-c / v[0], -c / v[1]}}}, {v[0], {1, 0}}, true};
    };
    for (const auto& start : {std::vector<double>{5, 101}, {4, 150}, {10, 60}}) {
        const Found found = search(goal, start, {1}, stretch, silent);
        EXPECT_EQ(found.violation, 0);
        EXPECT_NEAR(found.values[0], 2, 1e-3);
    }
}

TEST(Search, WithoutAnObjectiveMeetsTheTargets) {
    const Goal goal = goal_of({variable("x", 0.1, 4), variable("y", 0.1, 4)}, {condition(equal, 1)}, false);
    const Found found = search(goal, {3, 3}, {1}, hyperbola, silent);
    EXPECT_NEAR(found.values[0] * found.values[1], 1, 1e-3);
}

TEST(Search, TargetsCountByWhatTheyAllow) {
    // x = 3 within 0.1 % and x = 2 within 60 %: 3 meets both; the mean of both does not
    const Goal goal = goal_of({variable("x", 1, 4)}, {condition(equal, 3), condition(equal, 2, 0.6)}, false);
    const auto line = [](const std::vector<double>& v) { return Trial{"", {{v[0], {1}}, {v[0], {1}}}, {}, true}; };
    const Found found = search(goal, {1}, {1}, line, silent);
    EXPECT_EQ(found.violation, 0);
}

TEST(Search, ReturnsTheNearestWhereNothingMeetsTheConditions) {
    const Goal goal = goal_of({variable("x", 0, 1)}, {condition(equal, 5), condition(below, 2)}, false);
    const auto line = [](const std::vector<double>& v) { return Trial{"", {{v[0], {1}}, {v[0], {1}}}, {}, true}; };
    const Found found = search(goal, {0.5}, {2}, line, silent);
    EXPECT_NEAR(found.values[0], 1, 1e-6);
    EXPECT_NEAR(found.violation, 0.8, 2e-3);
}

TEST(Search, TheNearestOfAMinimumHasTheSmallestLargestViolation) {
    // x^2 = 1 and x^2 = 3: (x^2 - 1) / 1 = (3 - x^2) / 3 at x^2 = 1.5; the objective y then counts no more.
    const Goal goal =
        goal_of({variable("x", 0.1, 4), variable("y", 0, 1)}, {condition(equal, 1), condition(equal, 3)}, true);
    const auto square = [](const std::vector<double>& v) {
        const Trial::Value x2{v[0] * v[0], {2 * v[0], 0}};
        return Trial{"", {x2, x2}, {v[1], {0, 1}}, true};
    };
    for (const double start : {0.2, 3.0}) {
        const Found found = search(goal, {start, 0.7}, {1}, square, silent);
        EXPECT_NEAR(found.values[0] * found.values[0], 1.5, 1e-3);
        EXPECT_NEAR(found.violation, 0.499, 1e-3);
    }
}

TEST(Search, TheNearestCountsTheTargetsByWhatTheyAllow) {
    // x = 1 within 0.5 % and x = 1.2 within 2 %, x below 2: the weighted mean of both, not the middle of the differences
    const Goal goal = goal_of({variable("x", 0.5, 3)},
                              {condition(equal, 1, 5e-3), condition(equal, 1.2, 2e-2), condition(below, 2)}, false);
    const auto line = [](const std::vector<double>& v) {
        return Trial{"", {{v[0], {1}}, {v[0], {1}}, {v[0], {1}}}, {}, true};
    };
    const double first = 1 / std::pow(5e-3, 2), second = 1 / std::pow(2e-2 * 1.2, 2);
    const Found found = search(goal, {2.9}, {1}, line, silent);
    EXPECT_NEAR(found.values[0], (first + 1.2 * second) / (first + second), 1e-4);
    EXPECT_GT(found.violation, 0);
}

TEST(Search, OfWholeNumbersTriesNeighboursAndOptimizesBetweenThem) {
    Variable n = variable("n", 1, 20);
    n.is_whole = true;
    const Goal goal = goal_of({n, variable("x", 0, 10)}, {condition(equal, 12)}, true);
    // n x = 12 with the smallest (n - 7)^2 + x: n = 7, x = 12/7; (6, 2) costs 3, (7, 1.71) 1.71
    const auto product = [](const std::vector<double>& v) {
        return Trial{"", {{v[0] * v[1], {0, v[0]}}}, {(v[0] - 7) * (v[0] - 7) + v[1], {0, 1}}, true};
    };
    const Found found = search(goal, {12, 5}, {1}, product, silent);
    EXPECT_EQ(found.values[0], 7);
    EXPECT_NEAR(found.values[1], 12.0 / 7, 1e-2);
}

/// Minima near 0 and 8, between them a hill that gradients do not cross.
TEST(Search, GlobalFindsTheSmallerOfTwoMinima) {
    const Goal goal = goal_of({variable("x", -7, 10)}, {}, true);
    const auto valleys = [](const std::vector<double>& v) {
        const double x = v[0], near = x - 8;
        const bool is_far = x > 4;
        return Trial{"", {}, {is_far ? 1 + near * near : x * x, {is_far ? 2 * near : 2 * x}}, true};
    };
    EXPECT_NEAR(search(goal, {7}, {1}, valleys, silent).values[0], 8, 1e-2);
    EXPECT_NEAR(search(goal, {7}, {1, 30}, valleys, silent).values[0], 0, 1e-2);
}

/// A cost with steps and two whole numbers: derivatives say nothing, and neighbours of the start are no better.
TEST(Search, GlobalFindsWholeNumbersFarFromTheStart) {
    Variable n = variable("n", 1, 20), m = variable("m", 1, 20);
    n.is_whole = m.is_whole = true;
    const Goal goal = goal_of({n, m, variable("x", 0, 1)}, {condition(below, 0.5)}, true);
    const auto steps = [](const std::vector<double>& v) {
        const double far = std::abs(v[0] - 14) + std::abs(v[1] - 5);
        return Trial{"", {{v[2], {0, 0, 1}}}, {std::min(far, 5.0), {0, 0, 0}}, true};
    };
    EXPECT_EQ(search(goal, {2, 19, 0.9}, {1}, steps, silent).trial.objective.value_SI, 5);
    const Found found = search(goal, {2, 19, 0.9}, {1, 200}, steps, silent);
    EXPECT_EQ(found.trial.objective.value_SI, 0);
    EXPECT_EQ(found.violation, 0);
}

TEST(Search, ContinuesInASmallerBoxAfterATrialThatFails) {
    const Goal goal = goal_of({variable("x", 0, 10)}, {condition(equal, 4)}, false);
    int failures = 0;
    const auto fails_beyond_5 = [&](const std::vector<double>& v) {
        if (v[0] > 5) {
            ++failures;
            return Trial{"beyond 5", {}, {}, true};
        }
        return Trial{"", {{std::sqrt(v[0]) * 2, {1 / std::sqrt(v[0])}}}, {}, true};  // 4 at x = 4
    };
    const Found found = search(goal, {0.2}, {1}, fails_beyond_5, silent);
    EXPECT_NEAR(found.values[0], 4, 2e-2);
    EXPECT_LT(found.violation, 1e-9);
}

TEST(Search, MinimizesUpToWhereTrialsFail) {
    const Goal goal = goal_of({variable("x", 3, 40)}, {}, true);
    const auto fails_beyond_10 = [](const std::vector<double>& v) {
        return v[0] > 10 ? Trial{"beyond 10", {}, {}, true} : Trial{"", {}, {50 - v[0], {-1}}, true};
    };
    EXPECT_GT(search(goal, {7}, {1}, fails_beyond_10, silent).values[0], 9.5);
}

TEST(Search, WithoutAnySuccessNamesTheFirstFailure) {
    const Goal goal = goal_of({variable("x", 0, 1)}, {condition(equal, 4)}, false);
    try {
        static_cast<void>(search(
            goal, {0.5}, {2},
            [](const std::vector<double>&) {
                return Trial{"walls cross", {}, {}, true};
            },
            silent));
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "no trial succeeds: walls cross; change the ranges of `vary`");
    }
}

}  // namespace
}  // namespace soft::optimize
