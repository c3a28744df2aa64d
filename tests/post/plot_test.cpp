#include "post/plot.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "core/error.hpp"
#include "path_samples.hpp"

namespace soft::post {
namespace {

const model::Case growth = test::sample_case({"growth"});

solution::PathEnd with_limit(const solution::LimitPoint& point) {
    solution::PathEnd end;
    end.limit_points = {point};
    return end;
}
const solution::PathEnd limit =
    with_limit({.step = 10, .pressure_Pa = 0.816424 * 55e3, .volume_m3 = test::ball_m3(1.8281), .outputs = {0.8281}});

/// The sphere with mu = 55 kPa: numbers of the size an actuator has.
Curve sphere_curve(int rows, double last_stretch) {
    auto steps = test::sphere_path(rows, last_stretch);
    for (auto& step : steps) step.pressure_Pa *= 55e3, step.tangent_pressure *= 55e3;
    return make_curve(growth, steps);
}

std::size_t count(const std::string& text, const std::string& word) {
    std::size_t n = 0;
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + word.size())) ++n;
    return n;
}

TEST(PlotScript, NamesTheAxesWithTheirUnits) {
    const std::string script = plot_script(sphere_curve(9, 3), {}, {"sphere"}, PictureFormat::svg);
    EXPECT_EQ(count(script, "set xlabel 'growth (mm)'"), 1u);
    EXPECT_EQ(count(script, "set ylabel 'cavity pressure (kPa)'"), 1u);
}

TEST(PlotScript, CallsThePressureOnAFaceNoCavityPressure) {
    auto steps = test::sphere_path(9, 3);
    for (auto& step : steps) step.volume_m3.reset();
    EXPECT_EQ(count(plot_script(make_curve(growth, steps), {}, {}, PictureFormat::svg), "set ylabel 'pressure (kPa)'"),
              1u);
}

TEST(PlotScript, DashesTheUnstablePartAndMarksTheLimitPoint) {
    const std::string script = plot_script(sphere_curve(25, 3), limit, {}, PictureFormat::svg);
    EXPECT_EQ(count(script, "$unstable with lines linewidth 2 dashtype"), 1u);
    EXPECT_EQ(count(script, "\"44.9 kPa\"\n"), 1u);
}

TEST(PlotScript, MarksABifurcationWithItsPressure) {
    solution::PathEnd end;
    end.bifurcations.resize(1);
    end.bifurcations[0].at = {.step = 3, .pressure_Pa = 26e3, .volume_m3 = 2.0, .outputs = {0.3}};
    const std::string script = plot_script(sphere_curve(25, 3), end, {}, PictureFormat::svg);
    EXPECT_EQ(count(script, "\n300 26 \"26 kPa\"\n"), 1u) << script;
    EXPECT_EQ(count(script, "title 'bifurcation'"), 1u);
}

TEST(PlotScript, CallsTheLoadByItsName) {
    model::Case model = test::sample_case({"growth"}, test::Loaded::nothing);
    auto steps = test::sphere_path(9, 3);
    for (auto& step : steps) step.volume_m3.reset();
    EXPECT_EQ(count(plot_script(make_curve(model, steps), {}, {}, PictureFormat::svg), "set ylabel 'load factor'"), 1u);
    model.tractions = {{"tip", {1e3, 0, 0}}};
    EXPECT_EQ(count(plot_script(make_curve(model, steps), {}, {}, PictureFormat::svg), "set ylabel 'traction (kPa)'"),
              1u);
}

TEST(PlotScript, HasAnAngleForItsAxis) {
    model::Case model = test::sample_case({"bend"});
    model.outputs[0].measure = model::Measure::bend;
    const std::string script = plot_script(make_curve(model, test::sphere_path(9, 3)), {}, {}, PictureFormat::svg);
    EXPECT_EQ(count(script, "set xlabel 'bend (deg)'"), 1u);
}

TEST(PlotScript, HasNeitherWhereThePathIsStable) {
    const std::string script = plot_script(sphere_curve(9, 1.5), {}, {}, PictureFormat::svg);
    EXPECT_EQ(count(script, "unstable"), 0u);
    EXPECT_EQ(count(script, "limit point"), 0u);
}

TEST(PlotScript, TakesTheVolumeWhereTheCaseHasNoOutput) {
    auto steps = test::sphere_path(9, 3);
    for (auto& step : steps) step.outputs.clear();
    const auto limits = with_limit({.step = 3, .pressure_Pa = 1000, .volume_m3 = 2e-6, .outputs = {}});
    const std::string script = plot_script(make_curve(test::sample_case(), steps), limits, {}, PictureFormat::svg);
    EXPECT_EQ(count(script, "set xlabel 'cavity volume (mL)'"), 1u);
    EXPECT_EQ(count(script, "\n2 1 \"1 kPa\"\n"), 1u);
}

TEST(PlotScript, ATitleCannotLeaveItsQuotes) {
    const std::string script = plot_script(sphere_curve(9, 3), {}, {"it's\nsystem('x')"}, PictureFormat::svg);
    EXPECT_EQ(count(script, "set title 'it''s system(''x'')' noenhanced\n"), 1u);
}

TEST(PictureFormat, IsToldByTheEndingOfTheName) {
    EXPECT_EQ(picture_format("out/a.svg"), PictureFormat::svg);
    EXPECT_EQ(picture_format("a.b.png"), PictureFormat::png);
    EXPECT_THROW((void)picture_format("a.jpg"), Error);
    EXPECT_THROW((void)picture_format("svg"), Error);
}

TEST(DrawPlot, WritesAnSvgThatHoldsTheLabelsAndNothingBesideIt) {
    const auto folder = std::filesystem::path(::testing::TempDir()) / "soft_draw_plot";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    const auto file = folder / "it's a curve.svg";
    draw_plot(sphere_curve(25, 3), limit, {"thick sphere"}, file);
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    EXPECT_TRUE(text.str().starts_with("<?xml"));
    EXPECT_EQ(count(text.str(), "cavity pressure (kPa)"), 1u);
    EXPECT_EQ(count(text.str(), "thick sphere"), 1u);
    EXPECT_GE(count(text.str(), "stroke-dasharray"), 1u);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace soft::post
