/// The work of the loads along a path equals the stored energy, for every load with a potential; and its order of convergence.
#include <gtest/gtest.h>

#include <cmath>

#include "../fem/sample_cases.hpp"
#include "bench.hpp"

namespace soft::solver {
namespace {

double gap(const model::Step& step) { return std::abs(step.energies->load_work_J / step.energies->stored_J - 1); }

TEST(Work, OfAnInflationIsTheEnergyOfTheRubber) {
    auto input = sphere_case(2, 8);
    input.path.stages[0].until = {{"volume_ratio", 8}};
    const auto result = run(input);  // past the limit point
    ASSERT_EQ(result.end.reason, model::StopReason::done);
    for (const auto& step : result.steps) {
        EXPECT_TRUE(step.energies->stored_J <= 0 || gap(step) < 1e-4) << step.load_factor;
        const double power = step.pressure_Pa * step.tangent_volume;
        EXPECT_NEAR(*step.energies->tangent_J, power, 1e-10 * std::abs(power)) << step.load_factor;
    }
    EXPECT_GT(result.steps.back().energies->stored_J, 0.1);  // of the whole sphere
}

/// A block under a traction, its weight, a dead pressure and a motion, each of which does work.
model::Case loaded_block() {
    auto input = box_case(2, true);
    input.supports = {{"fixed", {true, true, true}}};
    input.materials[0].density_kg_m3 = 1080;
    input.loads = {{.name = "top", .targets = {"top"}, .gas = {}, .shape = model::LoadShape::undeformed}};
    input.dead_loads = {{"right", model::DeadLoadKind::traction, {2e4, 0, 5e3}},
                        {"gravity", model::DeadLoadKind::gravity, {0, 0, -300}}};
    input.motions = {{"end", {3e-3, std::nullopt, std::nullopt}}};
    input.outputs = {{"sag", "end", {0, 0, 1}}};
    input.path.stages = {full_load(input, {1e4})};
    return input;
}

TEST(Work, OfDeadLoadsAndMotionsIsTheEnergyOfTheRubber) {
    auto input = loaded_block();
    const auto together = run(input);
    ASSERT_EQ(together.end.reason, model::StopReason::done);
    EXPECT_LT(gap(together.steps.back()), 1e-5);
    // With stages the direction of the path changes between them; the energy depends only on the state.
    auto weight = full_load(input, {0.0}), all = full_load(input, {1e4});
    weight.dead_loads = {0.0, 1.0};
    weight.motions = {0.5};
    input.path.stages = {weight, all};
    const auto in_turn = run(input);
    EXPECT_LT(gap(in_turn.steps.back()), 1e-5);
    EXPECT_NEAR(in_turn.steps.back().energies->stored_J / together.steps.back().energies->stored_J, 1.0, 1e-8);
}

/// At a row the power of all loads is the derivative of the energy, here by differences of a path of short steps.
TEST(Work, PowerIsTheDerivativeOfTheEnergy) {
    auto input = loaded_block();
    input.solver.steps = model::StepRule::constant;
    input.solver.first_step = 0.01;
    const auto result = run(input);
    const auto energy = [&](std::size_t row) { return result.steps[row].energies->stored_J; };
    for (const std::size_t row : {30u, 60u, 90u}) {
        const auto& step = result.steps[row];
        const double by_differences = (energy(row - 2) - 8 * energy(row - 1) + 8 * energy(row + 1) - energy(row + 2)) /
                                      (12 * (step.load_factor - result.steps[row - 1].load_factor));
        EXPECT_NEAR(*step.energies->tangent_J / step.tangent_load_factor / by_differences, 1.0, 1e-6) << row;
    }
}

TEST(Work, ConvergesWithTheFourthPowerOfTheStep) {
    auto input = box_case(1, true);  // pulled by a motion, uniaxial
    input.loads.clear();
    input.motions = {{"end", {0.01, std::nullopt, std::nullopt}}};
    input.path.stages = {full_load(input, {})};
    input.solver.steps = model::StepRule::constant;
    const auto gap_with = [&](double step) {
        input.solver.first_step = step;
        return gap(run(input).steps.back());
    };
    const double coarse = gap_with(0.25), fine = gap_with(0.125);
    EXPECT_LT(coarse, 1e-3);
    EXPECT_GT(coarse / fine, 12);
}

// The position of the largest stretch: the inner wall of a sphere.
TEST(Extremes, OfASphereAreAtItsInnerWall) {
    auto input = sphere_case(2, 8);
    input.path.stages[0].until = {{"volume_ratio", 8}};
    const auto result = run(input);
    const auto& extremes = *result.steps.back().extremes;
    EXPECT_LT(std::hypot(extremes.stretch_at_m[0], extremes.stretch_at_m[1]),
              0.0107);  // the first integration points of 5 mm cells
    EXPECT_GE(std::hypot(extremes.stretch_at_m[0], extremes.stretch_at_m[1]), 0.01);
    const double l = result.steps.back().max_stretch, expected = 0.5 * sample_mu_Pa * (2 * l * l + std::pow(l, -4) - 3);
    EXPECT_NEAR(extremes.energy_J_m3 / expected, 1.0, 0.02);  // an equibiaxial state there, incompressible in the mean
}

}  // namespace
}  // namespace soft::solver
