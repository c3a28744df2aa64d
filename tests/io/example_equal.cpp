/// Equality of all fields, with one expectation per field.
#include <gtest/gtest.h>

#include "example_case.hpp"

namespace soft::io::test {
namespace {

void expect_equal(const model::LimitPoint& left, const model::LimitPoint& right) {
    EXPECT_EQ(left.step, right.step);
    EXPECT_EQ(left.pressure_Pa, right.pressure_Pa);
    EXPECT_EQ(left.volume_m3, right.volume_m3);
    EXPECT_EQ(left.outputs, right.outputs);
}

void expect_equal(const model::StatePoint& left, const model::StatePoint& right) {
    EXPECT_EQ(left.unknowns, right.unknowns);
    EXPECT_EQ(left.tangent_unknowns, right.tangent_unknowns);
    EXPECT_EQ(left.pressures_Pa, right.pressures_Pa);
    EXPECT_EQ(left.tangent_pressures, right.tangent_pressures);
    EXPECT_EQ(left.load_factor, right.load_factor);
    EXPECT_EQ(left.tangent_load_factor, right.tangent_load_factor);
    EXPECT_EQ(left.q, right.q);
    EXPECT_EQ(left.power, right.power);
    EXPECT_EQ(left.outputs, right.outputs);
    EXPECT_EQ(left.unstable_modes, right.unstable_modes);
}

}  // namespace

void expect_equal(const model::Step& left, const model::Step& right) {
    EXPECT_EQ(left.stage, right.stage);
    EXPECT_EQ(left.pressures_Pa, right.pressures_Pa);
    EXPECT_EQ(left.volumes_m3, right.volumes_m3);
    EXPECT_EQ(left.tangent_pressures, right.tangent_pressures);
    EXPECT_EQ(left.tangent_volumes, right.tangent_volumes);
    EXPECT_EQ(left.load_factor, right.load_factor);
    EXPECT_EQ(left.pressure_Pa, right.pressure_Pa);
    EXPECT_EQ(left.volume_m3, right.volume_m3);
    EXPECT_EQ(left.outputs, right.outputs);
    EXPECT_EQ(left.tangent_load_factor, right.tangent_load_factor);
    EXPECT_EQ(left.tangent_pressure, right.tangent_pressure);
    EXPECT_EQ(left.tangent_volume, right.tangent_volume);
    EXPECT_EQ(left.tangent_outputs, right.tangent_outputs);
    EXPECT_EQ(left.newton_iterations, right.newton_iterations);
    EXPECT_EQ(left.factorizations, right.factorizations);
    EXPECT_EQ(left.stable, right.stable);
    EXPECT_EQ(left.stable_under_control, right.stable_under_control);
    EXPECT_EQ(left.stretch_p99, right.stretch_p99);
    EXPECT_EQ(left.max_stretch, right.max_stretch);
    EXPECT_EQ(left.min_jacobian, right.min_jacobian);
    ASSERT_EQ(left.extremes.has_value(), right.extremes.has_value());
    if (left.extremes) {
        EXPECT_EQ(left.extremes->stretch_at_m, right.extremes->stretch_at_m);
        EXPECT_EQ(left.extremes->energy_J_m3, right.extremes->energy_J_m3);
    }
    ASSERT_EQ(left.energies.has_value(), right.energies.has_value());
    if (left.energies) {
        EXPECT_EQ(left.energies->stored_J, right.energies->stored_J);
        EXPECT_EQ(left.energies->load_work_J, right.energies->load_work_J);
        EXPECT_EQ(left.energies->tangent_J, right.energies->tangent_J);
    }
    EXPECT_EQ(left.pressure_error_Pa, right.pressure_error_Pa);
    EXPECT_EQ(left.output_errors, right.output_errors);
    EXPECT_EQ(left.frequencies_Hz, right.frequencies_Hz);
    ASSERT_EQ(left.motion.has_value(), right.motion.has_value());
    if (!left.motion) return;
    EXPECT_EQ(left.motion->time_s, right.motion->time_s);
    EXPECT_EQ(left.motion->kinetic_energy_J, right.motion->kinetic_energy_J);
    EXPECT_EQ(left.motion->stored_energy_J, right.motion->stored_energy_J);
    EXPECT_EQ(left.motion->load_work_J, right.motion->load_work_J);
    EXPECT_EQ(left.motion->damping_work_J, right.motion->damping_work_J);
}

void expect_equal(const model::PathEnd& left, const model::PathEnd& right) {
    EXPECT_EQ(left.reason, right.reason);
    EXPECT_EQ(left.detail, right.detail);
    EXPECT_EQ(left.newton_iterations, right.newton_iterations);
    EXPECT_EQ(left.factorizations, right.factorizations);
    expect_all(left.limit_points, right.limit_points, [](const auto& a, const auto& b) { expect_equal(a, b); });
    expect_all(left.bifurcations, right.bifurcations, [](const auto& a, const auto& b) {
        expect_equal(a.at, b.at);
        EXPECT_EQ(a.modes, b.modes);
        EXPECT_EQ(a.mode, b.mode);
    });
}

void expect_equal(const model::Checkpoint& left, const model::Checkpoint& right) {
    EXPECT_EQ(left.ranks, right.ranks);
    EXPECT_EQ(left.rows, right.rows);
    EXPECT_EQ(left.stage, right.stage);
    EXPECT_EQ(left.start.pressures_Pa, right.start.pressures_Pa);
    EXPECT_EQ(left.start.volumes_m3, right.start.volumes_m3);
    EXPECT_EQ(left.start.masses_kg, right.start.masses_kg);
    EXPECT_EQ(left.start.dead_loads, right.start.dead_loads);
    EXPECT_EQ(left.start.motions, right.start.motions);
    EXPECT_EQ(left.control, right.control);
    EXPECT_EQ(left.controlled, right.controlled);
    EXPECT_EQ(left.stage_first_row, right.stage_first_row);
    EXPECT_EQ(left.user_control_failed, right.user_control_failed);
    EXPECT_EQ(left.on_branch, right.on_branch);
    EXPECT_EQ(left.confirmed_pivots, right.confirmed_pivots);
    EXPECT_EQ(left.pending_factorizations, right.pending_factorizations);
    ASSERT_EQ(left.before.has_value(), right.before.has_value());
    if (left.before) expect_equal(*left.before, *right.before);
    expect_equal(left.last, right.last);
    EXPECT_EQ(left.step, right.step);
    EXPECT_EQ(left.first_step, right.first_step);
    EXPECT_EQ(left.first_slope, right.first_slope);
    EXPECT_EQ(left.visited, right.visited);
}

}  // namespace soft::io::test
