#include "sweep/plan.hpp"

#include <gtest/gtest.h>

#include <set>

#include "../design/sample.hpp"

namespace {

using namespace soft;
using namespace soft::sweep;

const std::string design_text =
    "family: pipe\nmaterial: {law: neo-hookean, mu: 1 MPa}\nloads: {cavity: {pressure: 5 kPa}}\n";

Plan plan_of(const std::string& vary, const std::string& rest = "", const std::string& programs = "v1",
             const std::string& design = design_text) {
    const std::vector<design::FamilyKeys> families{design::sample::pipe()};
    const Sweep sweep = read_sweep("design: pipe.yaml\n" + rest + "vary: {" + vary + "}\n", "s.yaml");
    return make_plan(sweep, {design, "pipe.yaml", families, programs});
}

std::vector<std::string> ids(const Plan& plan) {
    std::vector<std::string> list;
    for (const PlannedDesign& row : plan.designs) list.push_back(row.id);
    return list;
}

std::string plan_refusal(const std::string& vary, const std::string& rest = "") {
    try {
        static_cast<void>(plan_of(vary, rest));
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        return error.what();
    }
    return "not refused";
}

TEST(Plan, GridHasEveryCombinationWithTheLastFactorFastest) {
    const Plan plan = plan_of("geometry.wall: [2 mm, 3 mm], material.mu: [1 MPa, 2 MPa, 3 MPa]");
    ASSERT_EQ(plan.designs.size(), 6u);
    EXPECT_EQ(plan.designs[1].values, (std::vector<std::string>{"2 mm", "2 MPa"}));
    EXPECT_EQ(plan.designs[3].values, (std::vector<std::string>{"3 mm", "1 MPa"}));
    const auto list = ids(plan);
    EXPECT_EQ(std::set<std::string>(list.begin(), list.end()).size(), 6u);
    EXPECT_NE(plan.designs[1].design_yaml.find("wall: 2 mm"), std::string::npos);
}

TEST(Plan, EqualDesignsHaveTheSameIdentifierInAnyNotation) {
    const auto plain = ids(plan_of("geometry.wall: [2 mm, 3 mm]"));
    EXPECT_EQ(ids(plan_of("geometry.wall: [2mm, 3mm]")), plain);
    EXPECT_EQ(ids(plan_of("geometry.wall: {from: 2 mm, to: 3 mm, steps: 2}")), plain);
    EXPECT_EQ(ids(plan_of("geometry.wall: [2 mm, 3 mm]", "set: {geometry.length: 100 mm}\n")), plain);  // its default
    EXPECT_EQ(ids(plan_of("geometry.wall: [2 mm, 3 mm]", "", "v1", design_text + "# a remark\n")), plain);
}

TEST(Plan, IdentifierChangesWithEverythingThatAffectsTheResult) {
    const auto plain = ids(plan_of("geometry.wall: [2 mm, 3 mm]"));
    EXPECT_NE(ids(plan_of("geometry.wall: [2 mm, 3 mm]", "", "v2"))[0], plain[0]);
    EXPECT_NE(ids(plan_of("geometry.wall: [2 mm, 3 mm]", "set: {mesh.size: 1 mm}\n"))[0], plain[0]);
    EXPECT_EQ(ids(plan_of("geometry.wall: [3 mm, 2 mm]"))[0], plain[1]);
}

TEST(Plan, DesignWithSensitivitiesNamesThemInItsFirstLineAndHasAnotherIdentifier) {
    const Plan plain = plan_of("geometry.wall: [2 mm, 3 mm]"),
               differentiated = plan_of("geometry.wall: [2 mm, 3 mm]", "sensitivity: [geometry.wall, material.mu]\n");
    EXPECT_NE(ids(differentiated)[0], ids(plain)[0]);
    EXPECT_EQ(differentiated.designs[0].design_yaml,
              "# sensitivity: geometry.wall,material.mu\n" + plain.designs[0].design_yaml);
    EXPECT_EQ(
        plan_refusal("geometry.wall: [2 mm, 3 mm]", "sensitivity: [material.mu, geometry.wal]\n"),
        "s.yaml:2:28: sensitivity: 'geometry.wal' is not a number of the design that differs from 0; did you mean "
        "'geometry.wall'?");
}

TEST(Plan, SampleIsReproducibleAndWithinItsRanges) {
    const std::string vary = "geometry.wall: {from: 2 mm, to: 4 mm}, geometry.folds: {from: 3, to: 5, scale: whole}";
    const Plan plan = plan_of(vary, "method: latin-hypercube\nsamples: 30\nseed: 4\n");
    EXPECT_EQ(ids(plan), ids(plan_of(vary, "method: latin-hypercube\nsamples: 30\nseed: 4\n")));
    EXPECT_NE(ids(plan), ids(plan_of(vary, "method: latin-hypercube\nsamples: 30\nseed: 5\n")));
    std::multiset<std::string> folds;
    for (const PlannedDesign& row : plan.designs) {
        EXPECT_TRUE(row.refusal.empty()) << row.refusal;
        folds.insert(row.values[1]);
    }
    for (const char* number : {"3", "4", "5"}) EXPECT_EQ(folds.count(number), 10u);
}

/// The first n designs of a random sample are those of a smaller sample, so that they need not be computed again.
TEST(Plan, LargerRandomSampleKeepsTheDesignsOfASmallerOne) {
    const std::string vary = "geometry.wall: {from: 2 mm, to: 4 mm}";
    const auto few = ids(plan_of(vary, "method: random\nsamples: 5\n")),
               many = ids(plan_of(vary, "method: random\nsamples: 9\n"));
    EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
}

TEST(Plan, RefusedCombinationIsARowWithItsReason) {
    const Plan plan = plan_of("mesh.order: [1, 2], mesh.formulation: [displacement, mixed]",
                              "set: {material.kappa: 100 MPa}\n");  // mixed needs order 2
    ASSERT_EQ(plan.designs.size(), 4u);
    EXPECT_TRUE(plan.designs[0].refusal.empty()) << plan.designs[0].refusal;
    EXPECT_FALSE(plan.designs[1].refusal.empty());
    EXPECT_TRUE(plan.designs[1].design_yaml.empty());
    EXPECT_EQ(plan.designs[1].id.size(), 16u);
    EXPECT_NE(plan.designs[1].id, plan.designs[0].id);
}

TEST(Plan, InvalidGeometryIsARowEvenForAListedValue) {
    const std::vector<design::FamilyKeys> families{design::sample::pipe()};
    const Sweep sweep = read_sweep("design: pipe.yaml\nvary: {geometry.wall: [2 mm, 3 mm]}\n", "s.yaml");
    const auto refuse_thick = [](const design::Design& design) {
        if (design.values.number("geometry.wall") > 0.0025) throw design.values.refuse("geometry.wall", "does not fit");
    };
    const Plan plan = make_plan(sweep, {design_text, "pipe.yaml", families, "v1", refuse_thick});
    ASSERT_EQ(plan.designs.size(), 2u);
    EXPECT_EQ(plan.designs[0].refusal, "");
    EXPECT_EQ(plan.designs[1].refusal, "s.yaml:2:30: geometry.wall: does not fit");
    EXPECT_TRUE(plan.designs[1].design_yaml.empty());
}

TEST(Plan, ValueThatNoDesignCanHaveIsAnErrorAtItsLocationInTheSweep) {
    EXPECT_EQ(plan_refusal("geometry.wal: [2 mm, 3 mm]"),
              "s.yaml:2:23: geometry.wal: unknown key; did you mean 'wall'?");
    EXPECT_EQ(plan_refusal("geometry.wall: [2 mm, 3]").substr(0, 42), "s.yaml:2:30: geometry.wall: '3' has no uni");
    EXPECT_EQ(plan_refusal("geometry.wall: [2 mm, -3 mm]").substr(0, 53),
              "s.yaml:2:30: geometry.wall: -3 mm is out of range; it");
    EXPECT_EQ(plan_refusal("geometry.wall: [2 mm, 3 mm]", "set: {mesh.size: 3 kPa}\n").substr(0, 42),
              "s.yaml:2:18: mesh.size: '3 kPa' is a press");
    EXPECT_EQ(plan_refusal("geometry.wall: {from: -1 mm, to: 3 mm}", "method: random\nsamples: 50\n").substr(0, 41),
              "s.yaml:4:30: geometry.wall: -1 mm is out ");
}

TEST(Plan, IdentifierCannotEscapeTheFolder) {
    for (const std::string& id : ids(plan_of("geometry.wall: [2 mm, 3 mm]"))) EXPECT_TRUE(is_design_id(id)) << id;
    for (const char* id :
         {"", "..", "../../evil", "/tmp/a", "0123456789abcde", "0123456789abcdeF", "0123456789abcde\n"})
        EXPECT_FALSE(is_design_id(id)) << id;
    EXPECT_NE(plan_refusal("name: [\"ok\", \"a\\n../../evil,waiting,x\"]").find("a control character"),
              std::string::npos);
    try {
        static_cast<void>(read_sweep(
            "design: d\nvary:\n  name:\n    - ok\n    - |\n      a\n      ../../evil,waiting,x\n", "s.yaml"));
        ADD_FAILURE() << "a value of several lines is accepted";
    } catch (const Error& error) {
        EXPECT_NE(std::string{error.what()}.find("several lines where one value is needed"), std::string::npos)
            << error.what();
    }
}

TEST(Plan, SettingsAreArgumentsOfMeshGen) {
    const Sweep sweep = read_sweep("design: d\nset: {mesh.size: 3mm}\nvary: {geometry.wall: [2 mm]}\n", "s.yaml");
    EXPECT_EQ(settings_text(sweep, {"", {"2 mm"}, "", ""}), "--set mesh.size=3mm --set 'geometry.wall=2 mm'");
}

}  // namespace
