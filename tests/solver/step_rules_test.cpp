// model::StepRule and model::Predictor: positions of the rows of a path.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../fem/sample_cases.hpp"
#include "bench.hpp"
#include "core/error.hpp"

namespace soft::solver {
namespace {

using model::Predictor;
using model::StepRule;

model::Case box(StepRule rule, double first_step) {
    auto input = box_case(1, true);
    input.solver.steps = rule;
    input.solver.first_step = first_step;
    return input;
}

/// sigma = mu (l^2 - 1/l) of the uniaxial pull.
void expect_closed_form(const std::vector<model::Step>& steps) {
    for (const auto& step : steps) {
        const double l = 1.0 + step.outputs[0] / 0.01;
        EXPECT_NEAR(-step.pressure_Pa / sample_mu_Pa, l * l - 1.0 / l, 1e-8);
    }
}

TEST(StepRules, ConstantStepsEndAtMultiplesOfTheFirstStep) {
    for (const int n : {49, 300}) {  // 49 x (1 / 49) < 1 in floating point
        const auto [steps, end, log] = run(box(StepRule::constant, 1.0 / n));
        EXPECT_EQ(end.reason, model::StopReason::done);
        ASSERT_EQ(steps.size(), static_cast<std::size_t>(n) + 1);
        for (int k = 0; k <= n; ++k)
            EXPECT_NEAR(steps[static_cast<std::size_t>(k)].load_factor, static_cast<double>(k) / n, 1e-14);
        expect_closed_form(steps);
    }
}

TEST(StepRules, AGoalBetweenTwoConstantStepsIsReached) {
    auto input = box(StepRule::constant, 0.05);
    input.path.stages[0].until = {{"elongation", 0.002}};
    const auto [steps, end, log] = run(input);
    EXPECT_NE(end.detail.find("elongation"), std::string::npos);
    EXPECT_NEAR(steps.back().outputs[0], 0.002, 1e-12);
    for (std::size_t k = 0; k + 1 < steps.size(); ++k)
        EXPECT_NEAR(steps[k].load_factor, 0.05 * static_cast<double>(k), 1e-14);
}

TEST(StepRules, AConstantStepReturnsToItsMultiplesAfterACut) {
    auto input = box(StepRule::constant, 0.25);
    input.path.stages[0].control = model::Control::pressure;
    input.solver.newton_limit = 2;  // too few for the whole step, enough for a shorter one
    input.solver.predictor = Predictor::none;
    input.solver.residual_tolerance = 1e-5;
    const auto [steps, end, log] = run(input);
    EXPECT_EQ(end.reason, model::StopReason::done) << end.detail;
    EXPECT_GT(steps.size(), 5u);
    for (int k = 0; k <= 4; ++k)
        EXPECT_TRUE(std::ranges::any_of(steps, [&](const auto& step) {
            return std::abs(step.load_factor - 0.25 * k) < 1e-12;
        })) << k;
}

TEST(StepRules, StepsGrowByTheRootOfWantedOverActualIterations) {
    auto input = box(StepRule::iteration_adaptive, 0.01);
    input.solver.wanted_iterations = 4;
    const auto [steps, end, log] = run(input);
    EXPECT_EQ(end.reason, model::StopReason::done);
    ASSERT_GT(steps.size(), 5u);
    for (std::size_t i = 2; i + 1 < steps.size(); ++i) {
        const double grown =
            (steps[i].load_factor - steps[i - 1].load_factor) / (steps[i - 1].load_factor - steps[i - 2].load_factor);
        const double wanted = std::clamp(std::sqrt(4.0 / steps[i - 1].newton_iterations), 0.5, 2.0);
        EXPECT_NEAR(grown / wanted, 1.0, 2.0 / 256);  // steps are rounded to few digits
    }
    expect_closed_form(steps);
    input.solver.wanted_iterations = 2;
    EXPECT_GT(run(input).steps.size(), steps.size());
}

TEST(StepRules, BetterPredictorsFollowTheSamePathInFewerIterations) {
    std::vector<int> iterations;
    for (const auto predictor : {Predictor::cubic, Predictor::tangent, Predictor::none}) {
        auto input = box(StepRule::constant, 0.05);
        input.solver.predictor = predictor;
        const auto result = run(input);
        EXPECT_EQ(result.end.reason, model::StopReason::done);
        EXPECT_EQ(result.steps.size(), 21u);
        expect_closed_form(result.steps);
        iterations.push_back(result.end.newton_iterations);
    }
    EXPECT_LT(iterations[0], iterations[1]);
    EXPECT_LT(iterations[1], iterations[2]);
}

TEST(StepRules, ErrorAdaptiveStepsWorkWithoutAPredictedInitialGuess) {
    auto input = box(StepRule::error_adaptive, 0.02);
    const auto cubic = run(input).steps;
    input.solver.predictor = Predictor::none;
    const auto [steps, end, log] = run(input);
    EXPECT_EQ(end.reason, model::StopReason::done);
    ASSERT_EQ(steps.size(), cubic.size());  // the predictor still chooses the steps
    for (std::size_t i = 0; i < steps.size(); ++i) EXPECT_NEAR(steps[i].load_factor, cubic[i].load_factor, 1e-6);
}

// Predictor errors below the accuracy of equilibrium must not shorten the steps until the path ends.
TEST(StepRules, ALooseEquilibriumDoesNotEndThePath) {
    auto input = box(StepRule::error_adaptive, 1.0 / 300);
    input.path.stages[0].control = model::Control::pressure;
    input.solver.predictor = Predictor::none;
    input.solver.residual_tolerance = 1e-4;
    input.solver.linear.method = model::LinearMethod::krylov;
    input.solver.linear.preconditioner = model::Preconditioner::jacobi;
    input.solver.linear.tolerance = 1e-2;
    const auto [steps, end, log] = run(input);
    EXPECT_EQ(end.reason, model::StopReason::done) << end.detail;
}

}  // namespace
}  // namespace soft::solver
