#include "view/sweep_report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "view/text.hpp"

namespace soft::view {
namespace {

const std::string evil = "</script><script>alert(1)</script>' onerror=\"alert(2)\"";

/// Two solved designs and a refused one.
struct Sample {
    std::vector<std::string> ids{"aa", "bb", "cc"};
    std::vector<sweep::TableColumn> factors{{"geometry_wall_mm", "geometry.wall", "mm", {"2", "3", "4"}},
                                            {"name", "name", "", {"x", evil, "x"}}},
        outputs{{"p_kPa_at_end", "p at end", "kPa", {"0.1234567890123", "2", ""}}};
    std::vector<sweep::Outcome> outcomes{
        {.exit_code = 0,
         .stop_reason = "done",
         .trace = {{"p_kPa", "p", "kPa", {0, 0.123456789}}, {"u_mm", "u", "mm", {0, 5}}}},
        {.exit_code = 2,
         .stop_reason = "limit_point",
         .error = evil,
         .trace = {{"p_kPa", "p", "kPa", {0, 2}}, {"u_mm", "u", "mm", {0, 6}}, {"v_mL", "v", "mL", {1, 2}}}},
        {.exit_code = 65, .stop_reason = "refused", .error = "too thick"}};

    [[nodiscard]] std::string page() const {
        return make_sweep_report({.title = "Sweep " + evil,
                                  .ids = ids,
                                  .factors = factors,
                                  .outputs = outputs,
                                  .outcomes = outcomes,
                                  .sweep_text = evil,
                                  .made_by = evil});
    }
    [[nodiscard]] nlohmann::json data() const {
        const std::string text = page(), begin = "id='data'>";
        const auto from = text.find(begin) + begin.size();
        return nlohmann::json::parse(text.substr(from, text.find("</script>", from) - from));
    }
};

std::size_t occurrences(const std::string& text, const std::string& word) {
    std::size_t n = 0;
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + word.size())) ++n;
    return n;
}

TEST(SweepReport, TextOfTheSweepIsNeverExecuted) {
    const std::string page = Sample{}.page();
    EXPECT_EQ(occurrences(page, "<script"), 2u);  // the data and the script
    EXPECT_EQ(occurrences(page, "</script"), 2u);
    EXPECT_EQ(occurrences(page, "=\"alert(2)"), 0u);
    const auto begin = page.rfind("<script>") + 8, end = page.rfind("</script>");
    EXPECT_EQ(occurrences(page, "script-src '" + policy_hash(page.substr(begin, end - begin)) + "'"), 1u);
    EXPECT_EQ(occurrences(page, "default-src 'none'"), 1u);
    EXPECT_EQ(page, Sample{}.page());
}

TEST(SweepReport, ContainsTheColumnsOfTheResults) {
    const nlohmann::json columns = Sample{}.data()["columns"];
    ASSERT_EQ(columns.size(), 3u);
    EXPECT_EQ(columns[0]["values"], (nlohmann::json{2, 3, 4}));
    EXPECT_EQ(columns[0]["unit"], "mm");
    EXPECT_TRUE(columns[0]["parameter"]);
    EXPECT_EQ(columns[1]["words"], (nlohmann::json{"x", evil}));
    EXPECT_EQ(columns[1]["values"], (nlohmann::json{0, 1, 0}));
    EXPECT_EQ(columns[2]["values"], (nlohmann::json{0.1234567890123, 2, nullptr}));
    EXPECT_FALSE(columns[2]["parameter"]);
}

TEST(SweepReport, ContainsTheCurvesWithFewDigitsAndTheReasonsOfFailures) {
    const nlohmann::json data = Sample{}.data();
    EXPECT_EQ(data["trace_columns"].size(), 3u);
    EXPECT_EQ(data["curve_axes"], (nlohmann::json{1, 0}));
    EXPECT_EQ(data["traces"][0], (nlohmann::json{{0, 0.12346}, {0, 5}, nullptr}));
    EXPECT_EQ(data["traces"][1][2], (nlohmann::json{1, 2}));
    EXPECT_TRUE(data["traces"][2].is_null());
    EXPECT_EQ(data["designs"][2],
              (nlohmann::json{{"id", "cc"}, {"stop", "refused"}, {"code", 65}, {"error", "too thick"}}));
    EXPECT_EQ(data["designs"][1]["error"], evil);
}

TEST(SweepReport, WithoutAnyCurveIsAPageToo) {
    Sample sample;
    for (sweep::Outcome& outcome : sample.outcomes) outcome.trace.clear();
    EXPECT_TRUE(sample.data()["trace_columns"].empty());
}

TEST(TracePoints, KeepTheCurvesOfALargeSweepSmall) {
    EXPECT_EQ(trace_points(30), 40u);
    EXPECT_EQ(trace_points(10000), 40u);
    EXPECT_EQ(trace_points(20000), 20u);
    EXPECT_EQ(trace_points(100000), 8u);
}

}  // namespace
}  // namespace soft::view
