// Internal variables of a system: what a step keeps, what trial states do not, and the copy for a restart.
#include <gtest/gtest.h>

#include "fem/system.hpp"
#include "sample_cases.hpp"
#include "sample_states.hpp"

namespace soft::fem {
namespace {

/// A viscoelastic, softening block in one stage of 2 s.
model::Case timed_block() {
    auto input = box_case(2, true);
    input.materials[0].inelastic = {{0.5}, {1.0}, false, material::Softening{2, 5e3, 0.1}};
    input.dead_loads = {{"end", model::DeadLoadKind::traction, {2e4, 0, 0}}};
    input.path.stages = {full_load(input, {})};
    input.path.stages[0].time_s = 2;
    return input;
}

LoadLevels at_time(const model::Case& input, double time_s) {
    LoadLevels levels = no_loads(input);
    levels.time_s = time_s;
    return levels;
}

double residual_norm(System& system, Vec x, const LoadLevels& levels) {
    const linalg::Vector R = system.make_vector();
    EXPECT_TRUE(system.evaluate(x, levels, R, nullptr).admissible());
    return linalg::norm(R);
}

TEST(InternalVariables, TrialStatesLeaveNoTrace) {
    const auto input = timed_block();
    System system(input, PETSC_COMM_WORLD);
    const auto small = wavy(system, 1e-4, 0.3), large = wavy(system, 2e-4, 0.3);
    const double before = residual_norm(system, small, at_time(input, 0.1));
    static_cast<void>(residual_norm(system, large, at_time(input, 1.0)));
    EXPECT_EQ(residual_norm(system, small, at_time(input, 0.1)), before);
    system.prescribe(at_time(input, 1.0));
    system.accept_step(large);
    EXPECT_NE(residual_norm(system, small, at_time(input, 1.1)), before);
}

// A state held relaxes toward its long-term forces, by exp(-t/tau).
TEST(InternalVariables, HeldStatesRelax) {
    const auto input = timed_block();
    System system(input, PETSC_COMM_WORLD);
    const auto x = wavy(system, 1e-4, 0.3);
    system.prescribe(at_time(input, 0));
    system.accept_step(x);
    const auto beyond_the_end = [&](double time_s) {
        const linalg::Vector R = system.make_vector(), end = system.make_vector();
        EXPECT_TRUE(system.evaluate(x, at_time(input, time_s), R, nullptr).admissible());
        EXPECT_TRUE(system.evaluate(x, at_time(input, 200), end, nullptr).admissible());
        linalg::add(R, -1.0, end);
        return linalg::norm(R);
    };
    EXPECT_GT(beyond_the_end(0), 0);
    EXPECT_NEAR(beyond_the_end(1) / beyond_the_end(0), std::exp(-1.0), 1e-9);
}

TEST(InternalVariables, ARestartHasTheSameDigits) {
    const auto input = timed_block();
    System first(input, PETSC_COMM_WORLD), second(input, PETSC_COMM_WORLD);
    const auto x = wavy(first, 1e-4, 0.3), y = wavy(first, 1.5e-4, 0.3);
    for (const double time_s : {0.3, 0.7}) {
        first.prescribe(at_time(input, time_s));
        first.accept_step(time_s < 0.5 ? x : y);
    }
    std::vector<double> values = first.internal().gather();
    ASSERT_FALSE(values.empty());
    ASSERT_TRUE(second.internal().restore(values));
    EXPECT_EQ(second.internal().start_time_s(), 0.7);
    EXPECT_EQ(second.internal().dissipated_J(), first.internal().dissipated_J());
    EXPECT_GT(first.internal().dissipated_J(), 0);
    EXPECT_EQ(residual_norm(second, x, at_time(input, 0.9)), residual_norm(first, x, at_time(input, 0.9)));
    values.pop_back();
    EXPECT_FALSE(second.internal().restore(values));
    EXPECT_FALSE(System(box_case(2, true), PETSC_COMM_WORLD).internal().restore(values));
}

TEST(InternalVariables, ElasticRubberHasNone) {
    const auto input = box_case(2, true);
    System system(input, PETSC_COMM_WORLD);
    EXPECT_TRUE(system.internal().is_empty());
    EXPECT_TRUE(system.internal().gather().empty());
    EXPECT_TRUE(system.internal().restore({}));
    EXPECT_FALSE(system.has_kinks());
    EXPECT_TRUE(System(timed_block(), PETSC_COMM_WORLD).has_kinks());
}

}  // namespace
}  // namespace soft::fem
