#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "design/locking.hpp"
#include "sample.hpp"

namespace {

using namespace soft::design;
using namespace soft::design::sample;

/// Expects exactly one warning, which starts with the key and contains the words.
void expect_warning(const std::vector<Override>& changes, std::string_view key, std::string_view words) {
    const Design design = read(minimal_design, changes);
    ASSERT_EQ(design.warnings.size(), 1u) << (design.warnings.empty() ? std::string{} : design.warnings.back());
    EXPECT_EQ(design.warnings[0].find(key), 0u) << design.warnings[0];
    EXPECT_TRUE(contains(design.warnings[0], words)) << design.warnings[0];
}

TEST(Plausibility, WarnsAboutAModulusInTheWrongUnit) {
    expect_warning({{"material.mu", "2 Pa"}, {"loads.cavity.pressure", "1 Pa"}}, "material:", "unusual for a silicone");
    expect_warning({{"material.mu", "164.4 MPa"}}, "material:", "unusual for a silicone");
}

TEST(Plausibility, WarnsAboutAPressureFarAboveTheModulus) {
    expect_warning({{"loads.cavity.pressure", "30 MPa"}}, "loads.cavity.pressure:", "far above");
}

TEST(Plausibility, WarnsAboutAPressureFarBelowTheModulus) {
    expect_warning({{"loads.cavity.pressure", "0.03 Pa"}}, "loads.cavity.pressure:", "far below");
    EXPECT_TRUE(read(minimal_design, {{"loads.cavity.pressure", "10 Pa"}}).warnings.empty());
}

TEST(Plausibility, AClosedValveActsWithoutStages) {
    const std::vector<Override> valve{{"loads", "{cavity: {valve: closed}, outer: {pressure: 5 kPa}}"}};
    const Design design = read(minimal_design, valve);
    EXPECT_TRUE(design.warnings.empty()) << design.warnings[0];
}

TEST(Plausibility, WarnsAboutALoadThatContinuesToChangeInAHoldStage) {
    const auto stages = [](const std::string& until, const std::string& hold) {
        return std::vector<Override>{
            {"path.stages", "{a: {loads: {cavity: {pressure: 30 kPa}}" + until + "}, hold: " + hold + "}"}};
    };
    expect_warning(stages(", until: {steps: 3}", "{}"), "path.stages.hold:", "full value of stage a");
    EXPECT_TRUE(read(minimal_design, stages("", "{}")).warnings.empty());
    EXPECT_TRUE(
        read(minimal_design, stages(", until: {steps: 3}", "{loads: {cavity: {pressure: 30 kPa}}}")).warnings.empty());
}

TEST(Plausibility, WarnsAboutALoadThatActsInNoStage) {
    const auto stages = [](const std::string& load) {
        return std::vector<Override>{
            {"path.stages", "{a: {loads: {cavity: " + load + "}}, b: {loads: {cavity: {pressure: 0 kPa}}}}"}};
    };
    expect_warning(stages("{pressure: 40 kPa}"), "loads.cavity.pressure:", "acts in no stage");
    EXPECT_TRUE(read(minimal_design, stages("{pressure: 30 kPa}")).warnings.empty());
}

TEST(Plausibility, WarnsAboutMissingVolumetricDampingOfMixedCells) {
    const auto damped = [](const std::string& kappa, const std::string& formulation) {
        return std::vector<Override>{{"material.kappa", kappa},
                                     {"material.density", "1000 kg/m^3"},
                                     {"mesh.formulation", formulation},
                                     {"dynamics", "{duration: 1 s, stiffness_damping: 1 ms}"}};
    };
    const auto warned = [&](const std::string& kappa, const std::string& formulation) {
        return std::ranges::count_if(
            read(minimal_design, damped(kappa, formulation)).warnings, [](const std::string& warning) {
                return warning.starts_with("dynamics.stiffness_damping: ") && contains(warning, "changes of shape");
            });
    };
    EXPECT_EQ(warned("2 MPa", "mixed"), 1);
    EXPECT_EQ(warned("16 MPa", "mixed"), 0);
    EXPECT_EQ(warned("2 MPa", "displacement"), 0);
}

TEST(Plausibility, WarnsAboutAnAbsolutePressure) {
    expect_warning({{"loads.cavity.pressure", "101.325 kPa"}}, "loads.cavity.pressure:", "gauge");
    expect_warning({{"loads.cavity.pressure", "1.013 bar"}}, "loads.cavity.pressure:", "gauge");
    EXPECT_TRUE(read(minimal_design, {{"loads.cavity.pressure", "100 kPa"}}).warnings.empty());
}

TEST(Plausibility, WarnsAboutGravityDensityAndFibreAnglesInAWrongUnitOrSign) {
    const auto falling = [](const std::string& acceleration, const std::string& density) {
        return std::vector<Override>{{"loads.gravity", "{acceleration: " + acceleration + ", along: axis}"},
                                     {"material.density", density}};
    };
    EXPECT_TRUE(read(minimal_design, falling("9.81 m/s^2", "1080 kg/m^3")).warnings.empty());
    expect_warning(falling("9810 m/s^2", "1080 kg/m^3"), "loads.gravity.acceleration:", "1e+03 times gravity");
    expect_warning(falling("-9.81 m/s^2", "1080 kg/m^3"), "loads.gravity.acceleration:", "points the other way");
    expect_warning(falling("9.81 m/s^2", "1.08 kg/m^3"), "material.density:", "unusual for a rubber");
    const auto wound = [](const std::string& angle) {
        return std::vector<Override>{
            {"material", "{law: holzapfel-gasser-ogden, mu: 0.1644 MPa, k1: 0.1 MPa, k2: 1, angle: " + angle + "}"}};
    };
    expect_warning(wound("1.4 deg"), "material.angle:", "write 1.4 rad (80.2 deg)");
    EXPECT_TRUE(read(minimal_design, wound("0 deg")).warnings.empty());
    EXPECT_TRUE(read(minimal_design, wound("1.4 rad")).warnings.empty());
}

TEST(Plausibility, WarnsAboutACompressibleRubber) {
    expect_warning({{"material.kappa", "1 MPa"}}, "material.kappa:", "6.08 times");
    EXPECT_TRUE(read(minimal_design, {{"material.kappa", "16.44 MPa"}}).warnings.empty());
}

TEST(Plausibility, WarnsAboutLockingWithTheMeasuredFactor) {
    const std::vector<Override> stiff = {{"mesh.formulation", "displacement"}, {"material.kappa", "16.44 MPa"}};
    expect_warning(stiff, "mesh.formulation:", "100 times the shear modulus (1.2 times too stiff on the bellows");
    std::vector<Override> simplices = {{"mesh.formulation", "displacement"},
                                       {"material.kappa", "8.2 MPa"},  // 49.9 mu
                                       {"mesh.order", "1"},
                                       {"mesh.cells", "simplices"}};
    expect_warning(simplices, "mesh.cells:", "3.6 times too stiff on the bellows");
    simplices[1].value = "16.44 MPa";
    EXPECT_EQ(read(minimal_design, simplices).warnings.size(), 2u);
    EXPECT_TRUE(read(minimal_design, {{"mesh.cells", "simplices"}}).warnings.empty());  // mixed, second order
    EXPECT_TRUE(
        read(minimal_design, {{"mesh.formulation", "f-bar"}, {"mesh.order", "1"}, {"material.kappa", "16.44 MPa"}})
            .warnings.empty());
}

TEST(Plausibility, WarnsAboutAnEndBeyondTheFullLoad) {
    expect_warning({{"path.until.pressure", "40 kPa"}}, "path.until.pressure:", "never reached");
    EXPECT_TRUE(read(minimal_design, {{"path.until.pressure", "20 kPa"}}).warnings.empty());
}

// The factors in the warnings are those of the third column of the verification table (at 20 mm).
TEST(Plausibility, LockingFactorsMatchTheVerificationTable) {
    std::ifstream table{std::string{SOFT_SOURCE_DIR} + "/tests/verification/README.md"};
    std::map<std::string, double> measured;
    for (std::string line; std::getline(table, line);) {
        std::istringstream cells{line};
        std::string empty, element, at_5mm, at_20mm;
        for (std::string* cell : {&empty, &element, &at_5mm, &at_20mm}) std::getline(cells, *cell, '|');
        if (element.starts_with(" solid, ")) measured[element] = std::atof(at_20mm.c_str());
    }
    const auto quoted = [](LockingChoice choice) { return locking_factor(choice); };
    EXPECT_NEAR(measured[" solid, tetrahedra, first order, displacement "],
                quoted(LockingChoice::first_order_simplices), 0.05);
    EXPECT_NEAR(measured[" solid, hexahedra, first order, displacement "],
                quoted(LockingChoice::first_order_displacement), 0.05);
    EXPECT_NEAR(measured[" solid, hexahedra, second order, displacement "],
                quoted(LockingChoice::second_order_displacement), 0.05);
}

}  // namespace
