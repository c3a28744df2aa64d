/// Control, end criteria and stages of the path.
#include <gtest/gtest.h>

#include "sample.hpp"

namespace {

using namespace soft;
using namespace soft::design;
using namespace soft::design::sample;
using model::Control;
using model::Prescription;

model::PathSettings path(const std::string& rest) { return read(base + rest).path; }

TEST(Path, HasTheDefaultsOfTheModel) {
    const model::PathSettings read_path = path(""), usual;
    EXPECT_EQ(read_path.branch, usual.branch);
    EXPECT_EQ(read_path.imperfection_m, usual.imperfection_m);
    EXPECT_EQ(read_path.contact, usual.contact);
    EXPECT_EQ(read_path.stretch_limit, usual.stretch_limit);
    ASSERT_EQ(read_path.stages.size(), 1u);
    EXPECT_EQ(read_path.stages[0].name, "");
    EXPECT_EQ(read_path.stages[0].control, Control::automatic);
    EXPECT_EQ(read_path.stages[0].controlled, "");
}

TEST(Path, ReadsBranchAndContactSettings) {
    const model::PathSettings set =
        path("path: {branch: follow, imperfection: 0.02 mm, contact: ignore, stretch_limit: 6}\n");
    EXPECT_EQ(set.branch, model::Branch::follow);
    EXPECT_EQ(set.imperfection_m, 2e-5);
    EXPECT_EQ(set.contact, model::Contact::ignore);
    EXPECT_EQ(set.stretch_limit, 6.0);
    EXPECT_TRUE(contains(refusal(base + "path: {stretch_limit: 1}\n"), "path.stretch_limit: 1 is out of range"));
}

TEST(Path, NaturalFrequenciesNeedADensityAndAFactorisation) {
    const std::string three = "path: {frequencies: 3}\n";
    const auto refused = [&](const std::string& path_text, std::vector<Override> sets) {
        sets.push_back({"material.density", "1080 kg/m^3"});
        return refusal(base + path_text, sets);
    };
    EXPECT_EQ(path("").frequencies, 0);
    EXPECT_EQ(read(base + three, {{"material.density", "1080 kg/m^3"}}).path.frequencies, 3);
    EXPECT_TRUE(contains(refusal(base + three),
                         "path.frequencies: the rubber has no density; add material: {density: 1080 kg/m^3}"));
    for (const char* linear : {"krylov", "jacobian-free"})
        EXPECT_TRUE(contains(refused(three, {{"solver.linear", linear}}),
                             std::string{"path.frequencies: natural frequencies need a factorisation of the tangent, "
                                         "which solver.linear: "} +
                                 linear + " avoids; use solver.linear: auto or mumps-ldlt, or path.frequencies: 0"));
    EXPECT_TRUE(contains(refused("path: {frequencies: 51}\n", {}), "path.frequencies: 51 is out of range"));
}

TEST(Path, ControlledQuantityMustMatchTheControl) {
    const std::string outputs = "outputs: {a: {face: inlet}, b: {face: outer, along: r}}\n";
    EXPECT_EQ(path(outputs + "path: {control: displacement, controlled: b}\n").stages.at(0).controlled, "b");
    EXPECT_EQ(path(outputs + "path: {control: volume, controlled: cavity}\n").stages.at(0).controlled, "cavity");
    for (const char* settings :
         {"{control: volume, controlled: b}", "{control: displacement, controlled: cavity}", "{controlled: b}"})
        EXPECT_TRUE(
            contains(refusal(base + outputs + "path: " + settings + "\n"), "cannot be prescribed by this control"))
            << settings;
    EXPECT_TRUE(contains(refusal(base + outputs + "path: {control: displacement, controlled: sway}\n"),
                         "path.controlled: 'sway' is not a valid value; known: first, a, b, cavity"));
    EXPECT_TRUE(contains(refusal(base + "outputs: {}\npath: {control: displacement}\n"),
                         "path.control: there is no output to prescribe"));
}

TEST(Path, VolumeControlIsRejectedForAPrescribedVolume) {
    const std::string filled =
        "family: pipe\nmaterial: {law: neo-hookean, mu: 1 kPa}\nloads: {cavity: {volume_ratio: 3}}\n";
    EXPECT_TRUE(
        contains(refusal(filled + "path: {control: volume}\n"),
                 "p.yaml:4:17: path.control: the volume of 'cavity' is prescribed by its load already; use auto"));
    EXPECT_NO_THROW(static_cast<void>(read(filled + "path: {control: arc-length}\n")));
}

TEST(Path, EndValueHasTheDimensionOfItsOutput) {
    const std::string outputs =
        "model: solid\noutputs: {bend: {face: inlet, measure: bend, reference: fixed, along: y}}\n";
    EXPECT_DOUBLE_EQ(path(outputs + "path: {until: {bend: 30 deg}}\n").stages.at(0).until.at(0).value,
                     0.5235987755982988);
    EXPECT_TRUE(
        contains(refusal(base + outputs + "path: {until: {bend: 30 mm}}\n"), "is a length where an angle is needed"));
}

const std::string cycle = R"(path:
  control: volume
  until: {elongation: 50 mm}
  stages:
    inflate: {loads: {cavity: {pressure: 40 kPa}}}
    hold: {until: {}}
    shut: {loads: {cavity: {valve: closed}, outer: {pressure: 1 kPa}}, control: auto, until: none}
    vent: {loads: {cavity: {pressure: 0 kPa}, outer: {pressure: 0 kPa}}, control: arc-length, until: {elongation: 0 mm, steps: 9}}
)";
const std::string loaded =
    "family: pipe\nmaterial: {law: neo-hookean, mu: 0.1644 MPa}\nloads: {cavity: {pressure: 30 kPa}, outer: {pressure: 2 kPa}}\n";

TEST(Stages, ChangeLoadsThatOtherwiseKeepTheirValues) {
    const auto stages = read(loaded + cycle).path.stages;
    ASSERT_EQ(stages.size(), 4u);
    const auto expect = [&](std::size_t stage, std::size_t load, Prescription what, double value) {
        EXPECT_EQ(stages[stage].supplies.at(load).what, what) << stages[stage].name << load;
        EXPECT_EQ(stages[stage].supplies.at(load).value, value) << stages[stage].name << load;
    };
    EXPECT_EQ(stages[0].name, "inflate");
    expect(0, 0, Prescription::pressure, 40e3);
    expect(0, 1, Prescription::pressure, 0);  // no stage has named it yet
    EXPECT_EQ(stages[1].name, "hold");
    expect(1, 0, Prescription::pressure, 40e3);
    expect(2, 0, Prescription::closed, 0);
    expect(2, 1, Prescription::pressure, 1e3);
    expect(3, 0, Prescription::pressure, 0);
    expect(3, 1, Prescription::pressure, 0);
}

TEST(Stages, InheritControlAndEndCriteriaFromThePath) {
    const auto stages = read(loaded + cycle).path.stages;
    EXPECT_EQ(stages[0].control, Control::volume);
    ASSERT_EQ(stages[0].until.size(), 1u);
    EXPECT_EQ(stages[0].until[0].value, 0.05);
    EXPECT_TRUE(stages[1].until.empty());
    EXPECT_TRUE(stages[2].until.empty());
    EXPECT_EQ(stages[2].control, Control::automatic);
    EXPECT_EQ(stages[3].control, Control::arc_length);
    ASSERT_EQ(stages[3].until.size(), 2u);
    EXPECT_EQ(stages[3].until[0].quantity, "elongation");
    EXPECT_EQ(stages[3].until[0].value, 0.0);
}

TEST(Stages, AreReproducedByTheEffectiveDesign) {
    const Design first = read(loaded + cycle), second = read(first.effective_yaml);
    EXPECT_EQ(first.effective_yaml, second.effective_yaml);
    ASSERT_EQ(second.path.stages.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(first.path.stages[i].name, second.path.stages[i].name);
        EXPECT_EQ(first.path.stages[i].until.size(), second.path.stages[i].until.size());
        EXPECT_EQ(first.path.stages[i].control, second.path.stages[i].control);
    }
    const std::string text = explain_design(loaded + cycle, "p.yaml", families(), {});
    EXPECT_TRUE(contains(text, "gauge pressure at the stage's end")) << text;
    EXPECT_TRUE(contains(text, "a load is 0 until a stage names it")) << text;
}

TEST(Stages, SolveCanChangeTheirValues) {
    const std::string effective = read(loaded + cycle).effective_yaml;
    EXPECT_EQ(read_built(effective, {}).effective_yaml, effective);
    const std::vector<Override> changes = {{"path.stages.inflate.loads.cavity.pressure", "35 kPa"},
                                           {"path.control", "pressure"}};
    const auto part = read_built(effective, changes);
    EXPECT_EQ(part.path.stages.at(0).supplies.at(0).value, 35e3);
    EXPECT_EQ(part.path.stages.at(0).control, Control::pressure);  // inherited from the path
    EXPECT_EQ(part.path.stages.at(3).control, Control::arc_length);
    EXPECT_EQ(part.effective_yaml, read(effective, changes).effective_yaml);
}

TEST(Stages, InvalidLoadsAndNamesAreRejected) {
    const auto refused = [](const std::string& stages) {
        return refusal(loaded + "path:\n  stages:\n    a: " + stages + "\n");
    };
    EXPECT_TRUE(contains(
        refused("{loads: {cavity: {pressure: 1 kPa}}}"),
        "p.yaml:3:55: loads.outer.pressure: no stage names this load, so it would never act; name it in one of path.stages"));
    EXPECT_TRUE(contains(
        refused("{loads: {inlet: {pressure: 1 kPa}}}"),
        "path.stages.a.loads.inlet: 'inlet' is not one of the loads; a stage can change these loads: cavity, outer"));
    EXPECT_TRUE(contains(refused("{loads: {outer: {volume: 1 mL}}}"), "path.stages.a.loads.outer.volume: unknown key"));
    EXPECT_TRUE(contains(refused("{loads: {outer: {pressure: 1 kPa}, cavity: {}}}"),
                         "path.stages.a.loads.cavity.pressure: missing"));
    EXPECT_TRUE(
        contains(refused("{loads: {cavity: {pressure: 1 kPa, volume: 1 mL}}}"), "the load has a pressure already"));
    EXPECT_TRUE(contains(refused("{lods: {}}"), "path.stages.a.lods: unknown key; did you mean 'loads'?"));
    EXPECT_TRUE(contains(refused("{control: volume, loads: {outer: {pressure: 1 kPa}, cavity: {volume: 3 mL}}}"),
                         "path.stages.a.control: the volume of 'cavity' is prescribed"));
    EXPECT_TRUE(
        contains(refusal(loaded + "path: {stages: {1st: {}}}\n"), "path.stages.1st: not a name of a stage; letters"));
}

}  // namespace
