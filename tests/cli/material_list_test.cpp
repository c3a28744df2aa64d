// The list of material laws, on a terminal and in the README.
#include <gtest/gtest.h>

#include <sstream>

#include "process.hpp"

namespace {

using namespace soft::process;

constexpr std::string_view begin_mark = "<!-- materials -->\n", end_mark = "<!-- /materials -->";

/// The text between the marks in the section '## Materials' of a page; empty if there is no such section.
std::string materials_section(const std::string& page) {
    const auto heading = page.find("\n## Materials\n");
    const auto begin = page.find(begin_mark, heading == std::string::npos ? page.size() : heading);
    const auto end = page.find(end_mark, begin == std::string::npos ? page.size() : begin);
    if (end == std::string::npos) return {};
    return page.substr(begin + begin_mark.size(), end - begin - begin_mark.size());
}

TEST(MaterialList, FitsATerminalAndNamesEveryLaw) {
    Folder folder;
    const Outcome outcome = run(folder, "mesh-gen --list-materials");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    std::istringstream lines{outcome.out};
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 120u) << line;
    for (const char* law :
         {"linear-elastic", "saint-venant-kirchhoff", "neo-hookean", "neo-hookean-compressible", "mooney-rivlin",
          "yeoh", "ogden", "gent", "arruda-boyce", "holzapfel-gasser-ogden", "kraken"})
        EXPECT_TRUE(contains("\n" + outcome.out, "\n" + std::string{law} + "\n")) << law;
    EXPECT_TRUE(contains(outcome.out, "-mu jm/2 ln(1 - (I1 - 3)/jm)"));
    EXPECT_TRUE(contains(outcome.out, "ratio more than 0: value of I1 - 3 at which the chains lock"));
    EXPECT_TRUE(contains(outcome.out, "Yeoh, Rubber Chem. Technol. 66 (1993) 754"));
}

TEST(MaterialList, EqualsTheSectionOfTheReadme) {
    Folder folder;
    const Outcome outcome = run(folder, "mesh-gen --list-materials --markdown");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(materials_section(slurp(README)), outcome.out)
        << "put the output of `mesh-gen --list-materials --markdown` between the marks in README.md";
}

TEST(MaterialList, ComparisonWithTheReadmeDetectsADifference) {
    const std::string page = "# x\n## Materials\n\n<!-- materials -->\n| a |\n<!-- /materials -->\n";
    EXPECT_EQ(materials_section(page), "| a |\n");
    EXPECT_NE(materials_section(page), "| b |\n");
    EXPECT_EQ(materials_section("# x\n<!-- materials -->\n| a |\n<!-- /materials -->\n"), "");
}

TEST(MaterialList, MarkdownWithoutTheListIsAUsageError) {
    Folder folder;
    EXPECT_EQ(run(folder, "mesh-gen --markdown").code, 64);
}

}  // namespace
