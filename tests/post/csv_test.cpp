#include "post/csv.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "path_samples.hpp"

namespace soft::post {
namespace {

std::vector<std::vector<double>> parse_rows(const std::string& text) {
    std::vector<std::vector<double>> rows;
    std::istringstream lines{text};
    std::string line;
    std::getline(lines, line);  // header
    while (std::getline(lines, line)) {
        std::istringstream cells{line};
        rows.emplace_back();
        for (std::string cell; std::getline(cells, cell, ',');)
            rows.back().push_back(std::strtod(cell.c_str(), nullptr));
    }
    return rows;
}

TEST(Csv, EveryNumberReadsBackToTheSameDouble) {
    const Curve curve = make_curve(test::sample_case({"growth"}), test::sphere_path(23, 2.9));
    const auto rows = parse_rows(csv_text(curve));
    ASSERT_EQ(rows.size(), 23u);
    for (std::size_t row = 0; row < rows.size(); ++row) {
        ASSERT_EQ(rows[row].size(), curve.columns.size());
        for (std::size_t i = 0; i < curve.columns.size(); ++i) EXPECT_EQ(rows[row][i], curve.columns[i].values[row]);
    }
}

TEST(Csv, WritesCountsAndFlagsAsIntegersAndUnixLineEnds) {
    model::Step step;
    step.pressure_Pa = 100;
    step.stable = false;
    const std::vector<model::Step> steps{step};
    EXPECT_EQ(csv_text(make_curve(test::sample_case(), steps)),
              "step,pressure_kPa,stretch_p99,max_stretch,min_J,stable\n0,0.1,1,1,1,0\n");
}

TEST(Csv, PrefixesEveryLineOfACommentBeforeTheHeader) {
    const std::vector<std::string> comments{"solve 0.1.0", "design:\nfamily: tube\033[31m\xff"};
    const std::string text = csv_text(make_curve(test::sample_case(), std::vector<model::Step>(1)), comments);
    EXPECT_TRUE(text.starts_with("# solve 0.1.0\n# design:\n# family: tube?[31m?\nstep,")) << text;
}

}  // namespace
}  // namespace soft::post
