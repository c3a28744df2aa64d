// Options of loads, materials and outputs, each compared with an independently known state.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "run_design.hpp"

namespace soft::verification {
namespace {

/// The thrust of a plug is a dead force on the face around it: without plug thrust, the same explicit force gives the same state.
TEST(Plugs, ThrustEqualsAnExplicitForceOnTheFace) {
    const std::vector<std::string> common{"mesh.size=3 mm", "path={control: pressure}"};
    auto plugged = common, carried = common;
    plugged.push_back("loads={cavity: {pressure: 10 kPa}}");
    const double force_N = 10e3 * std::numbers::pi * 2.5e-3 * 2.5e-3;
    carried.push_back("loads={cavity: {pressure: 10 kPa, plug_thrust: false}, inlet: {force: " +
                      std::to_string(force_N) + " N, along: axis}}");
    const auto with = run_design("bellows.yaml", plugged), without = run_design("bellows.yaml", carried);
    EXPECT_NEAR(without.output_mm() / with.output_mm(), 1.0, 1e-6);
    carried.back() = "loads={cavity: {pressure: 10 kPa, plug_thrust: false}}";
    EXPECT_LT(run_design("bellows.yaml", carried).output_mm(), 0.97 * with.output_mm());
}

/// Two independent shells: twice the modulus at twice the pressure gives the same state.
TEST(TwoSpheres, EachUsesItsOwnMaterial) {
    const auto run =
        run_design("two-spheres.yaml",
                   {"materials={right: {law: neo-hookean, mu: 0.3288 MPa, kappa: incompressible}}",
                    "loads={cavities: {left: {pressure: 5 kPa}, right: {pressure: 10 kPa}}}", "path.control=pressure"});
    const auto &first = run.steps.front(), &last = run.steps.back();
    ASSERT_EQ(last.volumes_m3.size(), 2u);
    EXPECT_NEAR(last.pressures_Pa.at(1), 1e4, 1e-6);
    EXPECT_GT(last.volumes_m3[0] / first.volumes_m3[0], 1.02);
    EXPECT_NEAR(last.volumes_m3[1] / last.volumes_m3[0], 1.0, 1e-8);
}

/// An incompressible sphere deforms as r^3 = R^3 + a^3 - A^3 for every law. A = 10 mm, B = 20 mm, volume ratio 3.375: a = 15 mm.
TEST(Outputs, PointsOfAThickSphereMatchTheIncompressibleMotion) {
    const auto run =
        run_design("sphere.yaml",
                   {"mesh.size=1 mm", "loads={cavity: {volume_ratio: 3.375}}", "path={control: auto}",
                    "outputs={pole: {point: [10 mm, 0 mm], along: x}, equator: {point: [0 mm, 20 mm], along: r}, "
                    "within_x: {point: [9.1 mm, 11.3 mm], along: x}, within_r: {point: [9.1 mm, 11.3 mm], along: r}}"});
    const auto moved = [](double x_mm, double r_mm) {
        const double R = std::hypot(x_mm, r_mm);
        return std::cbrt(R * R * R + 3375.0 - 1000.0) / R - 1.0;
    };
    ASSERT_EQ(run.steps.back().outputs.size(), 4u);
    EXPECT_NEAR(run.output_mm(0), 10 * moved(10, 0), 2e-3);
    EXPECT_NEAR(run.output_mm(1), 20 * moved(0, 20), 2e-3);
    EXPECT_NEAR(run.output_mm(2), 9.1 * moved(9.1, 11.3), 2e-3);
    EXPECT_NEAR(run.output_mm(3), 11.3 * moved(9.1, 11.3), 2e-3);
}

}  // namespace
}  // namespace soft::verification
