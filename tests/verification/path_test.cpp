// How paths end and what meshes converge to; the numbers themselves are in the table (verification_test).
#include <gtest/gtest.h>

#include <cmath>

#include "inflation_formula.hpp"
#include "run_design.hpp"

namespace soft::verification {
namespace {

TEST(Tube, VolumeControlPassesTheLimitPointToFiveTimesTheVolume) {
    const auto run = run_design("tube.yaml", {});
    EXPECT_EQ(run.end.reason, solution::StopReason::done);
    EXPECT_EQ(run.end.limit_points.size(), 1u);
    EXPECT_NEAR(*run.steps.back().volume_m3 / *run.steps.front().volume_m3, 5.0, 1e-8);
}

TEST(Tube, PressureControlEndsAtTheLimitPointWithTheCurveUpToIt) {
    const auto run = run_design("tube.yaml", {"path.control=pressure"});
    EXPECT_EQ(run.end.reason, solution::StopReason::limit_point);
    EXPECT_NEAR(run.pressure_kPa() / 44.3387, 1.0, 5e-4);  // independent code
    EXPECT_NEAR(run.output_mm() / 13.45, 1.0, 2e-3);
    for (std::size_t i = 1; i < run.steps.size(); ++i)
        EXPECT_GT(run.steps[i].pressure_Pa, run.steps[i - 1].pressure_Pa);
}

// At rest every fibre is about to pull: the first tangent is one-sided and errs by the same part of a step of any length.
TEST(Tube, FibresThatBeginToPullDoNotStopThePath) {
    const auto run = run_design("tube.yaml", {"material={law: holzapfel-gasser-ogden, mu: 0.1644 MPa, k1: 0.1 MPa, k2: 1, "
                                              "angle: 30 deg}",
                                              "loads.cavity.pressure=20 kPa"});
    EXPECT_EQ(run.end.reason, solution::StopReason::done);
    EXPECT_NEAR(run.pressure_kPa(), 20.0, 1e-9);
    EXPECT_LT(run.output_mm(), 0.0);   // fibres nearer to the axis than the magic angle 54.74 degrees: it shortens
}

TEST(Bellows, AnElongationAsGoalIsMetExactly) {
    const auto run = run_design("bellows.yaml", {"mesh.size=3 mm", "path.until.elongation=20 mm"});
    EXPECT_EQ(run.end.reason, solution::StopReason::done);
    EXPECT_NEAR(run.output_mm(), 20.0, 1e-6);
}

// The same section swept over a quarter turn: what differs is the discretisation around the axis alone.
TEST(Bellows, QuarterSolidAgreesWithTheAxisymmetricSection) {
    const std::vector<std::string> coarse{"mesh.size=3 mm", "mesh.through_wall=1", "path.until.elongation=40 mm"};
    auto quarter = coarse;
    quarter.insert(quarter.end(), {"model=quarter", "mesh.sectors=4"});
    const auto section = run_design("bellows.yaml", coarse), solid = run_design("bellows.yaml", quarter);
    EXPECT_NEAR(solid.pressure_kPa() / section.pressure_kPa(), 1.0, 3e-3);
    EXPECT_NEAR(*solid.steps.back().volume_m3 / *section.steps.back().volume_m3, 1.0, 3e-3);
}

TEST(Sphere, WholeCurveIsTheClosedFormOnBothSidesOfTheLimitPoint) {
    const auto run = run_design("sphere.yaml", {});
    EXPECT_EQ(run.end.reason, solution::StopReason::done);
    for (std::size_t i = 1; i < run.steps.size(); ++i) {
        const double l = std::cbrt(*run.steps[i].volume_m3 / *run.steps.front().volume_m3);
        EXPECT_NEAR(run.steps[i].pressure_Pa / neo_hookean_sphere_pressure_Pa(0.1644e6, l, 2), 1.0, 1e-3);
    }
    EXPECT_NEAR(*run.steps.back().volume_m3 / *run.steps.front().volume_m3, 27.0, 1e-6);
}

TEST(Sphere, FinerMeshesConvergeToTheClosedForm) {
    const auto error = [](const char* size) {
        const auto run = run_design("sphere.yaml", {std::string("mesh.size=") + size, "path.until.volume_ratio=3.375"});
        return std::abs(run.steps.back().pressure_Pa / neo_hookean_sphere_pressure_Pa(0.1644e6, 1.5, 2) - 1.0);
    };
    EXPECT_LT(error("2.5 mm"), 0.2 * error("5 mm"));  // third order or better
}

}  // namespace
}  // namespace soft::verification
