// Every problem agrees with its references, and README.md agrees with the computed values.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "problem.hpp"
#include "table.hpp"

namespace soft::verification {

void PrintTo(const Problem& problem, std::ostream* out) { *out << problem.name; }

namespace {

const Printed& readme() {
    static const Printed printed = [] {
        std::ifstream stream(std::string(SOFT_SOURCE_DIR) + "/tests/verification/README.md");
        std::stringstream text;
        text << stream.rdbuf();
        return parse_markdown(text.str());
    }();
    return printed;
}

std::vector<Problem> problems_of(Duration duration) {
    auto all = all_problems();
    std::erase_if(all, [&](const Problem& problem) { return problem.duration != duration; });
    return all;
}

std::string test_name(const ::testing::TestParamInfo<Problem>& info) {
    std::string name;
    for (const char c : info.param.group + "_" + info.param.name)
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
            name += c;
        else if (!name.empty() && name.back() != '_')
            name += '_';
    return name;
}

class Verified : public ::testing::TestWithParam<Problem> {};

TEST_P(Verified, EveryRowIsWithinToleranceAndAgreesWithTheReadme) {
    const Problem& problem = GetParam();
    if (!can_run(problem)) GTEST_SKIP() << "set " << problem.needs << " to the required folder";
    const Outcome outcome = problem.solve();
    for (const Row& row : outcome.rows)
        EXPECT_TRUE(row.is_within_tolerance())
            << row.quantity << ": " << row.ours << " for " << row.reference << " (" << row.source << "), "
            << 100 * row.error() << " %, allowed " << 100 * row.tolerance << " %";
    const Report report = make_report(problem, outcome);
    const auto printed = readme().rows.find(problem.name);
    const auto expected = printed == readme().rows.end() ? decltype(report.rows){} : printed->second;
    for (const auto& difference : differences(row_header(), expected, report.rows)) ADD_FAILURE() << difference;
    for (const Table& table : outcome.tables) {
        const auto lines = readme().tables.find(table.title);
        ASSERT_NE(lines, readme().tables.end()) << "README.md has no table '" << table.title << "'; run make verify";
        for (const auto& difference : differences(table.header, lines->second, table.lines))
            ADD_FAILURE() << difference;
    }
}

INSTANTIATE_TEST_SUITE_P(Brief, Verified, ::testing::ValuesIn(problems_of(Duration::brief)), test_name);
INSTANTIATE_TEST_SUITE_P(Slow, Verified, ::testing::ValuesIn(problems_of(Duration::slow)), test_name);

// Without the overrides of the table, each file is a valid design for the programs.
class EveryDesign : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryDesign, IsValidAndCanBeMeshed) {
    EXPECT_GT(read_case("verification/" + GetParam() + ".yaml", {}).mesh.cell_count(), 0);
}

std::vector<std::string> kept_designs() {
    std::vector<std::string> names;
    for (const auto& file :
         std::filesystem::directory_iterator(std::string(SOFT_SOURCE_DIR) + "/designs/verification")) {
        const std::string name = file.path().stem().string();
        if (!name.starts_with("kraken-")) names.push_back(name);  // their meshes are not part of the project
    }
    std::sort(names.begin(), names.end());
    return names;
}

INSTANTIATE_TEST_SUITE_P(Designs, EveryDesign, ::testing::ValuesIn(kept_designs()), [](const auto& info) {
    std::string name = info.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(Readme, HasNoObsoleteCases) {
    std::set<std::string> names;
    for (const auto& problem : all_problems())
        EXPECT_TRUE(names.insert(problem.name).second) << problem.name << " twice";
    for (const auto& [name, rows] : readme().rows) EXPECT_TRUE(names.contains(name)) << name;
}

TEST(Readme, ComparisonAllowsOneUnitInTheFifthDigit) {
    const std::vector<std::string> header{"case", "ours", "error [%]"};
    const auto found = [&](const char* there, const char* here) {
        return !differences(header, {{"a", there, "1"}}, {{"a", here, "2"}}).empty();
    };
    EXPECT_FALSE(found("1.23456", "1.23463"));
    EXPECT_TRUE(found("1.23456", "1.23476"));
    EXPECT_TRUE(found("1.2", "none"));
}

TEST(Readme, KeepsTheTimesOfRowsThatDoNotChange) {
    const Problem problem{"Group", "a case", {}};
    Row row{.quantity = "p [kPa]", .reference = 1, .source = "closed form", .ours = 1, .mesh = "none", .seconds = 1};
    const Report old = make_report(problem, {{row}, {}});
    const auto printed = parse_markdown(markdown_text(std::vector{old}, ""));
    row.seconds = 2;
    const auto written = [&] {
        Report report = make_report(problem, {{row}, {}});
        keep_unchanged_lines(report, printed);
        return report.rows;
    };
    EXPECT_EQ(written(), old.rows);
    row.ours = 1.01;
    EXPECT_EQ(written().front().back(), "2.00");
}

TEST(Readme, CanBeParsedAndWrittenUnchanged) {
    const Problem problem{"Group", "a case", {}};
    Row row{.quantity = "p [kPa]", .reference = 1, .source = "closed form", .ours = 1.0005, .mesh = "none"};
    row.tolerance = 2e-3;
    row.reason = "why";
    const Table table{"a case and more", "text", {"x", "y"}, {{"1", "2"}}};
    const std::vector<Report> reports{make_report(problem, {{row}, {table}})};
    const auto text = markdown_text(reports, "## Notes\n");
    const auto kept = kept_report(problem, parse_markdown(text));
    EXPECT_EQ(markdown_text(std::vector<Report>{kept}, "## Notes\n"), text);
}

}  // namespace
}  // namespace soft::verification
