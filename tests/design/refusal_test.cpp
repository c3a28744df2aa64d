#include <gtest/gtest.h>

#include "sample.hpp"

namespace {

using namespace soft::design;
using namespace soft::design::sample;

/// Expects an error that starts with "location: key path" and contains a part of the rest.
void expect(const std::string& text, std::string_view start, std::string_view part) {
    const std::string line = refusal(text);
    EXPECT_EQ(line.find(start), 0u) << line;
    EXPECT_TRUE(contains(line, part)) << line;
}

TEST(Refusal, UnknownKeyGetsASuggestion) {
    expect(base + "geometry:\n  wal: 3 mm\n", "p.yaml:5:3: geometry.wal: unknown key", "did you mean 'wall'?");
    expect(base + "geomtry: {wall: 3 mm}\n", "p.yaml:4:1: geomtry: unknown key", "did you mean 'geometry'?");
    expect(base + "geometry: {disc: {radus: 3 mm}}\n", "p.yaml:4:19: geometry.disc.radus: unknown key",
           "did you mean 'radius'?");
    expect(base + "geometry: {colour: red}\n", "p.yaml:4:12: geometry.colour",
           "known: length, wall, folds, disc, skew");
    expect(base + "solver: {tolerance: 1}\n", "p.yaml:4:10: solver.tolerance: unknown key",
           "known: residual_tolerance");
    expect(base + "path: {untl: {steps: 3}}\n", "p.yaml:4:8: path.untl: unknown key", "did you mean 'until'?");
    expect(base + "path: {until: {elongatoin: 3 mm}}\n", "p.yaml:4:16: path.until.elongatoin: unknown key",
           "'elongation'");
    expect(base + "\"geometry.wall\": 3 mm\n", "p.yaml:4:1: geometry.wall: a key contains a dot", "--set");
}

TEST(Refusal, QuantityRequiresAValidUnit) {
    expect(base + "geometry: {wall: 3}\n", "p.yaml:4:18: geometry.wall: '3' has no unit", "write for example 3 mm");
    expect(base + "geometry: {wall: 3 kPa}\n",
           "p.yaml:4:18: geometry.wall: '3 kPa' is a pressure where a length is needed", "mm");
    expect(base + "geometry: {wall: 3 mn}\n", "p.yaml:4:18: geometry.wall: unknown unit 'mn'",
           "write for example 3 mm (units: m, cm, mm,");
    expect(base + "geometry: {folds: 3.5}\n", "p.yaml:4:19: geometry.folds: '3.5' is not a whole number", "");
    expect(base + "geometry: {wall: .inf mm}\n", "p.yaml:4:18: geometry.wall:", "is not a number");
}

TEST(Refusal, RangeIsReportedInSuitableUnits) {
    expect(base + "geometry: {wall: -3 mm}\n", "p.yaml:4:18: geometry.wall: -3 mm is out of range", "more than 0");
    expect(base + "geometry: {wall: 0 mm}\n", "p.yaml:4:18: geometry.wall: 0 mm is out of range", "more than 0");
    expect(base + "geometry: {folds: 51}\n", "p.yaml:4:19: geometry.folds: 51 is out of range",
           "at least 1, at most 50");
    expect(base + "mesh: {order: 3}\n", "p.yaml:4:15: mesh.order: 3 is out of range", "at least 1, at most 2");
    expect(base + "solver: {first_step: 2}\n", "p.yaml:4:22: solver.first_step: 2 is out of range", "at most 1");
}

TEST(Refusal, MissingKeyIsReportedAtItsSection) {
    expect("", "p.yaml: the design is empty", "--template");
    expect("# nothing\n", "p.yaml: the design is empty", "--template");
    expect("name: x\n", "p.yaml:1:1: family: missing", "pipe | bar");
    expect("family: pipe\n", "p.yaml:1:1: material: missing", "law: neo-hookean");
    expect("family: pipe\nmaterial: {law: neo-hookean}\nloads: {cavity: {pressure: 1 kPa}}\n",
           "p.yaml:2:1: material.mu: missing", "add mu: 0.1644 MPa");
    expect("family: pipe\nmaterial: {mu: 1 kPa}\nloads: {cavity: {pressure: 1 kPa}}\n",
           "p.yaml:2:12: material.mu: unknown key", "law");
    expect("family: pipe\nmaterial: {law: neo-hookean, mu: 1 kPa}\n", "p.yaml:1:1: loads: missing",
           "cavity: {pressure: 30 kPa}");
    expect("family: pipe\nmaterial: {law: neo-hookean, mu: 1 kPa}\nloads:\n  cavity: {sealed: true}\n",
           "p.yaml:4:3: loads.cavity.pressure: missing",
           "add pressure: 25 kPa");  // the default load of the family
}

TEST(Refusal, UnknownFamilyLawFaceAndChoiceGetSuggestions) {
    expect("family: pip\n", "p.yaml:1:9: family: no family is called 'pip'", "did you mean 'pipe'?");
    expect("family: pipe\nmaterial: {law: neo-hokean}\n", "p.yaml:2:17: material.law: no law is called",
           "did you mean 'neo-hookean'?");
    expect("family: pipe\nmaterial: dragon-skin-2O\n",
           "p.yaml:2:11: material.name: no silicone is called 'dragon-skin-2O'", "did you mean 'dragon-skin-20'?");
    expect(base + "supports: {fixed: inlt}\n", "p.yaml:4:19: supports.fixed: no face is called 'inlt'",
           "did you mean 'inlet'?");
    expect(base + "supports: {fixed: [inlet, end-disc]}\n", "p.yaml:4:27: supports.fixed:", "did you mean 'end_disc'?");
    expect(base + "supports: {end_disc: fixed}\n", "p.yaml:4:12: supports.end_disc: a face is given where a component",
           "write fixed: end_disc");
    expect("family: pipe\nmaterial: {law: neo-hookean, mu: 1 kPa}\nloads: {cavty: {pressure: 1 kPa}}\n",
           "p.yaml:3:9: loads.cavty: unknown key", "'cavity'");
    expect(base + "model: solit\n", "p.yaml:4:8: model: 'solit' is not a valid value", "did you mean 'solid'?");
    expect(base + "path: {control: volum}\n", "p.yaml:4:17: path.control:", "did you mean 'volume'?");
}

TEST(Refusal, ValueInPlaceOfAGroupAndGroupInPlaceOfAValueAreRejected) {
    expect(base + "geometry: 3 mm\n", "p.yaml:4:11: geometry: a group of keys is needed", "known: length, wall");
    expect(base + "geometry: {wall: {a: 1}}\n", "p.yaml:4:18: geometry.wall: a single value is needed", "length");
    expect(base + "geometry: {wall: [1 mm]}\n", "p.yaml:4:18: geometry.wall: a single value", "");
    expect(base + "geometry: {wall: }\n", "p.yaml:4:", "geometry.wall: has no value");
    expect("family: pipe\nmaterial: {law: neo-hookean, mu: 1 kPa}\nloads: {cavity: 30 kPa}\n",
           "p.yaml:3:17: loads.cavity: a group of keys",
           "known: pressure, sealed, plug_thrust, acts_on, gas, volume, volume_ratio, mass, valve, shares");
    expect("family: {a: b}\n", "p.yaml:1:9: family: a single value", "");
    expect("- family\n", "p.yaml:1:1: a design is a group of keys", "");
    expect("just text\n", "p.yaml:1:1: a design is a group of keys", "");
    expect("family: pipe\nmaterial: {law: [a]}\nloads: {cavity: {pressure: 1 kPa}}\n",
           "p.yaml:2:17: material.law: a single value", "");
}

TEST(Refusal, ContradictoryKeysAreRejected) {
    const std::string bar = "family: bar\nmaterial: {law: neo-hookean, mu: 1 kPa}\nloads: {end: {pressure: -1 kPa}}\n";
    expect(bar + "path: {control: volume}\n", "p.yaml:4:17: path.control: no cavity", "use auto");
    expect(bar + "path: {until: {volume_ratio: 2}}\n", "p.yaml:4:30: path.until.volume_ratio: no cavity", "");
    expect("family: bar\nmaterial: {law: neo-hookean, mu: 1 kPa}\nloads: {end: {pressure: -1 kPa, sealed: true}}\n",
           "p.yaml:3:33: loads.end.sealed: a face has no openings", "");
    expect("family: pipe\nmaterial: {law: neo-hookean, mu: 1 kPa}\nloads: {cavity: {pressure: 0 kPa}}\n",
           "p.yaml:3:28: loads.cavity.pressure: a load of 0", "");
    expect(
        "family: pipe\nmaterial: {law: neo-hookean, mu: 1 kPa}\n"
        "loads: {fixed: {pressure: 1 kPa}, end_disc: {pressure: 2 kPa}}\n",
        "p.yaml:3:56: loads.end_disc.pressure: face 'fixed' is loaded twice", "");
    expect(base + "supports: {fixed: [fixed, end_disc]}\n", "p.yaml:4:27: supports.fixed: face 'fixed' is named twice",
           "");
    expect(base + "supports: {y: inlet}\n", "p.yaml:4:15: supports.y: an axisymmetric model has the components x and r",
           "");
    expect(base + "outputs: {sway: {face: inlet, along: z}}\n",
           "p.yaml:4:38: outputs.sway.along: an axisymmetric model", "");
    expect(base + "outputs: {pressure: {face: inlet}}\n", "p.yaml:4:11: outputs.pressure: the name is reserved", "");
    expect(base + "outputs: {a-b: {face: inlet}}\n", "p.yaml:4:11: outputs.a-b: not a name", "letters");
    expect(base + "outputs: {a: {face: [inlet, outer]}}\n",
           "p.yaml:4:21: outputs.a.face: an output is measured on one face", "");
    expect(base + "path: {until: {elongation: 0 mm}}\n",
           "p.yaml:4:28: path.until.elongation: 0 is where the path starts", "");
    expect(base + "name: \"a\\nb\"\n", "p.yaml:4:7: a control character in 'a?b'", "");
}

TEST(Refusal, FirstOfSeveralErrorsInTheDocumentIsReported) {
    expect(base + "geometry: {wall: 3, wal: 2}\nmesh: {sise: 1}\n", "p.yaml:4:18: geometry.wall", "");
    expect(base + "geometry: {wal: 2, wall: 3}\n", "p.yaml:4:12: geometry.wal:", "");
}

TEST(Refusal, MessageStaysOneShortLineForAMaliciousKey) {
    expect(base + "? \"\\e[31m" + std::string(5000, 'k') + "\"\n: 1\n", "p.yaml:4:3: a control character in '?[31mkkk",
           "...");
    expect(base + "geometry: {wall: " + std::string(5000, 'w') + "}\n", "p.yaml:4:18: geometry.wall", "...");
}

}  // namespace
