#include "fit/report.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "samples.hpp"

namespace soft::fit {
namespace {

bool contains(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

TEST(Report, WritesConstantsWithUnitsErrorsAndOriginOfTheData) {
    const std::vector<TestCurve> tests{sample("dragon-skin-20.csv", Mode::uniaxial, {.range = {0, 1.1}})};
    const std::string yaml =
        material_yaml(fit(law("yeoh"), tests), tests,
                      {.command_line = "fit-material x", .notice = "ODbL 1.0\nMarechal", .protocol = "ASTM D412"});
    for (const char* words :
         {"# ODbL 1.0\n# Marechal\n", "material:\n  law: yeoh\n  c1: ", " kPa   # +- ", "  kappa: incompressible\n",
          "  fit:\n    range: '4.46:109.091 %'", "    rmse_kPa: ", "    r2: ", "    max_error: '", "    rows: 47\n",
          "    stress: 'engineering'\n", "    sha256: '", "    protocol: 'ASTM D412'\n"})
        EXPECT_TRUE(contains(yaml, words)) << words << "\n" << yaml;
}

TEST(Report, LineFeedsInNamesDoNotBreakTheYaml) {
    std::vector<TestCurve> tests{sample("dragon-skin-20.csv")};
    tests[0].source = "a'\n  law: b";
    const std::string yaml =
        material_yaml(fit(law("neo-hookean"), tests), tests,
                      {.command_line = "fit-material --protocol 'x\nlaw: c'", .protocol = "x\nlaw: c"});
    EXPECT_TRUE(contains(yaml, "source: 'uniaxial a''?  law: b'\n")) << yaml;
    EXPECT_FALSE(contains(yaml, "\nlaw: c")) << yaml;
}

TEST(Report, WritesOgdenTermsAsLists) {
    const std::vector<TestCurve> tests = treloar();
    const std::string yaml = material_yaml(fit(law("ogden-2"), tests), tests, {});
    EXPECT_TRUE(contains(yaml, "  mu: [")) << yaml;
    EXPECT_TRUE(contains(yaml, "  alpha: [")) << yaml;
}

TEST(Report, RankTableHasOneLinePerLaw) {
    const std::string table = rank_table(rank(treloar()));
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), static_cast<std::ptrdiff_t>(candidates().size() + 1));
    EXPECT_TRUE(contains(table, "predicts_planar"));
}

}  // namespace
}  // namespace soft::fit
