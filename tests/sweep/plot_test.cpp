#include "sweep/plot.hpp"

#include <gtest/gtest.h>

namespace {

using namespace soft;
using namespace soft::sweep;

struct Tubes {
    std::vector<TableColumn> factors{{"geometry_wall_mm", "geometry.wall", "mm", {}}, {"law", "law", "", {}}};
    std::vector<TableColumn> outputs{{"pressure_kPa_at_end", "pressure at end", "kPa", {}}};
    std::vector<Outcome> outcomes;

    explicit Tubes(int count) {
        for (int i = 0; i < count; ++i) {
            factors[0].cells.push_back(std::to_string(i + 2));
            factors[1].cells.push_back(i % 2 == 0 ? "yeoh" : "it's");
            outputs[0].cells.push_back(std::to_string(10 * i));
            outcomes.push_back({.exit_code = 0,
                                .trace = {{"pressure_kPa", "pressure", "kPa", {0, 10.0 * i}},
                                          {"elongation_mm", "elongation", "mm", {0, 5.0 + i}},
                                          {"volume_mL", "volume", "mL", {1, 2}}}});
        }
    }
    [[nodiscard]] std::string script(const post::PlotRequest& request) const {
        return plot_script(factors, outputs, outcomes, request, post::PictureFormat::svg);
    }
};

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(SweepPlot, DrawsTheCurvesColouredByTheFirstParameter) {
    const std::string script = Tubes(10).script({.title = "tubes"});
    EXPECT_TRUE(contains(script, "set xlabel 'elongation (mm)'"));
    EXPECT_TRUE(contains(script, "set ylabel 'pressure (kPa)'"));
    EXPECT_TRUE(contains(script, "set cblabel 'geometry.wall (mm)'"));
    EXPECT_TRUE(contains(script, "\n0 0 5\n8 30 5\n\n")) << script;  // x, y, colour of the design with a wall of 5 mm
    EXPECT_TRUE(contains(script, "linecolor palette"));
    EXPECT_FALSE(contains(script, "ended early"));
}

TEST(SweepPlot, HasALegendForWordsAndFewValues) {
    const std::string few = Tubes(3).script({});
    EXPECT_TRUE(contains(few, "title 'geometry.wall 2 mm'"));
    EXPECT_FALSE(contains(few, "palette"));
    const std::string words = Tubes(10).script({.colour = "law"});
    EXPECT_TRUE(contains(words, "title 'law yeoh'"));
    EXPECT_TRUE(contains(words, "title 'law it''s'"));
}

TEST(SweepPlot, DrawsOneColumnOfTheResultsOverAnother) {
    for (const char* x : {"geometry.wall", "geometry_wall_mm"}) {
        const std::string script = Tubes(10).script({.x = x, .y = "pressure_kPa_at_end"});
        EXPECT_TRUE(contains(script, "set ylabel 'pressure at end (kPa)'"));
        EXPECT_TRUE(contains(script, "\n4 20 4\n5 30 5\n"));
        EXPECT_TRUE(contains(script, "with points"));
    }
}

TEST(SweepPlot, MarksTheEndOfAPathThatEndedEarlyAndOmitsFailures) {
    Tubes tubes(3);
    tubes.outcomes[1].exit_code = 2;
    tubes.outcomes[0] = {.exit_code = 65};
    const std::string script = tubes.script({});
    EXPECT_TRUE(contains(script, "$ends << EOD\n6 10\nEOD\n")) << script;
    EXPECT_TRUE(contains(script, "title 'ended early'"));
    EXPECT_FALSE(contains(script, "title 'geometry.wall 2 mm'"));
}

std::string plot_refusal(const post::PlotRequest& request, ExitCode code) {
    try {
        static_cast<void>(Tubes(3).script(request));
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), code);
        return error.what();
    }
    ADD_FAILURE() << "accepted";
    return "";
}

TEST(SweepPlot, RejectsUnknownAndMixedColumns) {
    EXPECT_EQ(plot_refusal({.x = "elongatoin"}, ExitCode::usage),
              "--x: neither the curves nor the results have a column 'elongatoin'; did you mean 'elongation'?");
    EXPECT_EQ(plot_refusal({.x = "geometry.wall", .y = "pressure"}, ExitCode::usage).substr(0, 9), "--y: is a");
    EXPECT_EQ(plot_refusal({.colour = "volume"}, ExitCode::usage).substr(0, 10), "--colour: ");
}

TEST(SweepPlot, RejectsASweepWithoutCurves) {
    Tubes tubes(2);
    for (Outcome& outcome : tubes.outcomes) outcome = {.exit_code = 65};
    EXPECT_THROW(static_cast<void>(tubes.script({})), Error);
}

}  // namespace
