#include "optimize/goal.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace soft::optimize {
namespace {

const std::string whole =
    "design: bellows.yaml\n"
    "set: {mesh.size: 2 mm}\n"
    "vary:\n"
    "  geometry.wall: {from: 1.5 mm, to: 4 mm}\n"
    "  geometry.convolutions: {from: 6, to: 14}\n"
    "targets:\n"
    "  - {elongation: 60 mm, at: {pressure: 20 kPa}, within: 1 %}\n"
    "  - {limit: {pressure: 45 kPa}}\n"
    "minimize: rubber_volume\n"
    "constraints:\n"
    "  - {stretch_p99: {below: 2}, at: {pressure: 20 kPa}}\n"
    "  - {geometry.bore_radius + 2 * geometry.wall: {below: 9 mm}}\n"
    "  - {stable: true}\n";

std::string refusal(const std::string& text) {
    try {
        static_cast<void>(read_goal(text, "goal.yaml"));
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Goal, HasVariablesConditionsAndAnObjective) {
    const Goal goal = read_goal(whole, "goal.yaml");
    ASSERT_EQ(goal.variables.size(), 2u);
    EXPECT_DOUBLE_EQ(goal.variables[0].from, 1.5e-3);
    EXPECT_FALSE(goal.variables[0].is_whole);
    EXPECT_EQ(goal.variables[0].text_of(2.5e-3), "2.5 mm");
    ASSERT_EQ(goal.conditions.size(), 4u);
    EXPECT_DOUBLE_EQ(goal.conditions[0].value_SI, 0.06);
    EXPECT_DOUBLE_EQ(goal.conditions[0].measure.at_SI, 20e3);
    EXPECT_DOUBLE_EQ(goal.conditions[0].within, 0.01);
    EXPECT_EQ(goal.conditions[0].measure.text, "elongation at pressure 20 kPa");
    EXPECT_EQ(goal.conditions[1].measure.kind, Measure::Kind::limit);
    EXPECT_DOUBLE_EQ(goal.conditions[1].within, 5e-3);
    EXPECT_EQ(goal.conditions[2].relation, Condition::Relation::below);
    ASSERT_EQ(goal.conditions[3].measure.terms.size(), 2u);
    EXPECT_EQ(goal.conditions[3].measure.terms[1].factor, 2);
    EXPECT_EQ(goal.conditions[3].measure.terms[1].key, "geometry.wall");
    EXPECT_TRUE(goal.stable);
    ASSERT_TRUE(goal.minimize);
    EXPECT_EQ(goal.minimize->kind, Measure::Kind::rubber_volume);
}

TEST(Goal, KeysOfCountsStayWhole) {
    Goal goal = read_goal(whole, "goal.yaml");
    design::Design design;
    design.parameters = {{"geometry.wall", "mm", 1e-3, 3e-3}};
    design.values.set("geometry.wall", {3e-3, "3 mm", "", true, {3e-3}});
    design.values.set("geometry.convolutions", {10, "10", "", true, {10}});
    EXPECT_EQ(start_of(goal, {&design, 1}), (std::vector<double>{3e-3, 10}));
    EXPECT_FALSE(goal.variables[0].is_whole);
    EXPECT_TRUE(goal.variables[1].is_whole);
    EXPECT_EQ(goal.variables[1].text_of(7.2), "7");
    goal.variables[1].to = 13.5;
    EXPECT_THROW(static_cast<void>(start_of(goal, {&design, 1})), Error);
    // A pure number that is no count varies continuously, also between whole ends.
    Goal ratio = read_goal("design: a.yaml\nvary: {material.alpha: {from: 1, to: 5}}\nminimize: rubber_volume\n", "g");
    design.parameters.push_back({"material.alpha", "", 1, 2});
    design.values.set("material.alpha", {2, "2", "", true, {2}});
    static_cast<void>(start_of(ratio, {&design, 1}));
    EXPECT_FALSE(ratio.variables[0].is_whole);
}

TEST(Goal, HasARunForEachDesignAndSetOfChanges) {
    const Goal goal = read_goal(
        "design: a.yaml\nset: {mesh.size: 2 mm}\nvary: {m: {from: 1 kPa, to: 4 kPa, prior: 2 kPa, sd: 100 Pa}}\n"
        "targets:\n"
        "  - {curve: one.csv, set: {loads.tip.force: 1 N}}\n"
        "  - {curve: two.csv, set: {loads.tip.force: 2 N}, at: drop, columns: load=3, from: 1 mm, weight: 4}\n"
        "  - {drop: 7 mm, at: {load: 1 N}, set: {loads.tip.force: 1 N}}\n"
        "  - {bend: 7 deg, at: {pressure: 1 kPa}, design: b.yaml}\n",
        "goal.yaml");
    ASSERT_EQ(goal.runs.size(), 4u);
    EXPECT_EQ(goal.runs[2].set.size(), 2u);  // also the mesh
    EXPECT_EQ(goal.runs[3].design_file, "b.yaml");
    EXPECT_TRUE(goal.runs[3].set.empty());
    ASSERT_EQ(goal.curves.size(), 2u);
    EXPECT_EQ(goal.curves[1].run, 2u);
    EXPECT_EQ(goal.curves[1].at, "drop");
    EXPECT_DOUBLE_EQ(goal.curves[1].within, goal.curves[0].within / 2);
    ASSERT_EQ(goal.conditions.size(), 3u);
    EXPECT_EQ(goal.conditions[0].measure.run, 1u);
    EXPECT_EQ(goal.conditions[1].measure.run, 3u);
    EXPECT_TRUE(goal.conditions[2].is_data);  // the prior
    EXPECT_DOUBLE_EQ(goal.conditions[2].allowed_SI(), 100);
}

TEST(Goal, TheErrorOfAPriorMayBeAShareOfIt) {
    const Goal goal = read_goal(
        "design: a.yaml\nvary: {m: {from: 100 kPa, to: 0.4 MPa, prior: 200 kPa, sd: 5 %}}\ntargets: [{curve: c.csv}]\n",
        "goal.yaml");
    EXPECT_DOUBLE_EQ(goal.variables[0].to, 4e5);
    EXPECT_DOUBLE_EQ(goal.conditions[0].allowed_SI(), 1e4);
}

TEST(Goal, RefusesValuesOfAnotherKind) {
    const auto with = [](const std::string& range, const std::string& target) {
        return refusal("design: a.yaml\nvary: {m: {from: 1 kPa, to: " + range + "}}\ntargets: [{" + target + "}]\n");
    };
    const std::string curve = "curve: c.csv";
    EXPECT_NE(with("4 mm", curve).find("vary.m.to: "), std::string::npos);
    EXPECT_NE(with("4 kPa, prior: 150, sd: 5 %", curve).find("vary.m.prior: "), std::string::npos);
    EXPECT_NE(with("4 kPa, prior: 2 mm, sd: 1 mm", curve).find("vary.m.prior: "), std::string::npos);
    EXPECT_NE(with("4 kPa, prior: 2 kPa, sd: 5", curve).find("vary.m.sd: "), std::string::npos);
    EXPECT_NE(with("4 kPa", curve + ", within: 1 mm").find("targets.within: "), std::string::npos);
    EXPECT_NE(with("4 kPa", curve + ", design: [b]").find("the name of a file is needed here"), std::string::npos);
    EXPECT_NE(with("4 kPa", curve + ", set: {m: 2 kPa}").find("set.m: is varied too"), std::string::npos);
}

TEST(Goal, EachBoundIsACondition) {
    const Goal goal = read_goal(
        "design: a.yaml\nvary: {a: {from: 1 mm, to: 4 mm}}\nconstraints:\n"
        "  - {grow: {above: 1 mm, below: 2 mm}, at: {pressure: 3 kPa}}\n"
        "  - {limit: {pressure: {below: 8 kPa, above: 6 kPa}}}\n"
        "  - {b - 2 * a: {above: 3 mm}}\nminimize: rubber_volume\n",
        "goal.yaml");
    ASSERT_EQ(goal.conditions.size(), 5u);
    const std::vector wanted{Condition::Relation::above, Condition::Relation::below, Condition::Relation::below,
                             Condition::Relation::above, Condition::Relation::above};
    const std::vector bounds{1e-3, 2e-3, 8e3, 6e3, 3e-3};
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        EXPECT_EQ(goal.conditions[i].relation, wanted[i]) << i;
        EXPECT_DOUBLE_EQ(goal.conditions[i].value_SI, bounds[i]) << i;
    }
    EXPECT_EQ(goal.conditions[1].measure.text, "grow at pressure 3 kPa");
    EXPECT_EQ(goal.conditions[3].measure.kind, Measure::Kind::limit);
    const auto& terms = goal.conditions[4].measure.terms;
    ASSERT_EQ(terms.size(), 2u);
    EXPECT_EQ(terms[0].factor, 1);
    EXPECT_EQ(terms[1].factor, -2);
    EXPECT_EQ(terms[1].key, "a");
}

TEST(Goal, RefusesKeysThatHaveNoEffect) {
    const std::string head = "design: a.yaml\nvary: {a: {from: 1 mm, to: 4 mm}}\n";
    const auto constraint = [&](const std::string& text) { return refusal(head + "constraints: [{" + text + "}]\n"); };
    const auto target = [&](const std::string& text) { return refusal(head + "targets: [{" + text + "}]\n"); };
    EXPECT_NE(constraint("grow: {above: 2 mm, below: 1 mm}, at: {pressure: 3 kPa}").find("`above` is not less than"),
              std::string::npos);
    EXPECT_NE(constraint("grow: {above: 2 mm}, at: {pressure: 3 kPa}, within: 1 %").find("a bound has no tolerance"),
              std::string::npos);
    EXPECT_NE(constraint("stable: true, at: {grow: 5 mm}").find("has the value true and no further keys"),
              std::string::npos);
    EXPECT_NE(constraint("stable: false").find("has the value true"), std::string::npos);
    EXPECT_NE(target("limit: {pressure: 15 kPa, grow: 3 mm}").find("'grow' is a second quantity"), std::string::npos);
    EXPECT_NE(target("limit: {pressure: 15 kPa}, at: {grow: 3 mm}").find("targets.at: a limit point has its own"),
              std::string::npos);
    EXPECT_NE(target("grow: 1 mm, at: {pressure: 3 kPa, volume: 2 mL}").find("'volume' is a second quantity"),
              std::string::npos);
    EXPECT_NE(
        refusal(head + "minimize: {stretch_p99: {at: {pressure: 3 kPa}, foo: 1}}\n").find("minimize.foo: unknown"),
        std::string::npos);
}

TEST(Goal, RefusesWithPlaceProblemAndRemedy) {
    EXPECT_EQ(refusal("design: a.yaml\nvary: {geometry.wall: {from: 4 mm, to: 1 mm}}\ntargets: []\n"),
              "goal.yaml:2:40: vary.geometry.wall.to: is not larger than `from`");
    EXPECT_EQ(
        refusal("design: a.yaml\nvary: {geometry.wall: {from: 1 mm, to: 4 mm}}\n"),
        "goal.yaml:1:1: targets: the goal has no targets and minimizes nothing; add targets: [{elongation: 60 mm, "
        "at: {pressure: 20 kPa}}]");
    EXPECT_NE(refusal("design: a.yaml\nvary: {a: {from: 1, to: 4}}\ntarget: []\n").find("did you mean 'targets'?"),
              std::string::npos);
    EXPECT_NE(refusal("design: a.yaml\nvary: {a: {from: 1 mm, to: 4 mm}}\ntargets: [{elongation: 60 mm}]\n")
                  .find("the key 'at' is missing"),
              std::string::npos);
    EXPECT_EQ(
        refusal(
            "design: a.yaml\nvary: {a: {from: 1 mm, to: 4 mm, prior: 2 mm}}\ntargets: [{limit: {pressure: 1 kPa}}]\n"),
        "goal.yaml:2:8: vary.a: `prior` and `sd` belong together; write for example prior: 84 kPa, sd: 5 kPa");
    EXPECT_EQ(refusal("design: a.yaml\nvary: {a: {from: 1 mm, to: 4 mm}}\ntargets: [{curve: m.csv}]\nminimize: "
                      "rubber_volume\n"),
              "goal.yaml:4:11: minimize: a goal with measured curves or priors minimizes the differences from them; "
              "omit it");
    EXPECT_NE(refusal("design: a.yaml\nvary: {a: {from: 1 mm, to: 4 mm}}\ntargets: [{curve: m.csv, form: 2 mm}]\n")
                  .find("did you mean 'from'?"),
              std::string::npos);
    EXPECT_NE(refusal("").find("goal.yaml"), std::string::npos);
}

}  // namespace
}  // namespace soft::optimize
