#include "sweep/table.hpp"

#include <gtest/gtest.h>

namespace {

using namespace soft;
using namespace soft::sweep;

const Sweep walls = read_sweep("design: d\nvary: {geometry.wall: [2 mm, 3 mm], material.law: [yeoh]}\n", "s.yaml");
const Plan two_walls{{{"aa", {"2 mm", "yeoh"}, "x", ""}, {"bb", {"3mm", "yeoh"}, "x", ""}}};

TEST(FactorColumns, OfOneUnitAreNumbersAndOthersAreWords) {
    const auto columns = factor_columns(walls, two_walls);
    ASSERT_EQ(columns.size(), 2u);
    EXPECT_EQ(columns[0].name, "geometry_wall_mm");
    EXPECT_EQ(columns[0].label, "geometry.wall");
    EXPECT_EQ(columns[0].unit, "mm");
    EXPECT_EQ(columns[0].numbers(), (std::vector<std::optional<double>>{2, 3}));
    EXPECT_EQ(columns[1].cells, (std::vector<std::string>{"yeoh", "yeoh"}));
    EXPECT_TRUE(columns[1].numbers().empty());
}

TEST(OutputColumns, HaveACellForEachDesignAndKeepTheirLabel) {
    const std::vector<Outcome> outcomes{
        {.exit_code = 0, .outputs = {{"p_kPa_at_end", 1.5, "p at end", "kPa"}}},
        {.exit_code = 65},
        {.exit_code = 0,
         .outputs = {{"p_kPa_at_end", std::nullopt, "p at end", "kPa"}, {"u_mm_at_end", 2, "u at end", "mm"}}}};
    const auto columns = output_columns(outcomes);
    ASSERT_EQ(columns.size(), 2u);
    EXPECT_EQ(columns[0].cells, (std::vector<std::string>{"1.5", "", ""}));
    EXPECT_EQ(columns[1].cells, (std::vector<std::string>{"", "", "2"}));
    EXPECT_EQ(columns[0].numbers(), (std::vector<std::optional<double>>{1.5, std::nullopt, std::nullopt}));
    EXPECT_EQ(find_column(columns, "u at end"), &columns[1]);
    EXPECT_EQ(find_column(columns, "p_kPa_at_end"), &columns[0]);
    EXPECT_EQ(find_column(columns, "p"), nullptr);
}

}  // namespace
