#include <gtest/gtest.h>

#include <algorithm>

#include "sample.hpp"

namespace {

using namespace soft::design;
using namespace soft::design::sample;

TEST(EffectiveYaml, IsReproducedByteForByte) {
    const std::string rich =
        std::string{minimal_design} +
        "name: \"odd: name # really\"\ngeometry: {skew: 12.5deg, wall: 2.50mm}\nmodel: solid\n"
        "supports: {x: [inlet, end_disc], fixed: fixed}\npath: {until: {steps: 7, elongation: 1e1 mm}}\n"
        "outputs: {b: {face: inlet, along: y}, a: {face: outer}, elongation: {face: inlet}}\n";
    for (const std::string& text :
         {std::string{minimal_design}, rich, std::string{minimal_design} + "supports: {}\noutputs: {}\n"}) {
        const Design first = read(text);
        const Design second = read(first.effective_yaml);
        EXPECT_EQ(first.effective_yaml, second.effective_yaml);
        EXPECT_EQ(first.name, second.name);
        EXPECT_EQ(first.supports.size(), second.supports.size());
        EXPECT_EQ(first.outputs.size(), second.outputs.size());
        for (const Key& key : pipe().geometry)
            EXPECT_EQ(first.values.number(key.path), second.values.number(key.path)) << key.path;
    }
}

TEST(EffectiveYaml, ContainsEveryDefaultAndKeepsUnits) {
    const std::string yaml = read(std::string{minimal_design} + "geometry: {wall: 0.25cm}\n").effective_yaml;
    for (const char* line : {"  wall: 0.25 cm\n", "  length: 100 mm\n", "  kappa: incompressible\n",
                             "  volumetric: quadratic\n", "  size: 1.5 mm\n", "  formulation: mixed\n",
                             "  sealed: true\n", "  control: auto\n", "  newton_limit: 16\n", "model: axisymmetric\n"})
        EXPECT_TRUE(contains("\n" + yaml, line)) << line << yaml;
}

TEST(EffectiveYaml, DoesNotDependOnTheOrderOrStyleOfTheDesign) {
    const std::string other =
        "loads:\n  cavity:\n    pressure:   30kPa\nmaterial:\n  mu: 0.1644MPa\n"
        "  law: neo-hookean\nfamily: 'pipe'   # the same\n";
    EXPECT_EQ(read(other).effective_yaml, read(minimal_design).effective_yaml);
}

TEST(Template, IsADesignWithTheDefaultsOfTheFamily) {
    for (const FamilyKeys& family : families()) {
        const std::string text = template_yaml(family);
        const Design design = read(text);
        EXPECT_EQ(design.family, family.name);
        for (const Key& key : family.geometry) {
            EXPECT_TRUE(contains(text, key.meaning)) << key.path;
            EXPECT_EQ(design.values.text(key.path), key.fallback);
        }
        EXPECT_TRUE(design.warnings.empty());
    }
    const Design pipe_design = read(template_yaml(pipe()));
    EXPECT_EQ(supply(pipe_design).value, 25000.0);  // the family's own example
    EXPECT_EQ(supply(read(template_yaml(bar()))).value, -50000.0);
}

TEST(Template, ContainsDefaultRangeAndMeaningOfEveryKey) {
    const std::string text = template_yaml(pipe());
    const std::string folds =
        text.substr(text.find("folds:"), text.find('\n', text.find("folds:")) - text.find("folds:"));
    EXPECT_TRUE(contains(folds, "number of folds; whole number at least 1, at most 50; default 4")) << folds;
    EXPECT_TRUE(contains(text, "incompressible rubber; pressure more than 0; required")) << text;
    // Every line with a value has a comment.
    std::size_t start = 0;
    while (start < text.size()) {
        const std::size_t end = text.find('\n', start);
        const std::string line = text.substr(start, end - start);
        const bool has_value = !line.starts_with('#') && contains(line, ": ") && line.back() != ':';
        EXPECT_TRUE(!has_value || contains(line, "# ")) << line;
        start = end + 1;
    }
}

TEST(Explain, RejectsWhatReadDesignRejects) {
    const std::string contradiction =
        "family: bar\nmaterial: {law: neo-hookean, mu: 1 kPa}\n"
        "loads: {end: {pressure: -1 kPa}}\npath: {control: volume}\n";
    EXPECT_THROW(static_cast<void>(explain_design(contradiction, "p.yaml", families(), {})), soft::Error);
}

TEST(Explain, DistinguishesGivenValuesFromDefaults) {
    const std::vector<Override> changes = {{"geometry.folds", "7"}};
    const std::string text =
        explain_design(std::string{minimal_design} + "geometry: {wall: 2 mm}\n", "p.yaml", families(), changes);
    const auto line_of = [&](const std::string& key) {
        const auto start = text.find(key);
        return text.substr(start, text.find('\n', start) - start);
    };
    EXPECT_TRUE(contains(line_of("  wall:"), "2 mm")) << text;
    EXPECT_TRUE(contains(line_of("  wall:"), "given at p.yaml:4:18; thickness of the wall")) << text;
    EXPECT_TRUE(contains(line_of("  folds:"), "given at --set geometry.folds"));
    EXPECT_TRUE(contains(line_of("  length:"), "default; outer length"));
    EXPECT_EQ(read(text).effective_yaml,
              read(std::string{minimal_design} + "geometry: {wall: 2 mm, folds: 7}\n").effective_yaml);
}

}  // namespace
