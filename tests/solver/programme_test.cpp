/// Load programmes: several kinds of loads, in sequence and together, and control by a rotation.
#include <gtest/gtest.h>

#include <cmath>

#include "../fem/sample_cases.hpp"
#include "bench.hpp"
#include "core/error.hpp"

namespace soft::solver {
namespace {

using model::StopReason;

/// A block fixed on one side under its own weight, a pressure on its top and a traction on its end.
model::Case loaded_block() {
    auto input = box_case(2, true);
    input.supports = {{"fixed", {true, true, true}}};
    input.materials[0].density_kg_m3 = 1080;
    input.loads = {{.name = "top", .targets = {"top"}, .gas = {}}};
    input.dead_loads = {
        {"end", model::DeadLoadKind::traction, {2e4, 0, 5e3}},
        {"gravity", model::DeadLoadKind::gravity, {0, 0, -300}}};  // thirty times the earth's, for a visible effect
    input.outputs = {{"sag", "end", {0, 0, 1}}, {"bend", "end", {0, 1, 0}, model::Measure::bend, "fixed"}};
    input.path.stages = {full_load(input, {1e4})};
    return input;
}

// The state of an elastic body does not depend on the load history.
TEST(Programme, TheSameLoadsGiveTheSameStateInAnyOrder) {
    auto input = loaded_block();
    const auto together = run(input);
    ASSERT_EQ(together.end.reason, StopReason::done);
    auto weight = full_load(input, {0.0}), pull = weight, all = full_load(input, {1e4});
    weight.dead_loads = {0.0, 1.0};
    input.path.stages = {weight, pull, all};
    const auto in_turn = run(input);
    ASSERT_EQ(in_turn.end.reason, StopReason::done);
    EXPECT_EQ(in_turn.steps.back().stage, 2);
    for (const std::size_t output : {0, 1})
        EXPECT_NEAR(in_turn.steps.back().outputs[output], together.steps.back().outputs[output],
                    1e-7 * std::abs(together.steps.back().outputs[output]));
    // Loading and unloading.
    auto none = full_load(input, {0.0});
    none.dead_loads = {0.0, 0.0};
    input.path.stages.push_back(none);
    const auto back = run(input);
    EXPECT_NEAR(back.steps.back().outputs[0], 0.0, 1e-9 * 0.01);
}

TEST(Programme, AHoldMayBeTheFirstStage) {
    auto input = loaded_block();
    const auto without = run(input);
    auto hold = full_load(input, {0.0});
    hold.dead_loads.assign(input.dead_loads.size(), 0.0);
    input.path.stages.insert(input.path.stages.begin(), hold);
    const auto with = run(input);
    ASSERT_EQ(with.end.reason, StopReason::done);
    ASSERT_EQ(with.steps.size(), without.steps.size() + 1);  // the undeformed state twice
    EXPECT_EQ(with.steps[1].outputs, without.steps[0].outputs);
    EXPECT_EQ(with.steps.back().outputs, without.steps.back().outputs);
    input.path.stages = {hold};
    EXPECT_THROW(static_cast<void>(run(input)), Error);
}

TEST(Programme, EachStageHasItsNumberOfSteps) {
    auto input = loaded_block();
    auto more = full_load(input, {2e4});
    input.path.stages = {full_load(input, {1e4}), more, more};
    input.solver.first_step = 1e-3;
    for (std::size_t stage = 0; stage < 3; ++stage)
        input.path.stages[stage].until = {{"steps", 2.0 + static_cast<double>(stage)}};
    std::vector<int> rows(3, 0);
    for (const auto& step : run(input).steps) ++rows[static_cast<std::size_t>(step.stage)];
    EXPECT_EQ(rows, (std::vector{3, 3, 4}));  // with the undeformed state
}

TEST(Programme, AnAngleCanBeControlledAndCanBeAGoal) {
    auto input = loaded_block();
    input.dead_loads.clear();
    input.path.stages = {full_load(input, {2e5})};
    auto& stage = input.path.stages[0];
    stage.control = model::Control::displacement;
    stage.controlled = "bend";
    const auto free_run = run(input);
    const double bend = free_run.steps.back().outputs[1];
    ASSERT_GT(std::abs(bend), 0.05);
    stage.until = {{"bend", 0.4 * bend}};
    const auto [steps, end, log] = run(input);
    EXPECT_EQ(end.reason, StopReason::done);
    EXPECT_NE(end.detail.find("deg"), std::string::npos);
    EXPECT_NEAR(steps.back().outputs[1], 0.4 * bend, 1e-8 * std::abs(bend));
    for (std::size_t i = 1; i < steps.size(); ++i)
        EXPECT_GT(steps[i].outputs[1] / bend, steps[i - 1].outputs[1] / bend);
}

// Uniaxial: a block between smooth planes, pulled by a motion, thins by 1/sqrt(l); its energy is mu/2 (l^2 + 2/l - 3).
TEST(Programme, APrescribedMotionStretchesTheBlockByTheClosedForm) {
    auto input = box_case(1, true);
    input.loads.clear();
    input.motions = {{"end", {0.005, std::nullopt, std::nullopt}}};
    input.outputs = {{"width", "right", {0, 1, 0}}};
    input.path.stages = {full_load(input, {})};
    fem::System system(input, PETSC_COMM_WORLD);
    double energy = 0;
    std::vector<model::Step> steps;
    const auto end = follow_path(system, {.step = [&](const model::Step& step, Vec x) {
                                     steps.push_back(step);
                                     energy = system.fields().stored_energy(x);
                                 }});
    EXPECT_EQ(end.reason, StopReason::done);
    const double l = 1.5;
    EXPECT_NEAR(steps.back().outputs[0], 0.01 * (1 / std::sqrt(l) - 1), 1e-10);
    EXPECT_NEAR(energy, 0.5 * sample_mu_Pa * (l * l + 2 / l - 3) * 1e-6, 1e-9 * energy);
    EXPECT_DOUBLE_EQ(steps.back().pressure_Pa, 1.0);  // without pressures and tractions a curve shows the load factor
}

TEST(Programme, RejectsACaseWithoutAnyLoad) {
    auto input = box_case(1, true);
    input.path.stages = {full_load(input, {0.0})};
    EXPECT_THROW((void)run(input), Error);
}

}  // namespace
}  // namespace soft::solver
