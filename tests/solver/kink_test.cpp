/// Fibres that become slack or taut: the tangent jumps, and the path may have kinks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench.hpp"
#include "sphere.hpp"

namespace soft::solver {
namespace {

/// The thick sphere, `stiffness` times as stiff along two families of fibres at this angle from the axis, under a pressure of
/// `load` times its shear modulus.
model::Case fiber_sphere(int layers, int sectors, double stiffness, double angle_rad, double load) {
    model::Case input = sphere_case(layers, sectors);
    input.materials[0].fiber_frame = model::FiberFrame::cylindrical;
    input.materials[0].fibers = model::Fibers{angle_rad, stiffness * sample_mu_Pa, 1, 2};
    input.path.stages[0].supplies[0].value = load * sample_mu_Pa;
    return input;
}

// At rest every fibre is at its kink, and which fibres are taut is part of the solution. The response is homogeneous of degree one,
// though not linear: the solution for the load 2 l is twice that for l. |R| does not fall monotonically.
TEST(Kink, NewtonFindsTheTautFibresAtRest) {
    const auto input = fiber_sphere(2, 4, 300, 0.4, 1);
    const auto at = [&](double load_factor) {
        Bench bench(input, input.solver);
        State state = bench.rest();
        EXPECT_EQ(bench.newton.correct({ConstraintKind::load_factor}, load_factor, state).end, NewtonEnd::converged);
        return std::pair{bench.system.volumes().of_load(0, state.x, nullptr), std::move(state)};
    };
    const auto [rest_m3, rest] = at(0.0);
    const auto [once_m3, once] = at(1e-3);
    const auto [twice_m3, twice] = at(2e-3);
    EXPECT_GT(once_m3, rest_m3);
    EXPECT_NEAR((twice_m3 - rest_m3) / (once_m3 - rest_m3), 2.0, 1e-2);
    auto difference = linalg::duplicate(twice.x);
    linalg::copy(twice.x, difference);
    linalg::add(difference, -2.0, once.x);
    EXPECT_LT(linalg::norm(difference), 1e-2 * linalg::norm(twice.x));
}

// The first direction of a path also depends on the taut fibres. A block pulled along its fibres elongates by L / (3 mu + 4 k1) per
// pascal, from dT/dl of T = mu (l - l^-2) + 2 k1 (l^2 - 1) exp(k2 (l^2 - 1)^2) l at l = 1; a block pulled across its fibres, which
// shortens them, elongates as without fibres.
TEST(Kink, ThePathStartsInTheDirectionOfTheTautFibres) {
    for (const bool along : {true, false}) {
        auto input = box_case(1, true);
        constexpr double stiffness = 7, edge_m = 0.01;
        input.materials[0].fiber_frame = model::FiberFrame::cartesian;
        input.materials[0].fibers = model::Fibers{along ? 0.0 : std::numbers::pi / 2, stiffness * sample_mu_Pa, 1, 1};
        input.loads.clear();
        input.dead_loads = {{"end", model::DeadLoadKind::traction, {0.05 * sample_mu_Pa, 0, 0}}};
        input.path.stages = {full_load(input, {})};
        const auto [steps, end, log] = run(input);
        ASSERT_EQ(end.reason, model::StopReason::done) << end.detail;
        const double slope = steps.front().tangent_outputs.at(0) / steps.front().tangent_pressure;
        const double compliance = edge_m / ((along ? 3 + 4 * stiffness : 3.0) * sample_mu_Pa);
        EXPECT_NEAR(slope / compliance, 1.0, 1e-4) << along;
    }
}

// Hoop fibres about the axis under a vacuum: the sphere, with one cell through the wall, folds, and its load turns from falling to
// rising where hoops become taut, at a kink of more than a right angle. Steps of two lengths approach the kink from different
// distances: the states beyond it are the same, and the load at the kink is the limit for small steps, 0.5536 of the full load.
// (Shorter steps converge to another branch before, which has no such kink.)
TEST(Kink, APathContinuesPastAKinkAtWhichTheLoadReverses) {
    struct Seen {
        double kink, end_m3, beyond_m3;
    };
    const auto seen = [](double accuracy) {
        constexpr double beyond = 0.75;
        auto input = fiber_sphere(1, 2, 10, 1.5, -2);
        input.solver.step_accuracy *= accuracy;
        input.path.contact = model::Contact::ignore;
        const auto [steps, end, log] = run(input);
        EXPECT_EQ(end.reason, model::StopReason::done) << end.detail;
        EXPECT_EQ(std::ranges::count_if(log, [](const auto& line) { return line.find("kink") != line.npos; }), 1);
        const auto top = std::ranges::adjacent_find(
            steps, [](const auto& a, const auto& b) { return b.load_factor < a.load_factor; });
        const auto least = std::min_element(top, steps.end(),
                                            [](const auto& a, const auto& b) { return a.load_factor < b.load_factor; });
        const auto next = std::find_if(least, steps.end(), [](const auto& step) { return step.load_factor > beyond; });
        const double share = (beyond - next[-1].load_factor) / (next->load_factor - next[-1].load_factor);
        return Seen{least->load_factor, *steps.back().volume_m3,
                    *next[-1].volume_m3 + share * (*next->volume_m3 - *next[-1].volume_m3)};
    };
    const Seen by_one = seen(2), by_other = seen(3);
    for (const Seen& one : {by_one, by_other}) EXPECT_NEAR(one.kink, 0.5536, 2e-3);
    EXPECT_NEAR(by_one.beyond_m3 / by_other.beyond_m3, 1.0, 1e-3);  // linear interpolation between rows
    EXPECT_NEAR(by_one.end_m3 / by_other.end_m3, 1.0, 1e-6);
}

}  // namespace
}  // namespace soft::solver
