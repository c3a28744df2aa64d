#include <gtest/gtest.h>

#include "sweep/sweep.hpp"

namespace {

using namespace soft;
using namespace soft::sweep;

const std::string grid = "design: pipe.yaml\nvary:\n  geometry.wall: {from: 2 mm, to: 4 mm, steps: 5}\n";
const std::string cube =
    "design: pipe.yaml\nmethod: random\nsamples: 9\nvary:\n  geometry.wall: {from: 2 mm, to: 4 mm}\n";

std::string refusal(const std::string& text) {
    try {
        static_cast<void>(read_sweep(text, "s.yaml"));
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input) << text;
        return error.what();
    }
    return "not refused: " + text;
}

std::vector<std::string> levels(const Sweep& sweep) {
    std::vector<std::string> texts;
    for (int k = 0; k < level_count(sweep.factors.front()); ++k) texts.push_back(level(sweep.factors.front(), k));
    return texts;
}
std::vector<std::string> levels_of(const std::string& range) {
    return levels(read_sweep("design: pipe.yaml\nvary: {a.b: " + range + "}\n", "s.yaml"));
}

TEST(ReadSweep, ReadsEveryKey) {
    const Sweep sweep = read_sweep(
        "design: ../pipe.yaml\nmethod: latin-hypercube\nsamples: 100\nseed: 5\n"
        "vary:\n  geometry.wall: {from: 2 mm, to: 4 mm, scale: log}\n  material.law: [yeoh, gent]\n"
        "set: {mesh.size: 3 mm, supports.fixed: [a, b]}\nat: [elongation=20mm,40 mm, limit, end]\noutputs: [pressure_kPa]\n"
        "sensitivity: [geometry.wall, material.mu]\n",
        "s.yaml");
    EXPECT_EQ(sweep.design.text, "../pipe.yaml");
    EXPECT_EQ(sweep.method, Method::latin_hypercube);
    EXPECT_EQ(sweep.samples, 100);
    EXPECT_EQ(sweep.seed, 5u);
    ASSERT_EQ(sweep.factors.size(), 2u);
    EXPECT_EQ(sweep.factors[0].path, "geometry.wall");
    EXPECT_EQ(std::get<Range>(sweep.factors[0].values).scale, Scale::log);
    EXPECT_EQ(std::get<Choices>(sweep.factors[1].values).at(1).text, "gent");
    ASSERT_EQ(sweep.fixed.size(), 2u);
    EXPECT_EQ(sweep.fixed[0].value, "3 mm");
    EXPECT_EQ(sweep.fixed[0].location, "s.yaml:8:18");
    EXPECT_EQ(sweep.fixed[1].value, "[a, b]");
    std::vector<std::string> at;
    for (const SourceText& point : sweep.at) at.push_back(point.text);
    EXPECT_EQ(at, (std::vector<std::string>{"elongation=20mm", "elongation=40 mm", "limit", "end"}));
    EXPECT_EQ(sweep.outputs.at(0).text, "pressure_kPa");
    EXPECT_EQ(sweep.sensitivity.at(1).text, "material.mu");
}

TEST(ReadSweep, EvaluatesAtTheEndOfThePathByDefault) { EXPECT_EQ(read_sweep(grid, "s.yaml").at.at(0).text, "end"); }

TEST(Levels, AreEvenlySpacedBetweenTheGivenEnds) {
    EXPECT_EQ(levels_of("{from: 2 mm, to: 4mm, steps: 5}"),
              (std::vector<std::string>{"2 mm", "2.5 mm", "3 mm", "3.5 mm", "4mm"}));
    EXPECT_EQ(levels_of("{from: 0, to: 0.3, steps: 4}"), (std::vector<std::string>{"0", "0.1", "0.2", "0.3"}));
    EXPECT_EQ(levels_of("{from: 1 kPa, to: 10000 kPa, steps: 5, scale: log}"),
              (std::vector<std::string>{"1 kPa", "10 kPa", "100 kPa", "1000 kPa", "10000 kPa"}));
    EXPECT_EQ(levels_of("{from: 1, to: 4, steps: 3, scale: whole}"), (std::vector<std::string>{"1", "3", "4"}));
    EXPECT_EQ(levels_of("[neo-hookean, yeoh]"), (std::vector<std::string>{"neo-hookean", "yeoh"}));
}

TEST(ValueAt, IsTheGivenFractionOfTheRange) {
    const Factor log{"k", "", Range{{"1 Pa", ""}, {"100 Pa", ""}, 1, 100, "Pa", 0, Scale::log}};
    EXPECT_EQ(value_at(log, 0.5), "10 Pa");
    const Factor third{"k", "", Range{{"1 mm", ""}, {"2 mm", ""}, 1, 2, "mm"}};
    EXPECT_EQ(value_at(third, 1.0 / 3), "1.33333333 mm");  // nine digits
    const Factor whole{"k", "", Range{{"5", ""}, {"7", ""}, 5, 7, "", 0, Scale::whole}};
    EXPECT_EQ(value_at(whole, 0.0) + value_at(whole, 0.34) + value_at(whole, 0.67) + value_at(whole, 0.9999), "5677");
    const Factor word{"k", "", Choices{{"a", ""}, {"b", ""}}};
    EXPECT_EQ(value_at(word, 0.49) + value_at(word, 0.5), "ab");
}

TEST(ReadSweep, RejectsUnknownKeysWithASuggestion) {
    EXPECT_EQ(refusal(grid + "methd: grid\n"), "s.yaml:4:1: methd: unknown key; did you mean 'method'?");
    EXPECT_EQ(refusal("design: d\nvary: {a.b: {form: 1, to: 2, steps: 3}}\n"),
              "s.yaml:2:14: a.b.form: unknown key; did you mean 'from'?");
    EXPECT_EQ(refusal(grid + "method: gird\n"),
              "s.yaml:4:9: method: 'gird' is not a valid value; did you mean 'grid'?");
}

TEST(ReadSweep, RejectsMissingAndEmptyKeys) {
    EXPECT_EQ(refusal(""), "s.yaml:1:1: a sweep is a group of keys; write design: ..., vary: {...}");
    EXPECT_EQ(refusal("vary: {a.b: [1]}\n").substr(0, 28), "s.yaml:1:1: design: missing;");
    EXPECT_EQ(refusal("design: d\n").substr(0, 26), "s.yaml:1:1: vary: missing;");
    EXPECT_EQ(refusal("design: d\nvary: {a.b: []}\n").substr(0, 37), "s.yaml:2:13: a.b: the list is empty; ");
    EXPECT_EQ(refusal("design: d\nvary: {a.b: 3 mm}\n").substr(0, 49),
              "s.yaml:2:13: a.b: a range or a list is needed her");
    EXPECT_EQ(refusal("design: d\nvary: {a.b: {from: 1, to: 2}}\n").substr(0, 33), "s.yaml:2:13: a.b.steps: missing; ");
    EXPECT_EQ(refusal("design: d\nvary: {a.b: {from: 1, steps: 2}}\n").substr(0, 30), "s.yaml:2:13: a.b.to: missing; ");
    EXPECT_EQ(refusal("design: d\nmethod: random\nvary: {a.b: [1]}\n").substr(0, 29), "s.yaml:1:1: samples: missing;");
}

TEST(ReadSweep, RejectsInvalidRanges) {
    const auto range = [](const std::string& text) {
        return refusal("design: d\nvary: {k: {" + text + ", steps: 3}}\n");
    };
    EXPECT_EQ(range("from: 2 mm, to: 4").substr(0, 53), "s.yaml:2:28: k: '4' has another unit than '2 mm'; wri");
    EXPECT_EQ(refusal("design: d\nvary: {k: [auto, 2 mm, 0.002 m]}\n").substr(0, 57),
              "s.yaml:2:24: k: '0.002 m' has another unit than '2 mm'; w");
    EXPECT_EQ(range("from: 4 mm, to: 2 mm").substr(0, 46), "s.yaml:2:28: k: 2 mm is not more than 4 mm; wr");
    EXPECT_EQ(range("from: a, to: b").substr(0, 38), "s.yaml:2:18: k: 'a' is not a number; w");
    EXPECT_EQ(range("from: 0 Pa, to: 1 Pa, scale: log").substr(0, 39), "s.yaml:2:18: k: 0 Pa has no logarithm; ");
    EXPECT_EQ(range("from: 0.5, to: 2, scale: whole").substr(0, 47), "s.yaml:2:18: k: the ends are not whole numbers;");
    EXPECT_EQ(refusal("design: d\nvary: {k: {from: 1, to: 2, steps: 1}}\n").substr(0, 44),
              "s.yaml:2:35: k.steps: 1 is out of range; it ");
}

TEST(ReadSweep, RejectsKeysThatTheMethodDoesNotUse) {
    EXPECT_EQ(refusal(grid + "samples: 5\n").substr(0, 37), "s.yaml:4:1: samples: unused with meth");
    EXPECT_EQ(refusal(grid + "seed: 5\n").substr(0, 34), "s.yaml:4:1: seed: unused with meth");
    EXPECT_EQ(refusal("design: d\nmethod: random\nsamples: 3\nvary: {k: {from: 1, to: 2, steps: 3}}\n").substr(0, 40),
              "s.yaml:4:35: k.steps: only a grid has st");
    EXPECT_EQ(refusal("design: d\nvary: {a: {from: 1, to: 2, steps: 1000}, b: {from: 1, to: 2, steps: 1000}}\n")
                  .substr(0, 46),
              "s.yaml:2:7: vary: the grid has 1e+06 designs; ");
}

TEST(ReadSweep, RejectsAKeyThatVariesAndIsSet) {
    EXPECT_EQ(refusal(cube + "set: {geometry.wall: 3 mm}\n"),
              "s.yaml:6:22: geometry.wall: a key that varies cannot be set; write it under vary or under set");
}

TEST(ReadSweep, RejectsInvalidPoints) {
    EXPECT_EQ(refusal(grid + "at: 20mm\n").substr(0, 41), "s.yaml:4:5: at: '20mm' is not a point of ");
}

}  // namespace
