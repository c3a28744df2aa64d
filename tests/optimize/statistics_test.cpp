/// A straight line fitted to points: estimates, their standard errors and correlations have closed forms.
#include "optimize/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include "samples.hpp"

namespace soft::optimize {
namespace {

using test::silent;
using test::variable;

constexpr int points = 12;
constexpr double intercept = 2, slope = 3, noise = 0.1;

/// y = a + b x at x = 0 ... 11 times `scale`, with noise unless the seed is 0.
Goal line(unsigned seed, double scale = 1) {
    Goal goal;
    goal.variables = {variable("a", -10, 10), variable("b", -10, 10)};
    std::mt19937 random(seed);
    std::normal_distribution<double> error(0, noise);
    for (int i = 0; i < points; ++i) {
        Condition row;
        row.value_SI = intercept + slope * i * scale + (seed > 0 ? error(random) : 0);
        row.within = 0.5;  // only the ratios matter
        row.is_data = true;
        goal.conditions.push_back(row);
    }
    return goal;
}

Evaluate model(double scale = 1) {
    return [scale](const std::vector<double>& v) {
        Trial trial;
        for (int i = 0; i < points; ++i) trial.conditions.push_back({v[0] + v[1] * i * scale, {1, i * scale}});
        return trial;
    };
}

TEST(Statistics, OfALineHaveTheirClosedForm) {
    const Goal goal = line(1);
    const Found found = search(goal, {1, 1}, {1}, model(), silent);
    const auto statistics = statistics_of(goal, found);
    ASSERT_TRUE(statistics);
    double mean = 0, spread = 0, squares = 0;
    for (int i = 0; i < points; ++i) mean += static_cast<double>(i) / points;
    for (int i = 0; i < points; ++i) {
        spread += (i - mean) * (i - mean);
        const auto k = static_cast<std::size_t>(i);
        squares += std::pow(found.trial.conditions[k].value_SI - goal.conditions[k].value_SI, 2);
    }
    const double s = std::sqrt(squares / (points - 2));
    EXPECT_NEAR(statistics->standard_errors[1], s / std::sqrt(spread), 1e-9);
    EXPECT_NEAR(statistics->standard_errors[0], s * std::sqrt(1.0 / points + mean * mean / spread), 1e-9);
    const double mean_square = spread / points + mean * mean;
    EXPECT_NEAR(statistics->correlations[1], -mean / std::sqrt(mean_square), 1e-9);
    EXPECT_EQ(statistics->degrees_of_freedom, static_cast<std::size_t>(points - 2));
    EXPECT_LT(statistics->condition, Statistics::max_condition);
}

TEST(Statistics, AgreeWithTheScatterOfRepeatedFits) {
    constexpr int repeats = 400;
    double squares = 0, stated = 0;
    for (unsigned seed = 1; seed <= repeats; ++seed) {
        const Goal goal = line(seed);
        const Found found = search(goal, {1, 1}, {1}, model(), silent);
        squares += std::pow(found.values[1] - slope, 2) / repeats;
        stated += std::pow(statistics_of(goal, found)->standard_errors[1], 2) / repeats;
    }
    EXPECT_NEAR(std::sqrt(stated / squares), 1, 0.1);
}

TEST(Statistics, NameTheCombinationThatTheDataDoNotDetermine) {
    const double scale = 1e-4;  // nearly one point: a + b x is known, the slope is not
    const Goal goal = line(0, scale);
    const auto shifted = [&](const std::vector<double>& v) {
        Trial trial;
        for (int i = 0; i < points; ++i) {
            const double x = 1 + i * scale;
            trial.conditions.push_back({v[0] - slope + v[1] * x, {1, x}});
        }
        return trial;
    };
    const Found found{{intercept, slope}, shifted({intercept, slope}), 0, 1};
    const auto statistics = statistics_of(goal, found);
    ASSERT_TRUE(statistics);
    EXPECT_GT(statistics->condition, 1e3);
    // a + b stays
    ASSERT_EQ(statistics->weakest.size(), 2u);
    EXPECT_NEAR(statistics->weakest[0], 1, 1e-9);
    EXPECT_NEAR(statistics->weakest[1], -intercept / slope, 1e-3);
}

TEST(Statistics, LeaveOutWhatDoesNotChangeTheDataAndEndAtAnActiveBound) {
    Goal goal = line(1);
    goal.variables.push_back(variable("c", 0, 1));
    const auto with_c = [](const std::vector<double>& v) {
        Trial trial = model()(v);
        for (Trial::Value& value : trial.conditions) value.gradient.push_back(0);
        return trial;
    };
    const Found found = search(goal, {1, 1, 0.5}, {1}, with_c, silent);
    const auto statistics = statistics_of(goal, found);
    ASSERT_TRUE(statistics);
    EXPECT_EQ(statistics->undetermined, (std::vector<std::size_t>{2}));
    EXPECT_EQ(statistics->variables, (std::vector<std::size_t>{0, 1}));
    Condition bound;
    bound.relation = Condition::Relation::below;
    bound.value_SI = bound.scale_SI = 2;
    goal.conditions.push_back(bound);
    Found at_bound = found;
    at_bound.trial.conditions.push_back({2, {1, 0, 0}});
    EXPECT_FALSE(statistics_of(goal, at_bound));
}

TEST(Statistics, NeedMoreTargetsThanVariablesAndLeaveOutEnds) {
    Goal goal = line(1);
    goal.variables[0] = variable("a", 2.5, 10);  // the estimate ends there
    const Found found = search(goal, {5, 1}, {1}, model(), silent);
    EXPECT_TRUE(is_at_end(goal.variables[0], found.values[0]));
    EXPECT_EQ(statistics_of(goal, found)->variables, (std::vector<std::size_t>{1}));
    goal.conditions.resize(1);
    EXPECT_FALSE(statistics_of(goal, {{5, 3}, found.trial, 0, 1}));
}

}  // namespace
}  // namespace soft::optimize
