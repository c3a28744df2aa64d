#include <gtest/gtest.h>

#include "sample.hpp"

namespace {

using namespace soft;
using namespace soft::design;
using namespace soft::design::sample;

TEST(ParseOverride, SplitsAtTheFirstEqualsSign) {
    const Override change = parse_override("geometry.wall=2.5mm");
    EXPECT_EQ(change.path, "geometry.wall");
    EXPECT_EQ(change.value, "2.5mm");
    EXPECT_EQ(parse_override(" name = a=b ").value, "a=b");
}

TEST(ParseOverride, LoadIsShortForTheCavitysLoad) {
    EXPECT_EQ(parse_override("load.pressure=60kPa").path, "loads.cavity.pressure");
}

TEST(ParseOverride, ArgumentThatIsNotAnAssignmentIsAUsageError) {
    for (const char* argument :
         {"", "geometry.wall", "=3 mm", "geometry.wall=", ".wall=3 mm", "geometry.=3 mm", "geometry..wall=3 mm"}) {
        try {
            static_cast<void>(parse_override(argument));
            ADD_FAILURE() << argument;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::usage) << argument;
        }
    }
}

TEST(Overrides, ReplaceAndAddValuesAndReplaceWholeGroups) {
    const Design design = read(minimal_design, {{"geometry.wall", "2.5mm"},
                                                {"loads.cavity.pressure", "60kPa"},
                                                {"outputs", "{swell: {face: outer, along: r}}"},
                                                {"supports.fixed", "[inlet, end_disc]"}});
    EXPECT_EQ(design.values.number("geometry.wall"), 2.5e-3);
    EXPECT_TRUE(design.values.given("geometry.wall"));
    EXPECT_EQ(supply(design).value, 60000.0);
    EXPECT_EQ(design.outputs.at(0).name, "swell");
    EXPECT_EQ(design.supports.size(), 2u);
}

TEST(Overrides, LastOfTwoTakesEffect) {
    EXPECT_EQ(
        read(minimal_design, {{"geometry.wall", "2 mm"}, {"geometry.wall", "4 mm"}}).values.number("geometry.wall"),
        4e-3);
}

TEST(Overrides, CanSupplyMissingKeys) {
    const Design design =
        read("family: pipe\n", {{"material", "{law: neo-hookean, mu: 1 MPa}"}, {"loads.cavity.pressure", "5 kPa"}});
    EXPECT_EQ(supply(design).value, 5000.0);
}

TEST(Overrides, ErrorsAreReportedAtTheOption) {
    EXPECT_EQ(refusal(minimal_design, {{"geometry.wall", "3"}}).find("--set geometry.wall: '3' has no unit"), 0u);
    EXPECT_EQ(refusal(minimal_design, {{"geometry.wal", "3 mm"}})
                  .find("--set geometry.wal: unknown key; did you mean 'wall'?"),
              0u);
    EXPECT_EQ(refusal(minimal_design, {{"geometry.disc", "{length: 6 mm, radius: 4}"}})
                  .find("--set geometry.disc: geometry.disc.radius: '4' has no unit"),
              0u);
    EXPECT_EQ(refusal(minimal_design, {{"geometry.wall", "\"3"}}).find("--set geometry.wall: not YAML"), 0u);
    EXPECT_EQ(refusal(minimal_design, {{"geometry.wall.x", "3 mm"}}).find("--set geometry.wall.x"), 0u);
}

class Apply : public testing::Test {
protected:
    const std::string effective_ =
        read(std::string{minimal_design} + "path: {until: {elongation: 40 mm}}\n").effective_yaml;
};

TEST_F(Apply, MatchesADesignWithTheSameOverrides) {
    const std::vector<Override> changes = {{"loads.cavity.pressure", "60kPa"}, {"loads.cavity.sealed", "false"},
                                           {"material.kappa", "3 MPa"},        {"path.control", "pressure"},
                                           {"path.until.elongation", "50 mm"}, {"solver.first_step", "0.1"}};
    const Design whole = read(effective_, changes);
    const Design part = read_built(effective_, changes);
    EXPECT_EQ(part.effective_yaml, whole.effective_yaml);
    EXPECT_EQ(part.path.stages.at(0).supplies.at(0).value, 60000.0);
    EXPECT_FALSE(part.loads.at(0).sealed);
    EXPECT_EQ(part.material.bulk_modulus_Pa, 3e6);
    EXPECT_EQ(part.material.constants, whole.material.constants);
    EXPECT_EQ(part.path.stages.at(0).control, model::Control::pressure);
    EXPECT_EQ(part.path.stages.at(0).until.at(0).value, 0.05);
    EXPECT_EQ(part.solver.first_step, 0.1);
}

TEST_F(Apply, WithoutOverridesChangesNothing) { EXPECT_EQ(read_built(effective_, {}).effective_yaml, effective_); }

TEST_F(Apply, RejectsKeysThatAreBuiltIntoTheCase) {
    for (const char* path :
         {"geometry.wall", "mesh.size", "model", "supports.fixed", "outputs.elongation.face", "family"}) {
        const std::vector<Override> changes = {{path, "3 mm"}};
        try {
            static_cast<void>(read_built(effective_, changes));
            ADD_FAILURE() << path;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::usage);
            EXPECT_TRUE(contains(error.what(), "built into the case")) << error.what();
        }
    }
}

TEST_F(Apply, RejectsInvalidValuesAndUnknownLoadsAtTheirOverride) {
    const auto line = [&](const Override& change) {
        try {
            static_cast<void>(read_built(effective_, {change}));
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::bad_input);
            return std::string{error.what()};
        }
        return std::string{"accepted"};
    };
    EXPECT_EQ(line({"loads.cavity.pressure", "60"}).find("--set loads.cavity.pressure: '60' has no unit"), 0u);
    EXPECT_EQ(line({"loads.cavty.pressure", "60 kPa"})
                  .find("--set loads.cavty.pressure: loads.cavty: unknown key; did you mean 'cavity'?"),
              0u);
    EXPECT_EQ(line({"path.until.twist", "1 mm"}).find("--set path.until.twist: unknown key"), 0u);
    EXPECT_EQ(line({"colour", "red"}).find("--set colour: unknown key"), 0u);
}

TEST_F(Apply, ReportsTheLocationInTheFileOfAnInvalidDesign) {
    std::string broken = effective_;
    broken.replace(broken.find("mu: 0.1644 MPa"), 14, "mu: -1 kPa");
    try {
        static_cast<void>(read_built(broken, {}));
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        EXPECT_TRUE(contains(error.what(), "case.h5:/design/effective_yaml:")) << error.what();
        EXPECT_TRUE(contains(error.what(), ": material.mu: -1 kPa is out of range")) << error.what();
    }
}

}  // namespace
