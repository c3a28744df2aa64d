/// Every integrator on masses and springs: order of accuracy, damping, energy, stability.
#include <cstdio>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "motion_bench.hpp"

namespace soft::solver {
namespace {

using model::Dynamics;
using model::Integrator;

struct Expected {
    Integrator integrator;
    double order;
};

const std::vector<Expected>& all() {
    static const std::vector<Expected> list{{Integrator::generalized_alpha, 2},
                                            {Integrator::hht, 2},
                                            {Integrator::newmark, 2},
                                            {Integrator::implicit_euler, 1},
                                            {Integrator::ark4, 4},
                                            {Integrator::rosenbrock, 3},
                                            {Integrator::heun, 2},
                                            {Integrator::explicit_euler, 1},
                                            {Integrator::central_difference, 2}};
    return list;
}

const std::vector<Expected>& implicit() {
    static const std::vector<Expected> list(all().begin(), all().begin() + 6);
    return list;
}

/// End of the motion of one cell of linear rubber under F sin(W t), forced off resonance:
/// x = F/K / (1 - (W/w)^2) (sin W t - W/w sin w t).
double oscillator_error(Integrator integrator, int steps) {
    const double w = oscillator_frequency(integrator), W = 0.6 * w, T = 4.0 / w, strain = 0.01;
    auto input = bar_case(1, strain * bar_modulus_Pa, sine_time_function(W / (2.0 * std::numbers::pi)));
    input.dynamics = Dynamics{.integrator = integrator, .duration_s = T, .step_s = T / steps};
    const double r = W / w, exact = strain * bar_length_m / (1.0 - r * r) * (std::sin(W * T) - r * std::sin(w * T));
    const auto moved = move(input);
    EXPECT_EQ(moved.end.reason, model::StopReason::done) << moved.end.detail;
    return std::abs(moved.end_value() - exact) / (strain * bar_length_m);
}

TEST(Integrators, ConvergeToTheForcedOscillatorWithTheirOrder) {
    for (const auto& [integrator, order] : all()) {
        const int steps = order < 2 ? 160 : 40;
        const double coarse = oscillator_error(integrator, steps), fine = oscillator_error(integrator, 2 * steps);
        EXPECT_GT(std::log2(coarse / fine), order - 0.15) << int(integrator);
        EXPECT_LT(std::log2(coarse / fine), order + 0.5) << int(integrator);
        EXPECT_LT(fine, order < 2 ? 0.05 : 2e-3) << int(integrator);
    }
}

/// Two cells of rubber at large strain.
model::Case nonlinear_bar(double duration) {
    auto input = bar_case(2, 0.4 * bar_modulus_Pa, sine_time_function(0.25 / duration));
    input.materials[0].law = "neo-hookean";
    input.dynamics = Dynamics{.duration_s = duration};
    return input;
}

TEST(Integrators, KeepTheirOrderAtLargeStrain) {
    const double T = 4.0 / oscillator_frequency(Integrator::newmark);
    const auto end = [&](Integrator integrator, int steps) {
        auto input = nonlinear_bar(T);
        input.dynamics->integrator = integrator;
        input.dynamics->step_s = T / steps;
        return move(input).end_value();
    };
    const double limit = end(Integrator::ark4, 320);
    EXPECT_GT(limit, 0.2 * bar_length_m);
    for (const auto& [integrator, order] : implicit()) {
        const int steps = order < 2 ? 160 : 80;
        const double coarse = std::abs(end(integrator, steps) - limit),
                     fine = std::abs(end(integrator, 2 * steps) - limit);
        EXPECT_GT(std::log2(coarse / fine), order - 0.3) << int(integrator);
        EXPECT_LT(fine / limit, order < 2 ? 0.05 : 2e-3) << int(integrator);
    }
}

TEST(Integrators, AdaptiveStepsReachTheLimitOfFineSteps) {
    const double T = 8.0 / oscillator_frequency(Integrator::newmark);
    auto fine = nonlinear_bar(T);
    fine.dynamics->integrator = Integrator::ark4;
    fine.dynamics->step_s = T / 640;
    const double limit = move(fine).end_value();
    for (const auto& [integrator, order] : implicit()) {
        auto input = nonlinear_bar(T);
        input.dynamics->integrator = integrator;
        input.dynamics->accuracy = order < 2 ? 1e-4 : 1e-5;
        const auto moved = move(input);
        EXPECT_EQ(moved.end.reason, model::StopReason::done) << moved.end.detail;
        EXPECT_NEAR(moved.last().motion->time_s, T, 1e-15);
        EXPECT_NEAR(moved.end_value() / limit, 1.0, order < 2 ? 0.05 : 5e-3) << int(integrator);
    }
}

// Under a constant force from rest: x = F/K (1 - exp(-z w t) (cos d t + z w/d sin d t)), d = w sqrt(1 - z^2).
TEST(Integrators, RayleighDampingDecaysWithItsDampingRatio) {
    const double w = oscillator_frequency(Integrator::ark4), strain = 0.01, alpha = 0.1 * w, beta = 0.06 / w;
    const double zeta = 0.5 * (alpha / w + beta * w), d = w * std::sqrt(1.0 - zeta * zeta), T = 12.0 / w;
    auto input = bar_case(1, strain * bar_modulus_Pa, step_time_function());
    input.dynamics = Dynamics{.integrator = Integrator::ark4, .duration_s = T, .step_s = T / 400};
    input.dynamics->mass_damping_1_s = alpha;
    input.dynamics->stiffness_damping_s = beta;
    const auto moved = move(input);
    for (const auto& step : moved.steps) {
        const double t = step.motion->time_s;
        const double x = strain * bar_length_m *
                         (1.0 - std::exp(-zeta * w * t) * (std::cos(d * t) + zeta * w / d * std::sin(d * t)));
        EXPECT_NEAR(step.outputs[0], x, 1e-7 * strain * bar_length_m);
    }
    EXPECT_GT(moved.last().motion->damping_work_J, 0.0);
}

/// Remainder of a mode that the step does not resolve (w h = 1000) after `steps`, over its static displacement.
double unresolved_rest(Integrator integrator, double radius, int steps) {
    const double h = 1000.0 / oscillator_frequency(integrator), strain = 0.01;
    auto input = bar_case(1, strain * bar_modulus_Pa, step_time_function());
    input.dynamics = Dynamics{.integrator = integrator, .duration_s = h * steps, .step_s = h};
    input.dynamics->spectral_radius = radius;
    return std::abs(move(input).end_value() / (strain * bar_length_m) - 1.0);
}

// At infinite frequency all three roots of generalised alpha are -radius: the remainder falls as n^2 radius^n.
TEST(Integrators, GeneralizedAlphaDampsUnresolvedModes) {
    const double rate = unresolved_rest(Integrator::generalized_alpha, 0.6, 40) /
                        unresolved_rest(Integrator::generalized_alpha, 0.6, 30);
    EXPECT_GT(rate, std::pow(0.6, 10));
    EXPECT_LT(rate, 2.0 * std::pow(0.6, 10));
    EXPECT_GT(unresolved_rest(Integrator::newmark, 0.6, 30), 0.5);
    EXPECT_GT(unresolved_rest(Integrator::generalized_alpha, 1.0, 30), 0.5);
    // Re (1 - i w h)^-4 of implicit Euler, 1e-12 to six digits, plus the rounding of the displacement.
    EXPECT_NEAR(unresolved_rest(Integrator::implicit_euler, 0.6, 4), 1e-12, 1e-14);
}

// With average acceleration a linear body gains exactly the trapezoidal work of the force.
TEST(Integrators, NewmarkConservesTheEnergyOfALinearBody) {
    auto input = bar_case(8, 0.01 * bar_modulus_Pa, step_time_function());
    const double T = 40.0 / oscillator_frequency(Integrator::newmark);
    input.dynamics = Dynamics{.integrator = Integrator::newmark, .duration_s = T, .step_s = T / 60};
    double largest = 0;
    for (const auto& step : move(input).steps) {
        const auto& m = *step.motion;
        largest = std::max(largest, m.load_work_J);
        EXPECT_NEAR(m.kinetic_energy_J + m.stored_energy_J, m.load_work_J, 1e-9 * largest) << m.time_s;
    }
    EXPECT_GT(largest, 0.0);
}

/// Largest error of the energy balance over the largest work of the loads, large strain with damping.
double energy_gap(Integrator integrator, int steps) {
    const double w = oscillator_frequency(Integrator::newmark), T = 8.0 / w;
    auto input = nonlinear_bar(T);
    input.dynamics->integrator = integrator;
    input.dynamics->step_s = T / steps;
    input.dynamics->mass_damping_1_s = 0.05 * w;
    input.dynamics->stiffness_damping_s = 0.02 / w;
    double gap = 0, work = 0;
    for (const auto& step : move(input).steps) {
        const auto& m = *step.motion;
        work = std::max(work, std::abs(m.load_work_J));
        gap = std::max(gap, std::abs(m.kinetic_energy_J + m.stored_energy_J + m.damping_work_J - m.load_work_J));
    }
    return gap / work;
}

TEST(Integrators, EnergyBalancesToTheOrderOfTheStep) {
    for (const auto integrator : {Integrator::generalized_alpha, Integrator::newmark, Integrator::ark4}) {
        const double coarse = energy_gap(integrator, 100), fine = energy_gap(integrator, 200);
        EXPECT_LT(fine, 1e-3) << int(integrator);
        EXPECT_GT(std::log2(coarse / fine), 1.8) << int(integrator);
    }
}

// 20 cells: with the two mass matrices the wave number differs by (k h)^2 / 12, small for a ramp of one period.
TEST(Integrators, ExplicitAndImplicitMethodsAgree) {
    const double wave_s = bar_length_m / std::sqrt(bar_modulus_Pa / bar_density);
    const auto end = [&](Integrator integrator, double step_s) {
        auto input = bar_case(20, 0.2 * bar_modulus_Pa, ramp_time_function(4.0 * wave_s));
        input.materials[0].law = "neo-hookean";
        input.dynamics = Dynamics{.integrator = integrator, .duration_s = 6.0 * wave_s, .step_s = step_s};
        return move(input).end_value();
    };
    const double limit = end(Integrator::ark4, wave_s / 20);
    EXPECT_NEAR(end(Integrator::central_difference, 0.0) / limit, 1.0, 2e-3);
    EXPECT_NEAR(end(Integrator::heun, 0.0) / limit, 1.0, 2e-3);
}

TEST(Integrators, RejectACentralDifferenceStepLongerThanTheStableStep) {
    const double limit = 2.0 / oscillator_frequency(Integrator::central_difference);
    auto input = bar_case(1, 0.01 * bar_modulus_Pa, step_time_function());
    input.dynamics =
        Dynamics{.integrator = Integrator::central_difference, .duration_s = 20 * limit, .step_s = 0.999 * limit};
    const auto moved = move(input);
    EXPECT_EQ(moved.end.reason, model::StopReason::done);
    for (const auto& step : moved.steps) EXPECT_LE(std::abs(step.outputs[0]), 2.01 * 0.01 * bar_length_m);  // 1 - cos
    input.dynamics->step_s = 1.001 * limit;
    try {
        (void)move(input);
        ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        EXPECT_NE(std::string(error.what()).find("stable"), std::string::npos);
    }
}

// This law stiffens in uniaxial strain: a step that was stable is shortened, and the motion stays bounded.
TEST(Integrators, ShortenTheStepOfABodyThatStiffens) {
    const double limit = 2.0 / oscillator_frequency(Integrator::central_difference);
    auto input = bar_case(1, -0.3 * bar_modulus_Pa, ramp_time_function());
    input.materials[0].law = "neo-hookean";
    input.dynamics =
        Dynamics{.integrator = Integrator::central_difference, .duration_s = 2000 * limit, .step_s = 0.95 * limit};
    const auto moved = move(input);
    EXPECT_EQ(moved.end.reason, model::StopReason::done) << moved.end.detail;
    bool is_reported = false;
    for (const auto& line : moved.log)
        is_reported = is_reported || line.find("stable step has fallen") != std::string::npos;
    EXPECT_TRUE(is_reported);
}

TEST(Integrators, ExplicitMotionsWithTooManyStepsEndAtTheStart) {
    auto input = bar_case(1, 0.01 * bar_modulus_Pa, step_time_function());
    input.dynamics =
        Dynamics{.integrator = Integrator::explicit_euler, .duration_s = 1e4 / oscillator_frequency(Integrator::heun)};
    const auto moved = move(input);  // stable: 2 / (T w^2)
    EXPECT_EQ(moved.end.reason, model::StopReason::step_limit);
    EXPECT_EQ(moved.steps.size(), 1u);  // rest
    EXPECT_NE(moved.end.detail.find("implicit"), std::string::npos);
}

/// A cell that the loads invert, whatever the step.
model::Case crushed_bar(Integrator integrator) {
    auto input = bar_case(1, -20.0 * bar_modulus_Pa, step_time_function());  // linear elasticity inverts at -1
    input.dynamics = Dynamics{.integrator = integrator, .duration_s = 4.0 / oscillator_frequency(Integrator::newmark)};
    return input;
}

// The log gives the failed step and the shorter one, their ratio is the cut factor; the final message names the cell.
TEST(Integrators, AFailedStepIsCutAndLogged) {
    for (const auto& [integrator, order] : all()) {
        const auto moved = move(crushed_bar(integrator));
        EXPECT_EQ(moved.end.reason, model::StopReason::inverted_element) << int(integrator) << moved.end.detail;
        EXPECT_NE(moved.end.detail.find("in cell 0"), std::string::npos) << moved.end.detail;
        EXPECT_GE(moved.steps.size(), 1u);
        int cuts = 0;
        for (const auto& line : moved.log) {
            double from = 0, to = 0;
            if (line.find(" failed (") == std::string::npos) continue;
            ASSERT_EQ(std::sscanf(line.c_str(), "step of %lf s failed", &from), 1) << line;
            ASSERT_EQ(std::sscanf(line.substr(line.find("cut to")).c_str(), "cut to %lf s", &to), 1) << line;
            EXPECT_NEAR(to / from, 0.4, 0.01) << line;  // lengths are rounded to few binary digits
            ++cuts;
        }
        EXPECT_GT(cuts, 3) << int(integrator);
    }
}

// Linear rubber under a traction near the largest floating-point number: no cell inverts, and the motion overflows.
TEST(Integrators, AnUnboundedExplicitMotionDivergesWithFiniteRows) {
    for (const auto integrator : {Integrator::heun, Integrator::explicit_euler, Integrator::central_difference}) {
        auto input = bar_case(1, 1e300, step_time_function());
        input.dynamics = Dynamics{.integrator = integrator, .duration_s = 40.0 / oscillator_frequency(integrator)};
        const auto moved = move(input);
        EXPECT_EQ(moved.end.reason, model::StopReason::diverged) << int(integrator) << moved.end.detail;
        EXPECT_NE(moved.end.detail.find("without bound"), std::string::npos) << moved.end.detail;
        ASSERT_FALSE(moved.steps.empty());
        for (const auto& step : moved.steps)
            for (const double value : {step.stretch_p99, step.max_stretch, step.outputs[0],
                                       step.motion->kinetic_energy_J, step.motion->stored_energy_J})
                EXPECT_TRUE(std::isfinite(value)) << int(integrator);
    }
}

// A sudden pressure of three moduli stiffens the bar by more than the step allows: energy is created, at det F > 0.
// A law with initial stress moves the body without loads, which is not an error.
TEST(Integrators, CreatedEnergyEndsAnExplicitMotion) {
    auto input = bar_case(4, -3.0 * bar_modulus_Pa, step_time_function());
    input.materials[0].law = "neo-hookean";
    input.dynamics = Dynamics{.integrator = Integrator::central_difference,
                              .duration_s = 40.0 / oscillator_frequency(Integrator::central_difference)};
    const auto moved = move(input);
    EXPECT_EQ(moved.end.reason, model::StopReason::diverged) << moved.end.detail;
    EXPECT_NE(moved.end.detail.find("the work of the loads is only"), std::string::npos) << moved.end.detail;

    auto stressed = bar_case(4, 1e-3 * bar_modulus_Pa, step_time_function());
    stressed.materials[0].law = "kraken";
    stressed.materials[0].bulk_modulus_Pa = 10.0 * bar_modulus_Pa;
    stressed.dynamics =
        Dynamics{.integrator = Integrator::heun, .duration_s = 20.0 / oscillator_frequency(Integrator::heun)};
    const auto oscillation = move(stressed);
    EXPECT_EQ(oscillation.end.reason, model::StopReason::done) << oscillation.end.detail;
}

TEST(Integrators, WriteAtMostTheRequestedRows) {
    for (const double step_s : {0.0, 1e-5}) {
        auto input = bar_case(1, 0.01 * bar_modulus_Pa, step_time_function());
        input.dynamics = Dynamics{.duration_s = 5e-3, .step_s = step_s};
        input.dynamics->rows = 12;
        const auto moved = move(input);
        EXPECT_LE(moved.steps.size(), 12u);
        EXPECT_GE(moved.steps.size(), 8u);
        EXPECT_EQ(moved.steps.front().motion->time_s, 0.0);
        EXPECT_DOUBLE_EQ(moved.last().motion->time_s, 5e-3);
        EXPECT_DOUBLE_EQ(moved.last().load_factor, 1.0);
    }
}

}  // namespace
}  // namespace soft::solver
