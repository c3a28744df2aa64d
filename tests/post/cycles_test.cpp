// Cycles of a repeated programme.
#include "post/cycles.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace soft::post {
namespace {

/// Three cycles of two stages with two rows each; the loads do 10 mJ in the first cycle, then 6 and 5.
model::Case three_cycles() {
    model::Case model;
    model.path.cycles = 3;
    for (int cycle = 1; cycle <= 3; ++cycle)
        for (const char* name : {"up", "down"}) {
            model.path.stages.push_back({.name = name});
            model.path.stages.back().cycle = cycle;
        }
    return model;
}

std::vector<model::Step> rows() {
    std::vector<model::Step> steps(1);
    steps[0].energies = model::Step::Energies{};
    const double work_J[] = {8e-3, 10e-3, 15e-3, 16e-3, 20e-3, 21e-3};
    for (int stage = 0; stage < 6; ++stage)
        for (const double share : {0.5, 1.0}) {
            model::Step& step = steps.emplace_back();
            step.stage = stage;
            step.load_factor = share;
            step.energies = {.stored_J = 0, .load_work_J = work_J[stage], .dissipated_J = 0.9 * work_J[stage]};
            step.friction_J = 0.1 * work_J[stage];
        }
    return steps;
}

TEST(Cycles, EnergiesAreThoseOfEachCycle) {
    const auto energies = cycle_energies(three_cycles(), rows());
    ASSERT_EQ(energies.size(), 3U);
    const double work_mJ[] = {10, 6, 5};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(energies[i].cycle, static_cast<int>(i) + 1);
        EXPECT_NEAR(1e3 * energies[i].load_work_J, work_mJ[i], 1e-9);
        EXPECT_NEAR(1e3 * energies[i].dissipated_J, 0.9 * work_mJ[i], 1e-9);
        EXPECT_NEAR(1e3 * energies[i].friction_J.value(), 0.1 * work_mJ[i], 1e-9);
    }
    auto unfinished = rows();
    unfinished.pop_back();
    EXPECT_EQ(cycle_energies(three_cycles(), unfinished).size(), 2U);
    EXPECT_TRUE(cycle_energies(model::Case{}, {}).empty());
}

TEST(Cycles, ACycleBeginsInTheLastRowBeforeIt) {
    const auto all = rows();
    auto steps = all;
    model::PathEnd end;
    end.limit_points = {{3, 1e3, {}, {}}, {6, 2e3, {}, {}}};
    keep_cycle(three_cycles(), 2, steps, end);
    ASSERT_EQ(steps.size(), 5U);
    EXPECT_EQ(steps.front().stage, 1);
    EXPECT_EQ(steps.back().stage, 3);
    ASSERT_EQ(end.limit_points.size(), 1U);
    EXPECT_EQ(end.limit_points[0].step, 2);
    steps = all;
    keep_cycle(three_cycles(), 1, steps, end);
    EXPECT_EQ(steps.size(), 5U);
    EXPECT_THROW(keep_cycle(three_cycles(), 4, steps, end), Error);
    EXPECT_THROW(static_cast<void>(rows_of_cycle(model::Case{}, {}, 1)), Error);
}

}  // namespace
}  // namespace soft::post
