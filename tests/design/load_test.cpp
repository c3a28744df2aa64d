/// Tractions, prescribed displacements, gravity and forces; output measures; directions in plane strain.
#include <gtest/gtest.h>

#include "sample.hpp"

namespace {

using namespace soft;
using namespace soft::design;
using namespace soft::design::sample;

/// A family without a cavity whose default load is a traction.
FamilyKeys sheet() {
    FamilyKeys family = bar();
    family.name = "sheet";
    family.models = {"plane-strain", "solid"};
    family.faces = {"fixed", "end", "top"};
    family.aliases = {{"tip", "end"}};
    family.defaults =
        "supports: {fixed: fixed}\nloads: {end: {traction: 20 kPa, along: y}}\noutputs: {shift: {face: end, along: y}}\n";
    return family;
}

const std::vector<FamilyKeys>& sheets() {
    static const std::vector<FamilyKeys> all = {sheet()};
    return all;
}

const std::string material = "family: sheet\nmaterial: {law: neo-hookean, mu: 100 kPa}\n";

Design read_sheet(const std::string& rest, const std::vector<Override>& overrides = {}) {
    return read_design(material + rest, "p.yaml", sheets(), overrides);
}

void expect_refusal(const std::string& rest, std::string_view start, std::string_view remedy) {
    try {
        static_cast<void>(read_sheet(rest));
        ADD_FAILURE() << "accepted: " << rest;
    } catch (const Error& error) {
        const std::string line = error.what();
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        EXPECT_EQ(line.find(start), 0u) << line;
        EXPECT_TRUE(contains(line, remedy)) << line;
    }
}

const std::string pulled = "loads: {end: {traction: 62.5 kPa, along: y}}\n";

TEST(Traction, CanBeTheOnlyLoad) {
    const Design design = read_sheet(pulled);
    EXPECT_TRUE(design.loads.empty());
    ASSERT_EQ(design.dead_loads.size(), 1u);
    EXPECT_EQ(design.dead_loads[0].name, "end");
    EXPECT_EQ(design.dead_loads[0].size_SI, 62500.0);
    EXPECT_EQ(design.dead_loads[0].along, "y");
    EXPECT_EQ(design.path.stages.at(0).dead_loads, std::vector{1.0});  // full traction at the end
    EXPECT_TRUE(design.warnings.empty());
}

TEST(Traction, CanBeCombinedWithPressuresOnOtherFaces) {
    const Design design = read_sheet("loads: {tip: {traction: -3 kPa, along: normal}, top: {pressure: 2 kPa}}\n");
    ASSERT_EQ(design.dead_loads.size(), 1u);
    EXPECT_EQ(design.dead_loads[0].name, "end");  // tip is an alias of end
    EXPECT_EQ(design.dead_loads[0].size_SI, -3000.0);
    ASSERT_EQ(design.loads.size(), 1u);
    EXPECT_EQ(design.loads[0].targets, std::vector<std::string>{"top"});
    expect_refusal("loads: {tip: {traction: 3 kPa, along: x}, end: {pressure: 2 kPa}}\n",
                   "p.yaml:3:59: loads.end.pressure: face 'end' is loaded twice", "keep one of its names");
}

TEST(Traction, InvalidAndContradictoryKeysAreRejected) {
    expect_refusal("loads: {end: {traction: 3 kPa, pressure: 3 kPa, along: y}}\n",
                   "p.yaml:3:32: loads.end.pressure: the load has a traction already",
                   "keep one of pressure, traction, force, displacement");
    expect_refusal("loads: {end: {pressure: 3 kPa, along: y}}\n",
                   "p.yaml:3:32: loads.end.along: a pressure acts along the normal", "write traction");
    expect_refusal("loads: {end: {traction: 3 kPa}}\n", "p.yaml:3:9: loads.end.along: missing", "add along: y");
    expect_refusal("loads: {end: {traction: 0 kPa, along: y}}\n", "p.yaml:3:25: loads.end.traction: a load of 0",
                   "write the traction at full load");
    expect_refusal("loads: {end: {tracton: 3 kPa}}\n", "p.yaml:3:15: loads.end.tracton: unknown key",
                   "did you mean 'traction'?");
    expect_refusal("loads: {end: {traction: 3 kPa, along: up}}\n",
                   "p.yaml:3:39: loads.end.along: 'up' is not a valid value", "");
    expect_refusal("loads: {end: {traction: 3 mm, along: y}}\n",
                   "p.yaml:3:25: loads.end.traction: '3 mm' is a length where a pressure is needed", "");
    expect_refusal("loads: {end: {traction: 3 kPa, along: y, sealed: true}}\n",
                   "p.yaml:3:42: loads.end.sealed: a face has no openings", "leave it out");
    expect_refusal(pulled + "path: {until: {pressure: 3 kPa}}\n",
                   "p.yaml:4:26: path.until.pressure: no load is a pressure", "use an output or steps");
    expect_refusal(pulled + "path: {control: volume}\n", "p.yaml:4:17: path.control: no cavity is loaded", "use auto");
    const std::string cavity = refusal(
        "family: pipe\nmaterial: {law: neo-hookean, mu: 1 kPa}\nloads: {cavity: {traction: 1 kPa, along: x}}\n");
    EXPECT_EQ(cavity.find("p.yaml:3:18: loads.cavity.traction: a cavity is loaded by a pressure; write pressure"), 0u)
        << cavity;
}

TEST(Traction, FarAboveTheModulusTriggersAWarning) {
    const Design design = read_sheet("loads: {end: {traction: 30 MPa, along: y}}\n");
    ASSERT_EQ(design.warnings.size(), 1u);
    EXPECT_EQ(design.warnings[0].find("loads.end.traction: 30 MPa is far above"), 0u) << design.warnings[0];
}

TEST(Traction, IsInTheTemplateOfAFamilyWithADefaultTraction) {
    const std::string text = template_yaml(sheet());
    const Design design = read_design(text, "t", sheets(), {});
    ASSERT_EQ(design.dead_loads.size(), 1u) << text;
    EXPECT_EQ(design.dead_loads[0].size_SI, 20000.0);
    EXPECT_EQ(design.dead_loads[0].along, "y");
    EXPECT_TRUE(contains(text, "force per undeformed area")) << text;
}

TEST(Traction, IsReproducedByTheEffectiveDesign) {
    const Design first = read_sheet(pulled);
    EXPECT_EQ(read_design(first.effective_yaml, "e", sheets(), {}).effective_yaml, first.effective_yaml);
    EXPECT_TRUE(contains(explain_design(material + pulled, "p.yaml", sheets(), {}), "given at p.yaml:3:25; force per"));
}

TEST(PlaneStrain, HasTheComponentsAndDirectionsXAndY) {
    const Design design = read_sheet(pulled + "supports: {fixed: fixed, y: top}\n");
    EXPECT_EQ(design.supports[0].fixed, (std::array{true, true, false}));
    EXPECT_EQ(design.supports[1].fixed, (std::array{false, true, false}));
    for (const char* component : {"z", "r"})
        expect_refusal(
            pulled + "supports: {" + component + ": top}\n",
            std::string{"p.yaml:4:15: supports."} + component + ": a plane strain model has the components x and y",
            "use x, y or fixed");
    for (const char* along : {"z", "r"})
        expect_refusal(pulled + "outputs: {a: {face: top, along: " + along + "}}\n",
                       "p.yaml:4:33: outputs.a.along: a plane strain model has the directions x and y",
                       "axis, x, y or normal");
    expect_refusal("loads: {end: {traction: 1 kPa, along: z}}\n",
                   "p.yaml:3:39: loads.end.along: a plane strain model has the directions x and y", "");
}

class ApplyToTractions : public testing::Test {
protected:
    const std::string effective_ =
        read_sheet(
            "loads: {top: {pressure: 2 kPa}, end: {traction: 50 kPa, along: y}, fixed: {traction: 1 kPa, along: x}}\n")
            .effective_yaml;

    std::string refusal_of(const std::string& path, const std::string& value) {
        const std::vector<Override> change = {{path, value}};
        try {
            static_cast<void>(read_built(effective_, change, sheets()));
        } catch (const Error& error) {
            return error.what();
        }
        return "accepted";
    }
};

TEST_F(ApplyToTractions, ChangesTheTractionsOfTheCase) {
    const std::vector<Override> changes = {{"loads.end.traction", "-25 kPa"}, {"loads.end.along", "x"}};
    const Design part = read_built(effective_, changes, sheets());
    ASSERT_EQ(part.dead_loads.size(), 2u);
    EXPECT_EQ(part.dead_loads[0].size_SI, -25e3);
    EXPECT_EQ(part.dead_loads[0].along, "x");
    EXPECT_EQ(part.dead_loads[1].size_SI, 1e3);
    EXPECT_EQ(part.loads.size(), 1u);
    EXPECT_EQ(part.effective_yaml, read_design(effective_, "e", sheets(), changes).effective_yaml);
}

TEST_F(ApplyToTractions, ReplacesATractionByAPressureAndAPressureByATraction) {
    const Design part = read_built(
        effective_, {{"loads.end", "{pressure: 3 kPa}"}, {"loads.top", "{traction: 3 kPa, along: x}"}}, sheets());
    ASSERT_EQ(part.dead_loads.size(), 2u);
    EXPECT_EQ(part.dead_loads[0].name, "top");
    ASSERT_EQ(part.loads.size(), 1u);
    EXPECT_EQ(part.loads[0].name, "end");
}

TEST(Motion, PrescribesADisplacementComponentOfAFace) {
    const Design design = read_sheet("loads: {tip: {displacement: -10 mm, along: x}}\n");
    ASSERT_EQ(design.motions.size(), 1u);
    EXPECT_EQ(design.motions[0].face, "end");
    EXPECT_EQ(design.motions[0].displacement_m, -0.01);
    EXPECT_EQ(design.motions[0].along, "x");
    EXPECT_EQ(design.path.stages.at(0).motions, std::vector{1.0});
    expect_refusal("loads: {end: {displacement: 10 mm, traction: 3 kPa, along: y}}\n",
                   "p.yaml:3:36: loads.end.traction: the load has a displacement already", "keep one of");
    expect_refusal("loads: {end: {displacement: 10 mm, along: z}}\n",
                   "p.yaml:3:43: loads.end.along: a plane strain model", "");
    expect_refusal("loads: {end: {displacement: 0 mm, along: x}}\n", "p.yaml:3:29: loads.end.displacement: a load of 0",
                   "write the displacement at full load, for example 10 mm");
}

TEST(Gravity, RequiresADensityAndADirection) {
    const std::string weight = "loads: {gravity: {acceleration: 9.81 m/s^2, along: -y}}\n";
    const Design design = read_sheet(weight, {{"material.density", "1080 kg/m^3"}});
    ASSERT_EQ(design.dead_loads.size(), 1u);
    EXPECT_EQ(design.dead_loads[0].name, "gravity");
    EXPECT_EQ(design.dead_loads[0].size_SI, 9.81);
    EXPECT_EQ(design.dead_loads[0].along, "-y");
    EXPECT_EQ(design.material.density_kg_m3, 1080.0);
    expect_refusal(weight, "p.yaml:3:33: loads.gravity.acceleration: the rubber has no density",
                   "material: {density: 1080 kg/m^3}");
    expect_refusal("loads: {gravity: {acceleration: 9.81 m/s^2}}\n", "p.yaml:3:9: loads.gravity.along: missing",
                   "add along: -x");
    expect_refusal("loads: {gravity: {acceleration: 9.81 m, along: x}}\n",
                   "p.yaml:3:33: loads.gravity.acceleration: '9.81 m' is a length where an acceleration is needed", "");
}

TEST(Stages, OfTractionsGravityAndMotionsAreFractionsOfTheFullLoad) {
    const Design design = read_sheet(
        "loads: {end: {traction: 50 kPa, along: y}, top: {displacement: 4 mm, along: x}, gravity: {acceleration: 10 m/s^2, along: x}}\n"
        "path: {stages: {a: {loads: {tip: {traction: 20 kPa}, gravity: {acceleration: 5 m/s^2}}},"
        " b: {loads: {top: {displacement: -1 mm}, end: {traction: 0 kPa}}}}}\n",
        {{"material.density", "1 g/cm^3"}});
    const auto& stages = design.path.stages;
    ASSERT_EQ(stages.size(), 2u);
    EXPECT_EQ(stages[0].dead_loads, (std::vector{0.4, 0.5}));
    EXPECT_EQ(stages[0].motions, std::vector{0.0});
    EXPECT_EQ(stages[1].dead_loads, (std::vector{0.0, 0.5}));
    EXPECT_EQ(stages[1].motions, std::vector{-0.25});
}

TEST(Overrides, FindALoadUnderEveryAliasOfItsFace) {
    const std::string tip = "loads: {tip: {displacement: 10 mm, along: x}}\n",
                      end = "loads: {end: {displacement: 10 mm, along: x}}\n";
    for (const std::string& design : {tip, end})
        for (const char* path : {"loads.tip.displacement", "loads.end.displacement"}) {
            const std::vector<Override> changes = {{path, "5 mm"}};
            const Design changed = read_sheet(design, changes);
            ASSERT_EQ(changed.motions.size(), 1u);
            EXPECT_EQ(changed.motions[0].displacement_m, 5e-3);
            const Design part = read_built(read_sheet(design).effective_yaml, changes, sheets());
            ASSERT_EQ(part.motions.size(), 1u);
            EXPECT_EQ(part.motions[0].displacement_m, 5e-3);
            EXPECT_EQ(part.effective_yaml, changed.effective_yaml);
        }
}

TEST_F(ApplyToTractions, RejectsFacesThatTheFamilyDoesNotHave) {
    EXPECT_TRUE(contains(refusal_of("loads.tip.traction", "5 kPa"), "accepted"));  // an alias of end
    EXPECT_TRUE(contains(refusal_of("loads.bottom.pressure", "5 kPa"),
                         "--set loads.bottom.pressure: loads.bottom: unknown key; known: "));
    EXPECT_TRUE(
        contains(refusal_of("loads.gravity", "{acceleration: 9.81 m/s^2, along: x}"), "the rubber has no density"));
    EXPECT_EQ(refusal_of("loads.cavity.pressure", "5 kPa"),
              "--set loads.cavity.pressure: loads.cavity: there is no cavity to load; faces: fixed, end, top, tip");
}

class Angles : public testing::Test {
protected:
    std::string refusal_of(const std::string& model, const std::string& output) {
        try {
            static_cast<void>(read(
                "family: pipe\nmaterial: {law: neo-hookean, mu: 1 kPa}\nloads: {cavity: {pressure: 1 kPa}}\nmodel: " +
                model + "\noutputs: {a: {" + output + "}}\n"));
        } catch (const Error& error) {
            return error.what();
        }
        return "accepted";
    }
};

TEST_F(Angles, CanBeBendsFromAReferenceAndTwists) {
    const Design design =
        read(std::string{minimal_design} +
             "model: solid\noutputs: {b: {face: inlet, measure: bend, reference: end_disc, along: y}, "
             "t: {face: inlet, measure: twist, along: axis}, d: {face: inlet}}\n");
    ASSERT_EQ(design.outputs.size(), 3u);
    EXPECT_EQ(design.outputs[0].measure, model::Measure::bend);
    EXPECT_EQ(design.outputs[0].reference, "fixed");
    EXPECT_EQ(design.outputs[1].measure, model::Measure::twist);
    EXPECT_EQ(design.outputs[2].measure, model::Measure::displacement);
    EXPECT_EQ(read(design.effective_yaml).effective_yaml, design.effective_yaml);
}

TEST_F(Angles, InvalidReferencesAndAxesAreRejected) {
    const std::string bend = "face: inlet, measure: bend, ";
    EXPECT_TRUE(contains(refusal_of("solid", bend + "along: y"), "outputs.a.reference: missing"));
    EXPECT_TRUE(contains(refusal_of("solid", bend + "reference: fixed"), "outputs.a.along: missing"));
    EXPECT_TRUE(
        contains(refusal_of("solid", bend + "reference: inlet, along: y"), "a face has no bend relative to itself"));
    EXPECT_TRUE(contains(refusal_of("solid", bend + "reference: fixed, along: r"), "r is not an axis of rotation"));
    EXPECT_TRUE(
        contains(refusal_of("solid", "face: inlet, reference: fixed"), "only a bend is measured from another face"));
    EXPECT_TRUE(contains(refusal_of("axisymmetric", bend + "reference: fixed, along: x"), "neither bends nor twists"));
    EXPECT_TRUE(contains(refusal_of("axisymmetric", "face: inlet, measure: twist"), "neither bends nor twists"));
}

TEST(PlaneStrain, RotationsAreAboutZ) {
    const Design design = read_sheet(pulled + "outputs: {a: {face: end, measure: bend, reference: fixed, along: z}}\n");
    EXPECT_EQ(design.outputs.at(0).along, "z");
    expect_refusal(pulled + "outputs: {a: {face: end, measure: bend, reference: fixed, along: y}}\n",
                   "p.yaml:4:66: outputs.a.along: in plane strain faces turn about z", "along: z");
}

class Measures : public Angles {};

TEST_F(Measures, ShapesAndReactionsAreReadWithTheirAxis) {
    const Design design = read(
        std::string{minimal_design} +
        "model: solid\noutputs: {f: {face: end_disc, measure: force}, m: {face: end_disc, measure: moment, along: z}, "
        "w: {face: outer, measure: radial}, o: {face: inlet, measure: rotation, along: x}, "
        "k: {face: outer, measure: curvature, along: y}}\npath: {until: {f: 20 mN, m: 3 N.mm, k: 5 1/m}}\n");
    ASSERT_EQ(design.outputs.size(), 5u);
    EXPECT_EQ(design.outputs[0].measure, model::Measure::force);
    EXPECT_EQ(design.outputs[0].along, "axis");
    EXPECT_EQ(design.outputs[1].measure, model::Measure::moment);
    EXPECT_EQ(design.outputs[2].measure, model::Measure::radial);
    EXPECT_EQ(design.outputs[3].measure, model::Measure::rotation);
    EXPECT_EQ(design.outputs[4].measure, model::Measure::curvature);
    const auto& until = design.path.stages.at(0).until;
    ASSERT_EQ(until.size(), 3u);
    EXPECT_EQ(until[0].value, 0.02);
    EXPECT_EQ(until[1].value, 3e-3);
    EXPECT_EQ(until[2].value, 5.0);
    EXPECT_EQ(read(design.effective_yaml).effective_yaml, design.effective_yaml);
}

TEST_F(Measures, ThatTheModelDoesNotHaveAreRejected) {
    EXPECT_TRUE(contains(refusal_of("solid", "face: inlet, measure: moment"), "outputs.a.along: missing"));
    EXPECT_TRUE(contains(refusal_of("solid", "face: inlet, measure: curvature"), "outputs.a.along: missing"));
    EXPECT_TRUE(contains(refusal_of("solid", "face: inlet, measure: radial, along: r"),
                         "it is the axis from which the distance is taken"));
    EXPECT_TRUE(contains(refusal_of("axisymmetric", "face: inlet, measure: force, along: r"),
                         "forces along r cancel around the circumference"));
    EXPECT_TRUE(
        contains(refusal_of("axisymmetric", "face: inlet, measure: moment, along: x"), "neither bends nor twists"));
    EXPECT_TRUE(
        contains(refusal_of("axisymmetric", "face: inlet, measure: curvature, along: x"), "neither bends nor twists"));
    EXPECT_EQ(refusal_of("axisymmetric", "face: outer, measure: radial"), "accepted");
    EXPECT_TRUE(contains(refusal_of("solid", "face: inlet, measure: forces"), "force"));
}

TEST(Reactions, InADynamicDesignAreRejected) {
    try {
        static_cast<void>(read(
            "family: pipe\nmaterial: {law: neo-hookean, mu: 1 kPa, density: 1000 kg/m^3}\nloads: {cavity: {pressure: 1 kPa}}\n"
            "model: solid\noutputs: {a: {face: end_disc, measure: force}}\ndynamics: {duration: 1 s}\n"));
        FAIL() << "not refused";
    } catch (const Error& error) {
        EXPECT_TRUE(contains(error.what(), "a reaction is measured on a static path"));
    }
}

TEST(OutputNames, MustNotBeThoseOfTheLoad) {
    for (const char* name : {"load", "traction", "load_factor"}) {
        try {
            static_cast<void>(read(std::string{minimal_design} + "outputs: {" + name + ": {face: inlet}}\n"));
            FAIL() << "not refused";
        } catch (const Error& error) {
            EXPECT_TRUE(contains(error.what(), "the name is reserved for a quantity of every path"));
        }
    }
}

constexpr const char* pushed =
    "family: pipe\nmaterial: {law: neo-hookean, mu: 1 kPa}\nloads: {inlet: {force: 150 mN, along: x}}\n";

TEST(Forces, AreReadWithTheirUnit) {
    const Design design = read(pushed);
    ASSERT_EQ(design.dead_loads.size(), 1u);
    EXPECT_EQ(design.dead_loads[0].size_SI, 0.15);
    EXPECT_EQ(design.dead_loads[0].kind, model::DeadLoadKind::force);
    EXPECT_EQ(read(design.effective_yaml).dead_loads.at(0).size_SI, 0.15);
}

TEST(Forces, CanBeChangedAndReplacedBySolve) {
    const std::string effective = read(pushed).effective_yaml;
    EXPECT_EQ(read_built(effective, {{"loads.inlet.force", "0.3 N"}}).dead_loads.at(0).size_SI, 0.3);
    const Design spread = read_built(effective, {{"loads.inlet", "{traction: 1 kPa, along: x}"}});
    EXPECT_EQ(spread.dead_loads.at(0).kind, model::DeadLoadKind::traction);
}

}  // namespace
