/// Tractions beside pressures, and plane strain's components and directions.
#include <gtest/gtest.h>

#include "sample.hpp"

namespace {

using namespace soft;
using namespace soft::design;
using namespace soft::design::sample;

/// A family without a cavity whose own load is a traction.
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
        EXPECT_TRUE(holds(line, remedy)) << line;
    }
}

const std::string pulled = "loads: {end: {traction: 62.5 kPa, along: y}}\n";

TEST(Traction, IsALoadByItself) {
    const Design design = read_sheet(pulled);
    EXPECT_TRUE(design.loads.empty());
    ASSERT_EQ(design.tractions.size(), 1u);
    EXPECT_EQ(design.tractions[0].face, "end");
    EXPECT_EQ(design.tractions[0].traction_Pa, 62500.0);
    EXPECT_EQ(design.tractions[0].along, "y");
    EXPECT_EQ(design.path.control, model::Control::pressure);   // the load factor
    EXPECT_TRUE(design.warnings.empty());
}

TEST(Traction, StandsBesidePressuresOnOtherFaces) {
    const Design design = read_sheet("loads: {tip: {traction: -3 kPa, along: normal}, top: {pressure: 2 kPa}}\n");
    ASSERT_EQ(design.tractions.size(), 1u);
    EXPECT_EQ(design.tractions[0].face, "end");   // tip is another name of it
    EXPECT_EQ(design.tractions[0].traction_Pa, -3000.0);
    ASSERT_EQ(design.loads.size(), 1u);
    EXPECT_EQ(design.loads[0].target, "top");
    expect_refusal("loads: {tip: {traction: 3 kPa, along: x}, end: {pressure: 2 kPa}}\n",
                   "p.yaml:3:59: loads.end.pressure: face 'end' is loaded twice", "keep one of its names");
}

TEST(Traction, WhatContradictsItselfIsRefused) {
    expect_refusal("loads: {end: {traction: 3 kPa, pressure: 3 kPa, along: y}}\n",
                   "p.yaml:3:15: loads.end.traction: the load has a pressure already", "keep one");
    expect_refusal("loads: {end: {pressure: 3 kPa, along: y}}\n",
                   "p.yaml:3:32: loads.end.along: a pressure acts along the normal", "write traction");
    expect_refusal("loads: {end: {traction: 3 kPa}}\n", "p.yaml:3:9: loads.end.along: missing", "add along: y");
    expect_refusal("loads: {end: {traction: 0 kPa, along: y}}\n", "p.yaml:3:25: loads.end.traction: a load of 0",
                   "write the traction at full load");
    expect_refusal("loads: {end: {tracton: 3 kPa}}\n", "p.yaml:3:15: loads.end.tracton: unknown key",
                   "did you mean 'traction'?");
    expect_refusal("loads: {end: {traction: 3 kPa, along: up}}\n", "p.yaml:3:39: loads.end.along: 'up' is not a choice", "");
    expect_refusal("loads: {end: {traction: 3 mm, along: y}}\n",
                   "p.yaml:3:25: loads.end.traction: '3 mm' is a length where a pressure is needed", "");
    expect_refusal("loads: {end: {traction: 3 kPa, along: y, sealed: true}}\n",
                   "p.yaml:3:42: loads.end.sealed: a face has no openings", "leave it out");
    expect_refusal(pulled + "path: {until: {pressure: 3 kPa}}\n", "p.yaml:4:26: path.until.pressure: no load is a pressure",
                   "use an output or steps");
    expect_refusal(pulled + "path: {control: volume}\n", "p.yaml:4:17: path.control: no cavity is loaded", "use pressure");
    const std::string cavity =
        refusal("family: pipe\nmaterial: {law: neo-hookean, mu: 1 kPa}\nloads: {cavity: {traction: 1 kPa, along: x}}\n");
    EXPECT_EQ(cavity.find("p.yaml:3:18: loads.cavity.traction: a cavity is loaded by a pressure; write pressure"), 0u) << cavity;
}

TEST(Traction, FarAboveTheModulusIsNoticed) {
    const Design design = read_sheet("loads: {end: {traction: 30 MPa, along: y}}\n");
    ASSERT_EQ(design.warnings.size(), 1u);
    EXPECT_EQ(design.warnings[0].find("loads.end.traction: 30 MPa is far above"), 0u) << design.warnings[0];
}

TEST(Traction, IsInTheTemplateOfAFamilyThatUsesIt) {
    const std::string text = template_yaml(sheet());
    const Design design = read_design(text, "t", sheets(), {});
    ASSERT_EQ(design.tractions.size(), 1u) << text;
    EXPECT_EQ(design.tractions[0].traction_Pa, 20000.0);
    EXPECT_EQ(design.tractions[0].along, "y");
    EXPECT_TRUE(holds(text, "force per undeformed area")) << text;
}

TEST(Traction, ReadsBackFromTheEffectiveDesign) {
    const Design first = read_sheet(pulled);
    EXPECT_EQ(read_design(first.effective_yaml, "e", sheets(), {}).effective_yaml, first.effective_yaml);
    EXPECT_TRUE(holds(explain_design(material + pulled, "p.yaml", sheets(), {}), "given at p.yaml:3:25; force per"));
}

TEST(PlaneStrain, HasTheComponentsAndDirectionsXAndY) {
    const Design design = read_sheet(pulled + "supports: {fixed: fixed, y: top}\n");
    EXPECT_EQ(design.supports[0].fixed, (std::array{true, true, false}));
    EXPECT_EQ(design.supports[1].fixed, (std::array{false, true, false}));
    for (const char* component : {"z", "r"})
        expect_refusal(pulled + "supports: {" + component + ": top}\n",
                       std::string{"p.yaml:4:15: supports."} + component + ": a plane strain model has the components x and y",
                       "use x, y or fixed");
    for (const char* along : {"z", "r"})
        expect_refusal(pulled + "outputs: {a: {face: top, along: " + along + "}}\n",
                       "p.yaml:4:33: outputs.a.along: a plane strain model has the directions x and y", "axis, x, y or normal");
    expect_refusal("loads: {end: {traction: 1 kPa, along: z}}\n",
                   "p.yaml:3:39: loads.end.along: a plane strain model has the directions x and y", "");
}

class ApplyToTractions : public testing::Test {
protected:
    const std::string effective_ =
        read_sheet("loads: {top: {pressure: 2 kPa}, end: {traction: 50 kPa, along: y}, fixed: {traction: 1 kPa, along: x}}\n")
            .effective_yaml;

    std::string refusal_of(const std::string& path, const std::string& value) {
        const std::vector<Override> change = {{path, value}};
        try {
            static_cast<void>(apply_overrides(effective_, change));
        } catch (const Error& error) {
            return error.what();
        }
        return "accepted";
    }
};

TEST_F(ApplyToTractions, ScalesTheCasesOwn) {
    const std::vector<Override> changes = {{"loads.end.traction", "-25 kPa"}};
    const SolveChanges part = apply_overrides(effective_, changes);
    ASSERT_EQ(part.tractions.size(), 2u);
    EXPECT_EQ(part.tractions[0].index, 0u);
    EXPECT_EQ(part.tractions[0].factor, -0.5);
    EXPECT_EQ(part.tractions[1].index, 1u);
    EXPECT_EQ(part.tractions[1].factor, 1.0);
    EXPECT_EQ(part.loads.size(), 1u);
    EXPECT_EQ(part.effective_yaml, read_design(effective_, "e", sheets(), changes).effective_yaml);
}

TEST_F(ApplyToTractions, OneThatBecomesAPressureGoes) {
    const std::vector<Override> changes = {{"loads.end", "{pressure: 3 kPa}"}};
    const SolveChanges part = apply_overrides(effective_, changes);
    ASSERT_EQ(part.tractions.size(), 1u);
    EXPECT_EQ(part.tractions[0].index, 1u);
    EXPECT_EQ(part.loads.size(), 2u);
}

TEST_F(ApplyToTractions, RefusesNewOnesAndNewDirections) {
    EXPECT_EQ(refusal_of("loads.end.along", "x"),
              "--set loads.end.along: the direction is built into the case; give the same --set to mesh-gen");
    EXPECT_EQ(refusal_of("loads.top", "{traction: 3 kPa, along: x}"),
              "--set loads.top: loads.top.traction: the case has no traction on this face; give the same --set to mesh-gen");
}

}  // namespace
