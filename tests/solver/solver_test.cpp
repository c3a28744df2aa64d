#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "../fem/sample_cases.hpp"
#include "bench.hpp"
#include "core/error.hpp"
#include "solver/goals.hpp"
#include "solver/history.hpp"
#include "solver/newton.hpp"
#include "sphere.hpp"

namespace soft::solver {
namespace {

TEST(History, HermiteWeightsInterpolateAndExtrapolateACubic) {
    const auto y = [](double q) { return 2.0 - q + 3.0 * q * q - 0.5 * q * q * q; };
    const auto slope = [](double q) { return -1.0 + 6.0 * q - 1.5 * q * q; };
    for (const double q : {0.3, 0.7, 1.1, 1.9, 3.0}) {
        const auto w = hermite_weights(0.5, 1.2, q);
        EXPECT_NEAR(hermite(w, y(0.5), slope(0.5), y(1.2), slope(1.2)), y(q), 1e-12);
    }
}

TEST(Newton, ReachesThePrescribedValueOfEveryConstraint) {
    const auto input = sphere_case(2, 4);
    Bench bench(input, input.solver);
    State by_load = bench.rest(), by_volume = bench.rest();
    ASSERT_EQ(bench.newton.correct({ConstraintKind::load_factor}, 0.05, by_load).end, NewtonEnd::converged);
    const double volume = bench.system.volumes().of_load(0, by_load.x, nullptr);
    ASSERT_EQ(bench.newton.correct({ConstraintKind::volume}, volume, by_volume).end, NewtonEnd::converged);
    EXPECT_NEAR(by_volume.load_factor, 0.05, 1e-9);
    EXPECT_NEAR(bench.system.volumes().of_load(0, by_volume.x, nullptr) / volume, 1.0, 1e-9);
}

TEST(Newton, ConvergesQuadratically) {
    const auto input = sphere_case(2, 4);
    auto settings = input.solver;
    std::vector<double> residuals;
    for (int limit = 2; limit <= 5; ++limit) {
        settings.newton_limit = limit;
        settings.residual_tolerance = 1e-30;  // never reached: the test needs the residual after `limit` iterations
        Bench bench(input, settings);
        State state = bench.rest();
        state.load_factor = 0.3;
        residuals.push_back(bench.newton.correct({ConstraintKind::load_factor}, 0.3, state).residual);
    }
    // r_{k+1} <= C r_k^2 until rounding: the exponent between successive drops approaches 2.
    std::size_t k = 1;
    while (k + 1 < residuals.size() && residuals[k + 1] > 1e-12) ++k;
    EXPECT_GT(std::log(residuals[k]) / std::log(residuals[k - 1]), 1.7);
}

TEST(Newton, TangentIsTheDirectionOfThePath) {
    const auto input = sphere_case(2, 4);
    Bench bench(input, input.solver);
    const auto at = [&](double load_factor) {
        State state = bench.rest();
        EXPECT_EQ(bench.newton.correct({ConstraintKind::load_factor}, load_factor, state).end, NewtonEnd::converged);
        return state;
    };
    const auto middle = at(0.1);
    const auto tangent = bench.newton.tangent({ConstraintKind::load_factor}, middle);
    ASSERT_TRUE(tangent);
    auto difference = linalg::duplicate(middle.x);
    linalg::copy(at(0.101).x, difference);
    linalg::add(difference, -1.0, at(0.099).x);
    linalg::add(difference, -0.002, tangent->x);
    EXPECT_LT(linalg::norm(difference), 1e-4 * 0.002 * linalg::norm(tangent->x));
    EXPECT_EQ(tangent->unstable_modes, 0);
}

TEST(Goals, FirstMeetingIsTheEarliestOfAllGoals) {
    PathPoint from, to;
    from.q = 0;
    to.q = 1;
    from.tangent.load_factor = to.tangent.load_factor = 1;  // load factor = q
    to.state.load_factor = 1;
    from.outputs = {0};
    to.outputs = {4};
    from.output_slopes = {0};
    to.output_slopes = {8};  // output = 4 q^2
    Goal by_output{{ConstraintKind::output}, 1.0, "output"};
    const std::vector<Goal> goals{{{ConstraintKind::load_factor}, 0.8, "load"}, by_output};
    const auto crossing = first_between(goals, from, to);
    ASSERT_TRUE(crossing);
    EXPECT_EQ(crossing->goal->text, "output");
    EXPECT_NEAR(crossing->q, 0.5, 1e-12);
}

TEST(Path, SphereFollowsItsClosedFormThroughTheLimitPointUnderVolumeControl) {
    auto input = sphere_case(4, 8);
    input.path.stages[0].control = model::Control::volume;
    input.path.stages[0].until = {{"volume_ratio", 27.0}};  // l_a = 3
    const auto [steps, end, log] = run(input);
    EXPECT_EQ(end.reason, model::StopReason::done);
    EXPECT_NEAR(inner_stretch(steps.back()), 3.0, 1e-4);
    for (const auto& step : steps)
        EXPECT_NEAR(step.pressure_Pa / sample_mu_Pa, sphere_pressure(inner_stretch(step)), 1e-3 * sphere_limit);
    ASSERT_EQ(end.limit_points.size(), 1u);
    EXPECT_NEAR(end.limit_points[0].pressure_Pa / sample_mu_Pa / sphere_limit, 1.0, 1e-4);
    EXPECT_NEAR(inner_stretch(steps[end.limit_points[0].step]), 1.8281, 1e-3 * 1.8281);
    for (const auto& step : steps) {  // stable up to the maximum at a given pressure; at a given volume also beyond it
        if (std::abs(inner_stretch(step) / 1.8281 - 1) > 2e-3) {
            EXPECT_EQ(step.stable, inner_stretch(step) < 1.8281);
        }
        EXPECT_EQ(step.stable_under_control, true);
    }
}

TEST(Path, AutomaticControlPassesTheLimitPoint) {
    auto input = sphere_case(4, 8);
    input.path.stages[0].until = {{"volume_ratio", 27.0}};
    const auto [steps, end, log] = run(input);
    EXPECT_EQ(end.reason, model::StopReason::done);
    EXPECT_NEAR(inner_stretch(steps.back()), 3.0, 1e-4);
    ASSERT_EQ(end.limit_points.size(), 1u);
    EXPECT_NEAR(end.limit_points[0].pressure_Pa / sample_mu_Pa / sphere_limit, 1.0, 1e-4);
    EXPECT_TRUE(end.bifurcations.empty());
}

TEST(Path, ArcLengthControlFindsTheSameLimitPoint) {
    auto input = sphere_case(4, 8);
    input.path.stages[0].control = model::Control::arc_length;
    input.path.stages[0].until = {{"volume_ratio", 10.0}};
    const auto end = run(input).end;
    EXPECT_EQ(end.reason, model::StopReason::done);
    ASSERT_EQ(end.limit_points.size(), 1u);
    EXPECT_NEAR(end.limit_points[0].pressure_Pa / sample_mu_Pa / sphere_limit, 1.0, 1e-4);
}

TEST(Path, PressureControlEndsAtTheLimitPoint) {
    auto input = sphere_case(4, 8);
    input.path.stages[0].control = model::Control::pressure;
    const auto [steps, end, log] = run(input);
    EXPECT_EQ(end.reason, model::StopReason::limit_point);
    EXPECT_NEAR(steps.back().pressure_Pa / sample_mu_Pa / sphere_limit, 1.0, 1e-4);
    for (std::size_t i = 1; i < steps.size(); ++i) EXPECT_GT(steps[i].pressure_Pa, steps[i - 1].pressure_Pa);
}

// The work of the pressure is the stored energy: trapezoid with slopes (Hermite), exact to the fourth order of the step.
TEST(Path, WorkOfThePressureIsTheStoredEnergy) {
    auto input = sphere_case(4, 8);
    input.path.stages[0].until = {{"volume_ratio", 8.0}};
    fem::System system(input, PETSC_COMM_WORLD);
    std::vector<model::Step> steps;
    double energy = 0;
    (void)follow_path(system, {.step = [&](const model::Step& step, Vec x) {
                          steps.push_back(step);
                          energy = system.fields().stored_energy(x) / input.model_fraction;
                      }});
    double work = 0;
    for (std::size_t i = 1; i < steps.size(); ++i) {
        const auto &a = steps[i - 1], &b = steps[i];
        const double dV = *b.volume_m3 - *a.volume_m3;
        work += 0.5 * dV * (a.pressure_Pa + b.pressure_Pa) +
                dV * dV / 12.0 * (a.tangent_pressure / a.tangent_volume - b.tangent_pressure / b.tangent_volume);
    }
    EXPECT_NEAR(work / energy, 1.0, 1e-4);
}

// Uniaxial pull, incompressible: sigma = mu (l^2 - 1/l), reached by pressure control on the deformed end face.
TEST(Path, PulledBoxFollowsTheUniaxialClosedForm) {
    const auto input = box_case(1, true);
    const auto [steps, end, log] = run(input);
    EXPECT_EQ(end.reason, model::StopReason::done);
    for (const auto& step : steps) {
        const double l = 1.0 + step.outputs[0] / 0.01;
        EXPECT_NEAR(-step.pressure_Pa / sample_mu_Pa, l * l - 1.0 / l, 1e-8);
    }
    EXPECT_DOUBLE_EQ(steps.back().load_factor, 1.0);
    EXPECT_FALSE(steps.back().volume_m3.has_value());
}

TEST(Path, EndsAtTheFirstGoalReached) {
    auto input = box_case(1, true);
    input.path.stages[0].until = {{"elongation", 0.002}};
    const auto [steps, end, log] = run(input);
    EXPECT_NEAR(steps.back().outputs[0], 0.002, 1e-12);
    EXPECT_NE(end.detail.find("elongation"), std::string::npos);
    input.path.stages[0].until = {{"steps", 3}};
    input.solver.first_step = 0.002;
    EXPECT_EQ(run(input).steps.size(), 4u);  // the undeformed state and three steps
}

TEST(Path, ReportsAStepLimit) {
    auto input = box_case(1, true);
    input.solver.step_limit = 2;
    input.solver.first_step = 0.002;
    EXPECT_EQ(run(input).end.reason, model::StopReason::step_limit);
}

TEST(Path, RejectsABodyWithARigidMotion) {
    auto input = box_case(1, false);
    input.supports = {{"left", {false, true, false}}};
    EXPECT_THROW((void)run(input), Error);
}

TEST(Path, RejectsAControlOrGoalThatTheCaseDoesNotHave) {
    auto input = box_case(1, true);
    input.path.stages[0].control = model::Control::volume;
    EXPECT_THROW((void)run(input), Error);
    input.path.stages[0].control = model::Control::pressure;
    input.path.stages[0].until = {{"bend", 1.0}};
    EXPECT_THROW((void)run(input), Error);
    input.path.stages[0].until = {{"volume_ratio", 2.0}};
    EXPECT_THROW((void)run(input), Error);
}

}  // namespace
}  // namespace soft::solver
