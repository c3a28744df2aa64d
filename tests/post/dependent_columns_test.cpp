/// Interpolation of dependent columns between rows: stretches, known at the rows only, and energies, whose power may be known too.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "path_samples.hpp"
#include "post/interpolate.hpp"
#include "post/request.hpp"

namespace soft::post {
namespace {

enum class Power { recorded, unknown };

/// A rod stretched and released, with rows at these stretches. The stored energy of an incompressible neo-Hookean rod with mu V = 1 is
/// (l^2 + 2/l - 3)/2. The elongation is the coordinate of the path; stretch and energy are dependent columns.
Curve stretched_and_released(const std::vector<double>& up, const std::vector<double>& down,
                             Power power = Power::unknown) {
    model::Case model = test::sample_case({"elongation"}, test::Loaded::nothing);
    model.path.stages.resize(2);
    std::vector<model::Step> steps;
    const auto add = [&](int stage, double stretch, double direction) {
        model::Step step;
        step.stage = stage;
        step.outputs = {stretch - 1};
        step.tangent_outputs = {direction};
        step.tangent_pressure = 0;
        step.stretch_p99 = step.max_stretch = stretch;
        step.energies = {(stretch * stretch + 2 / stretch - 3) / 2, 0, {}};
        if (power == Power::recorded) step.energies->tangent_J = direction * (stretch - 1 / (stretch * stretch));
        steps.push_back(step);
    };
    for (const double stretch : up) add(0, stretch, 1);
    for (const double stretch : down) add(1, stretch, -1);
    return make_curve(model, steps);
}

/// The rows at these stretches in both stages: each stretch is crossed once per stage.
Curve rows_of_both_stages(const Curve& curve, std::span<const double> stretches) {
    std::vector<Request> requests;
    for (const double stretch : stretches) requests.push_back({"elongation", stretch - 1});
    return rows_at(curve, requests);
}

TEST(DependentColumnsAtAStageChange, KeepTheirSlope) {
    const Curve curve = stretched_and_released({1, 1.01, 1.04, 1.1, 1.25, 1.5}, {1.49, 1.46, 1.4, 1.25, 1});
    const std::vector<double> stretches{1.3, 1.4, 1.45, 1.495};
    const Curve rows = rows_of_both_stages(curve, stretches);
    ASSERT_EQ(rows.row_count(), 8u);
    for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(rows.find("stretch_p99")->values[i], stretches[i / 2], 1e-12) << i;
}

/// Rows as from `solve`, with steps growing from 1 to 25 mm: values at rows determine the energy to 0.15 % of its maximum.
TEST(DependentColumnsAtAStageChange, InterpolateTheEnergyBetweenDistantRows) {
    const Curve curve = stretched_and_released({1, 1.01, 1.035, 1.0975, 1.254, 1.5}, {1.49, 1.465, 1.4025, 1.246, 1});
    const std::vector<double> stretches{1.3, 1.35, 1.4, 1.45, 1.48};
    const Curve rows = rows_of_both_stages(curve, stretches);
    ASSERT_EQ(rows.row_count(), 10u);
    constexpr double largest = (1.5 * 1.5 + 2 / 1.5 - 3) / 2;
    for (std::size_t i = 0; i < 10; ++i) {
        const double l = stretches[i / 2], energy = (l * l + 2 / l - 3) / 2;
        EXPECT_NEAR(rows.find("stored_energy")->values[i] / 1e3, energy, 1.5e-3 * largest) << i;
    }
}

/// With the power at the rows, the error of a cubic is at most h^4/384 times the fourth derivative of the energy, 24/l^5. Relative to
/// the largest energy this is 2.8e-4 for h = 0.25 from a stretch of 1.25 (or 0.2 from 1.05), and 7.9e-4 for the last unloading step to 1.
/// Near the undeformed state, where the energy is quadratic, the relative error is small too.
TEST(DependentColumnsAtAStageChange, InterpolateTheEnergyFromItsPower) {
    const Curve curve = stretched_and_released({1, 1.05, 1.25, 1.5}, {1.49, 1.465, 1.4025, 1.246, 1}, Power::recorded);
    const std::vector<double> stretches{1.01, 1.02, 1.04, 1.1, 1.2, 1.3, 1.4, 1.48};
    const Curve rows = rows_of_both_stages(curve, stretches);
    ASSERT_EQ(rows.row_count(), 16u);
    constexpr double largest = (1.5 * 1.5 + 2 / 1.5 - 3) / 2;
    for (std::size_t i = 0; i < 16; ++i) {
        const double l = stretches[i / 2], energy = (l * l + 2 / l - 3) / 2;
        const bool last_step = i % 2 == 1 && l < 1.246;
        EXPECT_NEAR(rows.find("stored_energy")->values[i] / 1e3, energy, (last_step ? 7.9e-4 : 2.8e-4) * largest) << i;
        if (i % 2 == 0 && l < 1.05) {
            EXPECT_NEAR(rows.find("stored_energy")->values[i] / 1e3 / energy, 1, 0.01) << i;
        }
    }
}

/// Elongation and load factor are both linear, and the directions differ only by rounding, which must not influence the speeds.
TEST(DependentColumnsAtAStageChange, InterpolateTheEnergyOfAStraightPath) {
    model::Case model = test::sample_case({"elongation"}, test::Loaded::nothing);
    for (const double noise : {0.0, 1e-16, 3e-16, -2e-16, 1e-13}) {
        std::vector<model::Step> steps;
        for (const double stretch : {1.25, 1.5}) {
            model::Step step;
            step.outputs = {0.1 * (stretch - 1)};
            step.pressure_Pa = step.load_factor = (stretch - 1) / 0.5;
            step.tangent_outputs = {0.05 * (stretch > 1.3 ? 1 + noise : 1)};
            step.tangent_pressure = step.tangent_load_factor = 1;
            step.energies = {(stretch * stretch + 2 / stretch - 3) / 2, 0, 0.5 * (stretch - 1 / (stretch * stretch))};
            steps.push_back(step);
        }
        const Curve curve = make_curve(model, steps);
        const Curve row = rows_at(curve, std::vector<Request>{{"elongation", 0.04}});
        const double energy = (1.4 * 1.4 + 2 / 1.4 - 3) / 2;
        EXPECT_NEAR(row.find("stored_energy")->values[0] / 1e3, energy, 2.8e-4 * energy) << noise;
    }
}

TEST(DependentColumnsAtAStageChange, AreLinearInAStageWithASingleInterval) {
    const Curve curve = stretched_and_released({1, 1.5}, {1.25});
    const std::vector<double> stretches{1.3, 1.4, 1.45};
    const Curve rows = rows_of_both_stages(curve, stretches);
    ASSERT_EQ(rows.row_count(), 6u);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(rows.find("max_stretch")->values[i], stretches[i / 2], 1e-12) << i;
}

/// Largest error of the energy in the last interval before the stage change and the first after it.
double energy_error_at_stage_change(int rows_per_stage) {
    std::vector<double> up, down;
    for (int i = 0; i <= rows_per_stage; ++i) up.push_back(1 + 0.5 * i / rows_per_stage);
    for (int i = 1; i <= rows_per_stage; ++i) down.push_back(1.5 - 0.5 * i / rows_per_stage);
    const Curve curve = stretched_and_released(up, down);
    double worst = 0;
    for (int k = 1; k < 20; ++k) {
        const double stretch = 1.5 - 0.5 / rows_per_stage * k / 20;
        const Curve rows = rows_of_both_stages(curve, std::array{stretch});
        for (const double energy_mJ : rows.find("stored_energy")->values)
            worst = std::max(worst, std::abs(energy_mJ / 1e3 - (stretch * stretch + 2 / stretch - 3) / 2));
    }
    return worst;
}

TEST(DependentColumnsAtAStageChange, ConvergeWithThirdOrder) {
    EXPECT_LT(energy_error_at_stage_change(8), 2e-4);  // a zero slope there would give an error of 4/27 h dW/dl: 1e-2
    EXPECT_GT(std::log2(energy_error_at_stage_change(8) / energy_error_at_stage_change(16)), 2.7);
}

/// A column without slopes increases up to the stage change and decreases after it, so the interpolant must stay between the rows.
TEST(DependentColumnsAtAStageChange, StayBetweenTheRows) {
    for (const double stretch : {1.1, 1.3, 1.45}) {
        const Curve curve = stretched_and_released({1, 1.02, stretch, 1.5}, {stretch, 1.48, 1.2, 1.1, 1});
        const Path path(curve);
        const auto& values = curve.find("stored_energy")->values;
        const auto range = path.range(test::index_of(curve, "stored_energy"));
        EXPECT_EQ(range.highest, values[3]);
        EXPECT_EQ(range.lowest, 0);
    }
}

}  // namespace
}  // namespace soft::post
