#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

#include "sample.hpp"

namespace {

using namespace soft;
using namespace soft::design;
using namespace soft::design::sample;

TEST(ReadDesign, FamilyMaterialAndAPressureAreSufficient) {
    const Design design = read(minimal_design);
    EXPECT_EQ(design.family, "pipe");
    EXPECT_EQ(design.name, "pipe");
    EXPECT_EQ(design.values.number("geometry.wall"), 3e-3);
    EXPECT_EQ(design.values.count("geometry.folds"), 4);
    EXPECT_EQ(design.values.text("model"), "axisymmetric");
    EXPECT_FALSE(design.values.given("geometry.wall"));
    EXPECT_EQ(design.material.name, "rubber");
    EXPECT_EQ(design.material.law, "neo-hookean");
    EXPECT_EQ(design.material.constants.at("mu"), std::vector{164400.0});
    EXPECT_EQ(design.material.bulk_modulus_Pa, std::nullopt);  // incompressible without kappa
    ASSERT_EQ(design.loads.size(), 1u);
    EXPECT_EQ(design.loads[0].name, "cavity");
    EXPECT_EQ(design.loads[0].targets, std::vector<std::string>{"cavity"});
    EXPECT_EQ(supply(design).what, model::Prescription::pressure);
    EXPECT_EQ(supply(design).value, 30000.0);
    EXPECT_TRUE(design.loads[0].sealed);
    ASSERT_EQ(design.supports.size(), 1u);
    EXPECT_EQ(design.supports[0].face, "fixed");  // end_disc is an alias of fixed
    EXPECT_EQ(design.supports[0].fixed, (std::array{true, true, false}));
    ASSERT_EQ(design.outputs.size(), 1u);
    EXPECT_EQ(design.outputs[0].name, "elongation");
    EXPECT_EQ(design.path.stages.at(0).control, model::Control::automatic);
    EXPECT_TRUE(design.warnings.empty());
}

TEST(ReadDesign, ReadsADesignWithAllSections) {
    const Design design = read(R"(
family: pipe
name: kraken-bellows
geometry: {length: 80 mm, wall: 2.5 mm, folds: 10, disc: {length: 5 mm}, skew: 30 deg}
material: {law: neo-hookean, mu: 0.1644 MPa, kappa: 16.44 MPa, volumetric: log}
model: quarter
mesh: {size: 1 mm, formulation: mixed, order: 2}
supports: {fixed: end_disc, y: [inlet, outer], z: outer}
loads:
  cavity: {pressure: 30 kPa, sealed: false}
  outer: {pressure: -2 kPa}
path: {control: arc-length, until: {elongation: 130 mm, volume_ratio: 5, pressure: 20 kPa, steps: 40}}
outputs:
  elongation: {face: inlet, along: axis}
  sway: {face: outer, along: z}
solver: {residual_tolerance: 1e-8, newton_limit: 20}
)");
    EXPECT_EQ(design.name, "kraken-bellows");
    EXPECT_DOUBLE_EQ(design.values.number("geometry.skew"), std::numbers::pi / 6);
    EXPECT_EQ(design.values.number("geometry.disc.length"), 5e-3);
    EXPECT_EQ(design.values.number("geometry.disc.radius"), 14.5e-3);
    EXPECT_TRUE(design.values.given("geometry.disc.length"));
    EXPECT_EQ(design.values.number("geometry.length"), 80e-3);
    EXPECT_EQ(design.material.bulk_modulus_Pa, 16440000.0);
    EXPECT_EQ(design.material.volumetric, model::Volumetric::log);
    ASSERT_EQ(design.supports.size(), 3u);
    EXPECT_EQ(design.supports[0].fixed, (std::array{true, true, true}));
    EXPECT_EQ(design.supports[1].face, "inlet");
    EXPECT_EQ(design.supports[1].fixed, (std::array{false, true, false}));
    EXPECT_EQ(design.supports[2].fixed, (std::array{false, true, true}));  // y and z of one face are combined
    ASSERT_EQ(design.loads.size(), 2u);
    EXPECT_EQ(design.loads[0].name, "cavity");
    EXPECT_FALSE(design.loads[0].sealed);
    EXPECT_EQ(design.path.stages.at(0).supplies.at(1).value, -2000.0);
    const model::Stage& stage = design.path.stages.at(0);
    EXPECT_EQ(stage.control, model::Control::arc_length);
    ASSERT_EQ(stage.until.size(), 4u);
    EXPECT_EQ(stage.until[0].quantity, "elongation");
    EXPECT_EQ(stage.until[0].value, 0.13);
    EXPECT_EQ(stage.until[1].value, 5.0);
    EXPECT_EQ(stage.until[2].value, 20000.0);
    EXPECT_EQ(stage.until[3].value, 40.0);
    EXPECT_EQ(design.outputs[1].along, "z");
    EXPECT_EQ(design.solver.residual_tolerance, 1e-8);
    EXPECT_EQ(design.solver.newton_limit, 20);
    EXPECT_EQ(design.solver.step_limit, model::SolverSettings{}.step_limit);
}

TEST(ReadDesign, PressureActsOnAFaceInAFamilyWithoutACavity) {
    const Design design =
        read("family: bar\nmaterial: {law: neo-hookean, mu: 100 kPa}\nloads: {end: {pressure: -50 kPa}}\n");
    EXPECT_EQ(design.path.stages.at(0).control, model::Control::automatic);
    EXPECT_EQ(design.loads[0].targets, std::vector<std::string>{"end"});
    EXPECT_EQ(supply(design).value, -50000.0);
}

TEST(ReadDesign, EmptySectionIsNotReplacedByTheDefault) {
    const Design design = read(std::string{minimal_design} + "supports: {}\noutputs: {}\nsolver:\n");
    EXPECT_TRUE(design.supports.empty());
    EXPECT_TRUE(design.outputs.empty());
}

TEST(ReadDesign, GivenSectionReplacesTheDefaultOfTheFamily) {
    const Design design =
        read(std::string{minimal_design} + "outputs: {swell: {face: outer, along: r}}\nsupports: {x: inlet}\n");
    ASSERT_EQ(design.outputs.size(), 1u);
    EXPECT_EQ(design.outputs[0].name, "swell");
    ASSERT_EQ(design.supports.size(), 1u);
    EXPECT_EQ(design.supports[0].face, "inlet");
}

TEST(Values, UnknownKeyThrowsALogicError) {
    const Design design = read(minimal_design);
    EXPECT_THROW(static_cast<void>(design.values.number("geometry.colour")), std::logic_error);
    EXPECT_FALSE(design.values.has("geometry.colour"));
}

TEST(Values, RefusalHasTheLocationOfItsKey) {
    const Design design =
        read(std::string{minimal_design} + "geometry:\n  wall: 12 mm\n", {{"geometry.length", "90 mm"}});
    EXPECT_STREQ(design.values.refuse("geometry.wall", "12 mm is too much", "at most 10 mm").what(),
                 "p.yaml:5:9: geometry.wall: 12 mm is too much; at most 10 mm");
    EXPECT_STREQ(design.values.refuse("geometry.length", "bad").what(), "--set geometry.length: bad");
}

}  // namespace
