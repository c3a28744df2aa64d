// Variants of Newton's method and its line searches: the same states at different cost.
#include <gtest/gtest.h>

#include <cmath>

#include "../fem/sample_cases.hpp"
#include "bench.hpp"
#include "sphere.hpp"

namespace soft::solver {
namespace {

using model::NewtonMethod;

/// A clamped box pulled in four equal steps.
model::Case pulled_box(bool incompressible) {
    auto input = box_case(2, incompressible);
    input.supports[0].fixed = {true, true, true};
    input.path.stages[0].supplies[0].value = -0.4 * sample_mu_Pa;  // well below the maximum of its load
    input.solver.steps = model::StepRule::constant;
    input.solver.first_step = 0.25;
    input.solver.newton_limit = 60;
    return input;
}

struct Cost {
    int iterations = 0, factorizations = 0;
};

Cost cost_of(const Run& run) { return {run.end.newton_iterations, run.end.factorizations}; }

TEST(NewtonMethods, KeptTangentsReachTheSameStatesWithFewerFactorisationsAndMoreIterations) {
    for (const bool incompressible : {false, true}) {
        auto input = pulled_box(incompressible);
        input.solver.predictor = model::Predictor::none;  // more to correct
        const auto full = run(input);
        for (const auto method : {NewtonMethod::modified, NewtonMethod::bfgs}) {
            input.solver.newton = method;
            const auto other = run(input);
            ASSERT_EQ(other.end.reason, model::StopReason::done) << other.end.detail;
            ASSERT_EQ(other.steps.size(), full.steps.size());
            for (std::size_t i = 1; i < full.steps.size(); ++i)
                EXPECT_NEAR(other.steps[i].outputs[0] / full.steps[i].outputs[0], 1.0, 1e-7);
            EXPECT_LT(cost_of(other).factorizations, cost_of(full).factorizations);
            EXPECT_GT(cost_of(other).iterations, cost_of(full).iterations);
        }
    }
}

TEST(NewtonMethods, BfgsNeedsFewerIterationsThanAKeptTangent) {
    auto input = pulled_box(false);
    input.formulation = model::Formulation::displacement;
    input.solver.predictor = model::Predictor::none;
    input.solver.newton = NewtonMethod::modified;
    const auto modified = run(input);
    input.solver.newton = NewtonMethod::bfgs;
    EXPECT_LT(cost_of(run(input)).iterations, cost_of(modified).iterations);
}

// With a load of 1e-8 mu only the last digits of det F = 1 + strain carry the strain: their rounding error in the residual exceeds
// the tolerance. Strain p / (3 mu).
TEST(NewtonMethods, ALoadNearRoundingHasTheElongationOfLinearElasticity) {
    auto input = box_case(3, true);
    const double pressure_Pa = 1e-8 * sample_mu_Pa;
    input.path.stages[0].supplies[0].value = -pressure_Pa;
    const auto [steps, end, log] = run(input);
    ASSERT_EQ(end.reason, model::StopReason::done) << end.detail;
    EXPECT_NEAR(steps.back().outputs[0] / (0.01 * pressure_Pa / (3 * sample_mu_Pa)), 1.0, 1e-5);
}

// Under volume control the pressure is an unknown of the bordered system.
TEST(NewtonMethods, KeptTangentsFollowTheSphereThroughItsLimitPoint) {
    for (const auto method : {NewtonMethod::modified, NewtonMethod::bfgs}) {
        auto input = sphere_case(2, 4);
        input.path.stages[0].control = model::Control::volume;
        input.path.stages[0].until = {{"volume_ratio", 10.0}};
        input.solver.newton = method;
        input.solver.newton_limit = 40;
        const auto [steps, end, log] = run(input);
        EXPECT_EQ(end.reason, model::StopReason::done) << end.detail;
        ASSERT_EQ(end.limit_points.size(), 1u);
        EXPECT_NEAR(end.limit_points[0].pressure_Pa / sample_mu_Pa / sphere_limit, 1.0, 1e-3);
    }
}

// A moving face: its column needs a separate tangent while K is kept.
TEST(NewtonMethods, KeptTangentsMoveAFace) {
    auto input = pulled_box(false);
    input.loads.clear();
    input.motions = {{"end", {0.004, std::nullopt, std::nullopt}}};
    input.path.stages = {full_load(input, {})};
    const auto full = run(input);
    for (const auto method : {NewtonMethod::modified, NewtonMethod::bfgs}) {
        input.solver.newton = method;
        const auto other = run(input);
        ASSERT_EQ(other.end.reason, model::StopReason::done) << other.end.detail;
        EXPECT_NEAR(other.steps.back().max_stretch, full.steps.back().max_stretch, 1e-7);
    }
}

TEST(NewtonMethods, TangentsByDifferencesGiveTheSameCurve) {
    auto input = pulled_box(true);
    const auto exact = run(input);
    input.solver.tangent = model::TangentSource::finite_difference;
    const auto differences = run(input);
    ASSERT_EQ(differences.end.reason, model::StopReason::done) << differences.end.detail;
    ASSERT_EQ(differences.steps.size(), exact.steps.size());
    for (std::size_t i = 1; i < exact.steps.size(); ++i)
        EXPECT_NEAR(differences.steps[i].outputs[0] / exact.steps[i].outputs[0], 1.0, 1e-8);
}

/// Newton's method from the undeformed state to this load factor in a single step.
NewtonResult leap(model::Case input, model::LineSearch line_search, double load_factor) {
    input.solver.line_search = line_search;
    Bench bench(input, input.solver);
    State state = bench.rest();
    return bench.newton.correct({ConstraintKind::load_factor}, load_factor, state);
}

TEST(NewtonMethods, ALineSearchConvergesWhereFullCorrectionsDoNot) {
    auto input = pulled_box(false);
    input.formulation = model::Formulation::displacement;
    input.solver.newton_limit = 30;
    const auto none = leap(input, model::LineSearch::none, 1.0),
               halved = leap(input, model::LineSearch::backtracking, 1.0),
               secant = leap(input, model::LineSearch::secant, 1.0);
    EXPECT_EQ(halved.end, NewtonEnd::converged);
    EXPECT_EQ(secant.end, NewtonEnd::converged);
    EXPECT_GT(secant.halvings, 0);
    EXPECT_TRUE(none.end != NewtonEnd::converged || none.iterations > halved.iterations)
        << none.iterations << " iterations without, " << halved.iterations << " halving, " << secant.iterations
        << " secant";
}

TEST(NewtonMethods, TheResidualMeetsTheTolerance) {
    auto input = pulled_box(false);
    int iterations = 0;
    for (const double tolerance : {1e-2, 1e-6, 1e-11}) {
        input.solver.residual_tolerance = tolerance;
        Bench bench(input, input.solver);
        State state = bench.rest();
        const auto result = bench.newton.correct({ConstraintKind::load_factor}, 0.3, state);
        ASSERT_EQ(result.end, NewtonEnd::converged);
        EXPECT_LE(result.residual, tolerance);
        EXPECT_GT(result.iterations, iterations);
        iterations = result.iterations;
    }
}

TEST(NewtonMethods, EndsWhereAnAcceptedChangeIsLeft) {
    const auto input = pulled_box(false);
    const auto solved = [&](double accepted) {
        Bench bench(input, input.solver);
        bench.newton.accept_change(accepted);
        State state = bench.rest();
        const auto result = bench.newton.correct({ConstraintKind::load_factor}, 0.3, state);
        EXPECT_EQ(result.end, NewtonEnd::converged);
        return std::pair(linalg::gather(state.x), result.iterations);
    };
    const auto [exact, most] = solved(0.0);
    int iterations = 0;
    EXPECT_LT(solved(1e-1).second, most);
    for (const double accepted : {1e-1, 1e-3, 1e-5}) {
        const auto [x, needed] = solved(accepted);
        double left = 0, size = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            left = std::hypot(left, x[i] - exact[i]);
            size = std::hypot(size, exact[i]);
        }
        EXPECT_LE(left, accepted * size);
        EXPECT_GE(needed, iterations);
        iterations = needed;
    }
    EXPECT_LE(iterations, most);
}

}  // namespace
}  // namespace soft::solver
