// The list of material laws and silicones, on a terminal and as Markdown (docs/reference/materials.md).
#include <gtest/gtest.h>

#include <sstream>

#include "material/catalogue.hpp"
#include "process.hpp"

namespace {

using namespace soft::process;

TEST(MaterialList, FitsATerminalAndDescribesTheLaws) {
    Folder folder;
    const Outcome outcome = run(folder, "mesh-gen --list-materials");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    std::istringstream lines{outcome.out};
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 120u) << line;
    EXPECT_TRUE(contains(outcome.out, "\ngent\n"));
    EXPECT_TRUE(contains(outcome.out, "-mu jm/2 ln(1 - (I1 - 3)/jm)"));
    EXPECT_TRUE(contains(outcome.out, "ratio more than 0: value of I1 - 3 at which the chains lock"));
    EXPECT_TRUE(contains(outcome.out, "Yeoh, Rubber Chem. Technol. 66 (1993) 754"));
}

TEST(MaterialList, NamesTheSiliconesOfTheLibraryWithTheirConstants) {
    Folder folder;
    EXPECT_TRUE(contains(run(folder, "mesh-gen --list-materials").out, " dragon-skin-20,"));
    // The first set of designs/materials/dragon-skin-20.yaml.
    EXPECT_TRUE(
        contains(run(folder, "mesh-gen --list-materials --markdown").out,
                 "\n| dragon-skin-20 | yeoh | 110 % | c1 = 56.38 kPa, c2 = 13.37 kPa, c3 = -1.554 kPa | 3.8 % |\n"));
}

TEST(MaterialList, MarkdownWithoutTheListIsAUsageError) {
    Folder folder;
    EXPECT_EQ(run(folder, "mesh-gen --markdown").code, 64);
}

}  // namespace
