/// Paths with a prescribed displacement of a face: they start in the direction of the motion, and its work is the stored energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "../fem/sample_cases.hpp"
#include "../geometry/dice.hpp"
#include "bench.hpp"

namespace soft::solver {
namespace {

/// A block of random shape, from a pad to a rod, fixed at x = 0, whose other end moves by `strain` of its length along x.
model::Case moved_block(Dice& dice, double strain) {
    const bool incompressible = dice.chance(0.5);
    model::Case input = box_case(dice.whole(1, 2), incompressible);
    const double length = dice.between_logs(0.2, 5);
    const std::array<double, 3> scale{length, dice.between(0.5, 3), dice.between(0.5, 3)};
    for (auto& point : input.mesh.points)
        for (std::size_t i = 0; i < 3; ++i) point[i] *= scale[i];
    if (!incompressible && dice.chance(0.4)) input.formulation = model::Formulation::displacement;
    if (dice.chance(0.7)) input.supports[0].fixed = {true, true, true};
    input.loads.clear();
    input.motions = {{"end", {strain * 0.01 * length, std::nullopt, std::nullopt}}};
    input.path.stages = {full_load(input, {})};
    if (dice.chance(0.2)) input.path.stages[0].control = model::Control::arc_length;
    return input;
}

void expect_path_of_the_motion(const Run& path, double motion_m, const std::string& what) {
    ASSERT_EQ(path.end.reason, model::StopReason::done) << what << path.end.detail;
    double before = 0, energy_J = 0;
    for (const auto& step : path.steps) {
        const double share = step.outputs[0] / motion_m;
        EXPECT_GE(share, before) << what;
        EXPECT_LE(share, 1 + 1e-9) << what;
        EXPECT_GE(step.energies->load_work_J, energy_J) << what;
        EXPECT_NEAR(step.energies->load_work_J, step.energies->stored_J, 1e-3 * step.energies->stored_J) << what;
        before = share;
        energy_J = step.energies->load_work_J;
    }
    EXPECT_NEAR(before, 1, 1e-9) << what;
    EXPECT_GT(energy_J, 0) << what;
}

TEST(Motion, MovesTheFaceInItsOwnDirection) {
    for (std::uint32_t seed = 1; seed <= 40; ++seed) {
        Dice dice{seed};
        const double strain = (dice.chance(0.5) ? 1 : -1) * dice.between_logs(1e-3, 0.1);
        const auto input = moved_block(dice, strain);
        expect_path_of_the_motion(run(input), *input.motions[0].displacement_m[0],
                                  "block " + std::to_string(seed) + ": ");
    }
}

/// Sliding ends: the state is uniaxial, and the energy of incompressible rubber is mu/2 (l^2 + 2/l - 3) per volume.
TEST(Motion, StoresTheEnergyOfTheUniaxialState) {
    for (const double strain : {-0.03, -0.3, 0.03, 0.6}) {
        auto input = box_case(1, true);
        input.loads.clear();
        input.motions = {{"end", {strain * 0.01, std::nullopt, std::nullopt}}};
        input.path.stages = {full_load(input, {})};
        const double l = 1 + strain, expected_J = 0.5 * sample_mu_Pa * (l * l + 2 / l - 3) * 1e-6;
        const auto path = run(input);
        expect_path_of_the_motion(path, strain * 0.01, std::to_string(strain) + ": ");
        EXPECT_NEAR(path.steps.back().energies->stored_J / expected_J, 1, 1e-6) << strain;
    }
}

TEST(Motion, GoesOutAndBackInStages) {
    for (const double strain : {-0.05, 0.05}) {
        auto input = box_case(1, false);
        input.supports[0].fixed = {true, true, true};
        input.loads.clear();
        input.motions = {{"end", {strain * 0.01, std::nullopt, std::nullopt}}};
        auto out = full_load(input, {}), back = out;
        back.motions = {-1.0};
        input.path.stages = {out, back};
        const auto path = run(input);
        ASSERT_EQ(path.end.reason, model::StopReason::done) << path.end.detail;
        EXPECT_NEAR(path.steps.back().outputs[0], -strain * 0.01, 1e-12);
        for (const auto& step : path.steps)
            EXPECT_LE(std::abs(step.outputs[0]), std::abs(strain) * 0.01 + 1e-12) << step.load_factor;
    }
}

}  // namespace
}  // namespace soft::solver
