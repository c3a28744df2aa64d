#include <gtest/gtest.h>

#include <cmath>

#include "../fem/sample_cases.hpp"
#include "core/error.hpp"
#include "solver/stage_loads.hpp"

namespace soft::solver {
namespace {

TEST(Gas, PressureAndMassAreInverseToEachOther) {
    const model::Gas gas{.dead_volume_m3 = 3e-6, .exponent = 1.4};
    for (const double pressure : {-4e4, 0.0, 5e4})
        EXPECT_NEAR(gas_pressure_Pa(gas, 2e-6, gas_mass_kg(gas, 2e-6, pressure)), pressure, 1e-6);
}

// Boyle: half the volume, twice the absolute pressure. Poisson: p V^1.4 is constant.
TEST(Gas, FollowsBoyleAndPoisson) {
    model::Gas gas;
    const double mass = gas_mass_kg(gas, 4e-6, 0.0);
    EXPECT_NEAR(mass, 1.204 * 4e-6, 1e-18);
    EXPECT_NEAR(gas_pressure_Pa(gas, 2e-6, mass), gas.ambient_Pa, 1e-6);
    gas.exponent = 1.4;
    EXPECT_NEAR(gas_pressure_Pa(gas, 2e-6, mass) + gas.ambient_Pa, gas.ambient_Pa * std::pow(2.0, 1.4), 1e-6);
}

model::Case supplied(model::SupplyTarget target) {
    auto input = sphere_case(1, 2);
    input.loads[0].gas.dead_volume_m3 = 1e-6;
    input.loads[0].gas.exponent = 1.3;
    input.path.stages[0].supplies = {target};
    return input;
}

TEST(Gas, IsNotRemovedBeyondWhatTheCavityContains) {
    const std::vector<double> undeformed{4e-6};
    const double content_kg = 1.204 * 5e-6;
    EXPECT_NO_THROW(require_gas(supplied({model::Prescription::mass, -0.99 * content_kg}), undeformed));
    try {
        require_gas(supplied({model::Prescription::mass, -1.01 * content_kg}), undeformed);
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(
            std::string(error.what()).find("6.0802 mg of gas are removed, and the undeformed cavity contains 6.02 mg"),
            std::string::npos)
            << error.what();
    }
}

TEST(StageLoads, SupplyEquationsHaveExactDerivatives) {
    const std::vector<double> undeformed{4e-6};
    for (const auto target : {model::SupplyTarget{model::Prescription::volume, 9e-6},
                              {model::Prescription::volume_ratio, 3.0},
                              {model::Prescription::mass, 5e-6},
                              {model::Prescription::closed, 0.0}}) {
        const auto input = supplied(target);
        auto start = unloaded(input, undeformed);
        start.pressures_Pa = {2e4};
        start.volumes_m3 = {5e-6};
        start.masses_kg = {gas_mass_kg(input.loads[0].gas, 5e-6, 2e4)};
        const StageLoads loads(input, 0, start, undeformed);
        ASSERT_EQ(loads.free_supplies().size(), 1u);
        const double V = 6e-6, p = 1.5e4, l = 0.4, h = 1e-4;
        const auto e = loads.equation(0, V, p, l);
        const auto slope = [&](double dV, double dp, double dl) {
            return (loads.equation(0, V + dV, p + dp, l + dl).value - loads.equation(0, V - dV, p - dp, l - dl).value) /
                   2;
        };
        EXPECT_NEAR(slope(h * V, 0, 0), h * V * e.by_volume, 1e-6 * h);
        EXPECT_NEAR(slope(0, h * p, 0), h * p * e.by_pressure, 1e-6 * h);
        EXPECT_NEAR(slope(0, 0, h), h * e.by_load_factor, 1e-6 * h);
    }
}

TEST(StageLoads, AStageStartsFromTheCurrentSupplies) {
    const std::vector<double> undeformed{4e-6};
    for (const auto target : {model::SupplyTarget{model::Prescription::volume, 9e-6},
                              {model::Prescription::mass, 5e-6},
                              {model::Prescription::closed, 0.0}}) {
        const auto input = supplied(target);
        auto start = unloaded(input, undeformed);
        start.pressures_Pa = {2e4};
        start.volumes_m3 = {5e-6};
        start.masses_kg = {gas_mass_kg(input.loads[0].gas, 5e-6, 2e4)};
        const StageLoads loads(input, 0, start, undeformed);
        EXPECT_NEAR(loads.equation(0, 5e-6, 2e4, 0.0).value, 0.0, 1e-12);
        EXPECT_EQ(loads.changes(), target.what != model::Prescription::closed);
    }
}

TEST(StageLoads, LevelsAreLinearFromStartToEnd) {
    auto input = sphere_case(1, 2);
    input.path.stages[0].supplies[0].value = 8e3;
    auto start = unloaded(input, {4e-6});
    start.pressures_Pa = {2e3};
    const StageLoads loads(input, 0, start, {4e-6});
    EXPECT_DOUBLE_EQ(loads.levels(0.25, {}).pressures_Pa[0], 3.5e3);
    EXPECT_DOUBLE_EQ(loads.rate().pressures_Pa[0], 6e3);
}

}  // namespace
}  // namespace soft::solver
