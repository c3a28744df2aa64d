/// Cavities whose pressure is not prescribed: volume, mass, a closed valve, one gas for two.
#include <gtest/gtest.h>

#include <cmath>

#include "bench.hpp"
#include "sphere.hpp"

namespace soft::solver {
namespace {

using model::Prescription;

double relative_pressure(const model::Step& step) { return step.pressure_Pa / sample_mu_Pa; }

TEST(Supply, PrescribedVolumeGivesThePressureOfTheClosedForm) {
    auto input = sphere_case(4, 8);
    input.path.stages[0].supplies = {{Prescription::volume_ratio, 8.0}};  // l_a = 2
    const auto [steps, end, log] = run(input);
    EXPECT_EQ(end.reason, model::StopReason::done);
    EXPECT_NEAR(inner_stretch(steps.back()), 2.0, 1e-5);  // the mesh is not exactly spherical
    EXPECT_NEAR(relative_pressure(steps.back()), 0.806927, 1e-4);
    ASSERT_EQ(end.limit_points.size(), 1u);
    EXPECT_NEAR(end.limit_points[0].pressure_Pa / sample_mu_Pa / sphere_limit, 1.0, 1e-4);
    EXPECT_TRUE(end.bifurcations.empty());
    for (const auto& step : steps) EXPECT_TRUE(step.stable);  // a prescribed volume stabilises the body
}

// Both laws at once: the sphere's closed form and the gas.
TEST(Supply, InjectedMassFillsTheSphereByTheGasLaw) {
    auto input = sphere_case(4, 8);
    input.loads[0].gas = {.dead_volume_m3 = 2e-6, .exponent = 1.4};
    input.path.stages[0].supplies = {{Prescription::mass, 4e-5}};
    const auto [steps, end, log] = run(input);
    EXPECT_EQ(end.reason, model::StopReason::done);
    const auto& last = steps.back();
    EXPECT_NEAR(relative_pressure(last), sphere_pressure(inner_stretch(last)), 1e-4);
    const double density = (1.204 * (*steps.front().volume_m3 + 2e-6) + 4e-5) / (*last.volume_m3 + 2e-6);
    EXPECT_NEAR(last.pressure_Pa + 101325.0, 101325.0 * std::pow(density / 1.204, 1.4), 1e-3);
    EXPECT_GT(inner_stretch(last), 1.5);
}

// Closed at 40 kPa, then loaded from outside: p V^n of the gas is constant.
TEST(Supply, AClosedValveConservesTheGas) {
    auto input = sphere_case(3, 6);
    input.loads[0].gas = {.dead_volume_m3 = 1e-6, .exponent = 1.4};
    input.loads.push_back({.name = "outer", .targets = {"outer"}, .gas = {}});
    input.path.stages = {full_load(input, {4e4, 0.0}), full_load(input, {0.0, 3e4})};
    input.path.stages[1].supplies[0] = {Prescription::closed, 0.0};
    const auto [steps, end, log] = run(input);
    EXPECT_EQ(end.reason, model::StopReason::done);
    const auto invariant = [](const model::Step& step) {
        return (step.pressures_Pa[0] + 101325.0) * std::pow(*step.volume_m3 + 1e-6, 1.4);
    };
    std::optional<double> closed;
    for (const auto& step : steps) {
        if (step.stage == 0 && step.load_factor == 1.0) closed = invariant(step);
        if (step.stage == 1) {
            EXPECT_NEAR(invariant(step) / closed.value(), 1.0, 1e-8);
        }
    }
    EXPECT_NEAR(steps.back().pressures_Pa[1], 3e4, 1e-6);
    EXPECT_GT(steps.back().pressures_Pa[0], 4e4 + 1e3);
    // Only the pressure difference acts on an incompressible wall.
    EXPECT_NEAR((steps.back().pressures_Pa[0] - 3e4) / sample_mu_Pa, sphere_pressure(inner_stretch(steps.back())),
                2e-4);
}

// A cavity is filled while an outside pressure acts on its body. The outside load does negative work, but the body is stable and the
// volume must grow, not fall. Only the pressure difference acts on an incompressible wall.
TEST(Supply, ACavityIsFilledAgainstAnOutsidePressure) {
    for (const auto control : {model::Control::automatic, model::Control::arc_length, model::Control::pressure})
        for (const auto& supply : {model::SupplyTarget{Prescription::volume_ratio, 3.375}, {Prescription::mass, 4e-5}})
            for (const int stages : {1, 2}) {
                auto input = sphere_case(3, 6);
                input.loads.push_back({.name = "outer", .targets = {"outer"}, .gas = {}});
                auto first = full_load(input, {0.0, 1e4}), second = full_load(input, {0.0, 3e4});
                first.supplies[0] = {Prescription::volume_ratio, 1.2};
                second.supplies[0] = supply;
                input.path.stages = {second};
                if (stages == 2) input.path.stages = {first, second};
                for (auto& stage : input.path.stages) stage.control = control;
                const auto [steps, end, log] = run(input);
                ASSERT_EQ(end.reason, model::StopReason::done) << end.detail;
                for (std::size_t i = 1; i < steps.size(); ++i) EXPECT_GT(*steps[i].volume_m3, *steps[i - 1].volume_m3);
                const auto& last = steps.back();
                EXPECT_GT(inner_stretch(last), 1.4);
                EXPECT_NEAR(last.pressures_Pa[1], 3e4, 1e-6);
                EXPECT_NEAR((last.pressures_Pa[0] - 3e4) / sample_mu_Pa, sphere_pressure(inner_stretch(last)), 2e-4);
            }
}

TEST(Supply, AStageWithoutChangeIsOneRow) {
    auto input = sphere_case(2, 4);
    input.path.stages = {full_load(input, {3e4}), full_load(input, {3e4}), full_load(input, {0.0})};
    const auto [steps, end, log] = run(input);
    EXPECT_EQ(end.reason, model::StopReason::done);
    int rows = 0;
    for (const auto& step : steps)
        if (step.stage == 1) {
            ++rows;
            EXPECT_NEAR(step.pressure_Pa, 3e4, 1e-9);
        }
    EXPECT_EQ(rows, 1);
    EXPECT_NEAR(steps.back().pressure_Pa, 0.0, 1e-9);
    EXPECT_NEAR(inner_stretch(steps.back()), 1.0, 1e-4);  // undeformed again
}

// Inflated past its limit point by volume, then vented: the path returns over the maximum instead of leaving it.
TEST(Supply, VentingBeyondTheLimitPointDeflatesTheSphere) {
    auto input = sphere_case(3, 6);
    auto inflate = full_load(input, {0.0}), vent = full_load(input, {0.0});
    inflate.supplies = {{Prescription::volume_ratio, 8.0}};
    input.path.stages = {inflate, vent};
    const auto [steps, end, log] = run(input);
    EXPECT_EQ(end.reason, model::StopReason::done);
    EXPECT_EQ(end.limit_points.size(), 2u);
    EXPECT_NEAR(inner_stretch(steps.back()), 1.0, 1e-4);
}

// A load that falls past its maximum is abandoned; a volume that still approaches its target is not.
TEST(Supply, TheStretchLimitEndsOnlyALoadThatIsNeverReached) {
    auto input = sphere_case(3, 6);
    input.path.stretch_limit = 1.5;
    auto never = input;
    never.path.stages = {full_load(input, {2 * sample_mu_Pa})};
    const auto abandoned = run(never);
    EXPECT_EQ(abandoned.end.reason, model::StopReason::limit_point);
    EXPECT_NE(abandoned.end.detail.find("stretch_limit"), std::string::npos);
    input.path.stages[0].supplies = {{Prescription::volume_ratio, 8.0}};
    EXPECT_EQ(run(input).end.reason, model::StopReason::done);
}

// Two equal spheres with a common gas stay equal up to the maximum of the pressure; there one grows while the other shrinks
// (Weinitschke and others; here by p(V1) = p(V2), V1 + V2 given, of the closed form).
TEST(Supply, TwoSpheresOnOneGasBranchAtTheMaximumOfThePressure) {
    const auto input = two_spheres_case(3, 6, 12.0);
    const auto [steps, end, log] = run(input);
    EXPECT_EQ(end.reason, model::StopReason::done);
    ASSERT_EQ(end.bifurcations.size(), 1u);
    EXPECT_EQ(end.bifurcations[0].modes, 1);
    EXPECT_NEAR(end.bifurcations[0].at.pressure_Pa / sample_mu_Pa / sphere_limit, 1.0, 1e-4);
    EXPECT_NEAR(std::cbrt(*end.bifurcations[0].at.volume_m3 / (2 * sphere_cavity_m3)), 1.8281, 1e-3 * 1.8281);
    const auto row = static_cast<std::size_t>(end.bifurcations[0].at.step);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        EXPECT_NEAR(steps[i].volumes_m3[0] / steps[i].volumes_m3[1], 1.0, 1e-6);  // the primary path stays symmetric
        if (i != row) {
            EXPECT_EQ(steps[i].stable, i < row) << i;
        }
    }
    // The mode is one sphere against the other.
    const auto& mode = end.bifurcations[0].mode;
    ASSERT_EQ(mode.size(), 3 * input.mesh.points.size());
    const std::size_t half = mode.size() / 2;
    double difference = 0;
    for (std::size_t i = 0; i < half; ++i) difference = std::max(difference, std::abs(mode[i] + mode[half + i]));
    EXPECT_LT(difference, 1e-3);
}

TEST(Supply, TheAsymmetricBranchOfTwoSpheresHasOnePressureAndTheGivenVolume) {
    auto input = two_spheres_case(3, 6, 12.0);
    input.path.branch = model::Branch::follow;
    input.path.imperfection_m = 5e-4;
    const auto [steps, end, log] = run(input);
    EXPECT_EQ(end.reason, model::StopReason::done);
    const auto& last = steps.back();
    const auto stretch = [&](int which) {
        return std::cbrt(last.volumes_m3[static_cast<std::size_t>(which)] / sphere_cavity_m3);
    };
    EXPECT_GT(std::abs(stretch(0) - stretch(1)), 0.5);
    for (const int which : {0, 1}) EXPECT_NEAR(relative_pressure(last), sphere_pressure(stretch(which)), 3e-4);
    EXPECT_NEAR((last.volumes_m3[0] + last.volumes_m3[1]) / (24.0 * sphere_cavity_m3), 1.0, 1e-4);
}

}  // namespace
}  // namespace soft::solver
