#include "post/plot.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "core/error.hpp"
#include "core/text.hpp"
#include "path_samples.hpp"

namespace soft::post {
namespace {

model::PathEnd with_limit(const model::LimitPoint& point) {
    model::PathEnd end;
    end.limit_points = {point};
    return end;
}
const model::PathEnd limit =
    with_limit({.step = 10, .pressure_Pa = 0.816424 * 55e3, .volume_m3 = test::ball_m3(1.8281), .outputs = {0.8281}});

/// The sphere with mu = 55 kPa: pressures typical of an actuator.
Curve sphere_curve(int rows, double last_stretch) {
    auto steps = test::sphere_path(rows, last_stretch);
    for (auto& step : steps) step.pressure_Pa *= 55e3, step.tangent_pressure *= 55e3;
    return make_curve(test::growth, steps);
}

std::string script_of(const Curve& curve, const model::PathEnd& end = {}, const PlotRequest& request = {},
                      PictureFormat format = PictureFormat::svg) {
    const std::vector<PlotSeries> series = {{"", curve, end}};
    return plot_script(series, nullptr, request, format);
}

std::size_t count(const std::string& text, const std::string& word) {
    std::size_t n = 0;
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + word.size())) ++n;
    return n;
}

TEST(Plot, EscapesTitlesAndLabelsInTheScript) {
    const std::string wild = "it's\nset output 'x'\033[31m\xff";
    const std::vector<PlotSeries> series = {{wild, sphere_curve(12, 2.5), {}}, {wild + "2", sphere_curve(12, 2.5), {}}};
    const std::string script = plot_script(series, nullptr, {.title = wild}, PictureFormat::svg);
    EXPECT_EQ(count(script, "'it''s?set output ''x''?[31m?'"), 2u) << script;  // the title, a label
    EXPECT_EQ(script.find('\033'), std::string::npos);
    EXPECT_EQ(script.find('\xff'), std::string::npos);
}

TEST(PlotScript, NamesTheAxesWithTheirUnits) {
    const std::string script = script_of(sphere_curve(9, 3), {}, {.title = "sphere"});
    EXPECT_EQ(count(script, "set xlabel 'growth (mm)'"), 1u);
    EXPECT_EQ(count(script, "set ylabel 'cavity pressure (kPa)'"), 1u);
}

TEST(PlotScript, DoesNotCallAPressureOnAFaceCavityPressure) {
    auto steps = test::sphere_path(9, 3);
    for (auto& step : steps) step.volume_m3.reset();
    EXPECT_EQ(count(script_of(make_curve(test::growth, steps), {}), "set ylabel 'pressure (kPa)'"), 1u);
}

TEST(PlotScript, DashesTheUnstablePartAndMarksTheLimitPoint) {
    const std::string script = script_of(sphere_curve(25, 3), limit);
    EXPECT_EQ(count(script, "$unstable1 with lines linewidth 2 linecolor rgb '#0072B2' dashtype"), 1u);
    EXPECT_EQ(count(script, "set label '44.9 kPa' at "), 1u);
    EXPECT_EQ(count(script, "set yrange [0:*]"), 1u);
    EXPECT_EQ(count(script, "\"44.9 kPa\"\n"), 1u);
}

TEST(PlotScript, TheDashesBeginAtTheRowOfTheLimitPoint) {
    const Curve curve = sphere_curve(25, 3);
    const auto first_dash = [&](const model::PathEnd& end) {
        const std::string script = script_of(curve, end), block = "$unstable1 << END\n";
        return std::stod(script.substr(script.find(block) + block.size()));
    };
    const std::vector<double>& growth_mm = curve.find("growth")->values;
    EXPECT_NEAR(first_dash(limit), growth_mm[10], 1e-9);
    EXPECT_NEAR(first_dash(with_limit({.step = 9, .pressure_Pa = 0, .volume_m3 = {}, .outputs = {0}})), growth_mm[9],
                1e-9);                        // the last stable row
    EXPECT_GT(first_dash({}), growth_mm[9]);  // no located row: between the two rows
    EXPECT_LT(first_dash({}), growth_mm[10]);
}

TEST(PlotScript, MarksABifurcationWithItsPressure) {
    model::PathEnd end;
    end.bifurcations.resize(1);
    end.bifurcations[0].at = {.step = 3, .pressure_Pa = 26e3, .volume_m3 = 2.0, .outputs = {0.3}};
    const std::string script = script_of(sphere_curve(25, 3), end);
    EXPECT_EQ(count(script, "\n300 26 \"26 kPa\"\n"), 1u) << script;
    EXPECT_EQ(count(script, "title 'bifurcation'"), 1u);
}

TEST(PlotScript, LabelsTheAxisWithTheLeadingLoad) {
    model::Case model = test::sample_case({"growth"}, test::Loaded::nothing);
    auto steps = test::sphere_path(9, 3);
    for (auto& step : steps) step.volume_m3.reset();
    EXPECT_EQ(count(script_of(make_curve(model, steps), {}), "set ylabel 'load factor'"), 1u);
    model.dead_loads = {{"tip", model::DeadLoadKind::traction, {1e3, 0, 0}}};
    EXPECT_EQ(count(script_of(make_curve(model, steps), {}), "set ylabel 'traction (kPa)'"), 1u);
}

TEST(PlotScript, LabelsAnAngleInDegrees) {
    model::Case model = test::sample_case({"bend"});
    model.outputs[0].measure = model::Measure::bend;
    const std::string script = script_of(make_curve(model, test::sphere_path(9, 3)), {});
    EXPECT_EQ(count(script, "set xlabel 'bend (deg)'"), 1u);
}

TEST(PlotScript, HasNoDashesAndNoLimitPointsIfThePathIsStable) {
    const std::string script = script_of(sphere_curve(9, 1.5), {});
    EXPECT_EQ(count(script, "unstable"), 0u);
    EXPECT_EQ(count(script, "limit point"), 0u);
}

TEST(PlotScript, UsesTheVolumeIfTheCaseHasNoOutput) {
    auto steps = test::sphere_path(9, 3);
    for (auto& step : steps) step.outputs.clear();
    const auto limits = with_limit({.step = 3, .pressure_Pa = 1000, .volume_m3 = 2e-6, .outputs = {}});
    const std::string script = script_of(make_curve(test::sample_case(), steps), limits);
    EXPECT_EQ(count(script, "set xlabel 'cavity volume (mL)'"), 1u);
    EXPECT_EQ(count(script, "\n2 1 \"1 kPa\"\n"), 1u);
}

TEST(PlotScript, EscapesQuotesInTheTitle) {
    const std::string script = script_of(sphere_curve(9, 3), {}, {.title = "it's\nsystem('x')"});
    EXPECT_EQ(count(script, "set title 'it''s?system(''x'')' noenhanced\n"), 1u);
}

TEST(PlotScript, PlotsAnyColumnOverAnyOther) {
    const Curve curve = sphere_curve(9, 3);
    const std::string script = script_of(curve, {}, {.title = "", .x = "volume", .y = "max_stretch"});
    EXPECT_EQ(count(script, "set xlabel 'cavity volume (mL)'"), 1u);
    EXPECT_EQ(count(script, "set ylabel 'max stretch'"), 1u);
    EXPECT_EQ(plot_axes(curve, {.title = "", .x = "growth_mm", .y = ""}).x, plot_axes(curve, {}).x);
    EXPECT_THROW((void)plot_axes(curve, {.title = "", .x = "grwth", .y = ""}), Error);
}

TEST(PlotScript, ColoursThePathByAThirdQuantity) {
    const Curve curve = sphere_curve(25, 3);
    const std::string script = script_of(curve, limit, {.title = "", .x = "", .y = "", .colour = "volume"});
    EXPECT_EQ(count(script, "set cblabel 'cavity volume (mL)'"), 1u);
    EXPECT_EQ(count(script, "$stable1 using 1:2:3 with lines linewidth 5 linecolor palette"), 1u);
    EXPECT_EQ(count(script, "\n0 0 " + core::number_text(curve.find("volume")->values.front()) + "\n"), 1u);
    EXPECT_THROW((void)plot_axes(curve, {.title = "", .x = "", .y = "", .colour = "colour"}), Error);
}

TEST(PlotScript, DistinguishesSeveralPathsByMarkersAndLabels) {
    const std::vector<PlotSeries> series = {{"2 mm", sphere_curve(25, 3), {}}, {"it's 3 mm", sphere_curve(9, 2), {}}};
    const std::string script = plot_script(series, nullptr, {}, PictureFormat::png);
    EXPECT_EQ(count(script, "keyentry with linespoints pointtype 6 "), 1u);
    EXPECT_EQ(count(script, "keyentry with linespoints pointtype 12 "), 1u);
    EXPECT_EQ(count(script, "title 'it''s 3 mm'"), 1u);
}

TEST(PlotScript, RejectsAPathWithoutTheAxesOfTheFirst) {
    const Curve other = make_curve(test::sample_case({"bend"}), test::sphere_path(9, 3));
    const std::vector<PlotSeries> series = {{"a", sphere_curve(9, 3), {}}, {"b.h5", other, {}}};
    EXPECT_THROW((void)plot_script(series, nullptr, {}, PictureFormat::svg), Error);
}

TEST(PlotScript, DrawsMeasuredPointsAsCrosses) {
    const Measured measured{"m.csv", {2, 3}, {{1, {10, 20}, "column 1"}, {2, {100, 300}, "column 2"}}};
    const std::vector<PlotSeries> series = {{"", sphere_curve(9, 3), {}}};
    EXPECT_EQ(count(plot_script(series, &measured, {}, PictureFormat::svg), "\n100 10\n300 20\nEND\n"), 1u);
}

TEST(PlotScript, ChoosesAxesThatWereMeasured) {
    const std::vector<PlotSeries> series = {{"", sphere_curve(9, 3), {}}};
    const std::size_t volume =
        static_cast<std::size_t>(series[0].curve.find("volume") - series[0].curve.columns.data());
    const Measured measured{"m.csv", {2, 3}, {{1, {10, 20}, "column 1"}, {volume, {100, 300}, "column 2"}}};
    const std::string script = plot_script(series, &measured, {}, PictureFormat::svg);
    EXPECT_EQ(count(script, "\n100 10\n300 20\nEND\n"), 1u);
    EXPECT_EQ(count(script, "set xlabel 'cavity volume"), 1u);
    EXPECT_THROW((void)plot_script(series, &measured, {.title = "", .x = "growth", .y = ""}, PictureFormat::svg),
                 Error);
}

TEST(PlotScript, ShowsTheErrorOfTheMeshAsBandAndBars) {
    auto steps = test::sphere_path(3, 2);
    for (auto& step : steps) step.pressure_error_Pa = 0.1 * step.pressure_Pa, step.output_errors = {0.05};
    const std::string script = script_of(make_curve(test::growth, steps));
    EXPECT_EQ(count(script, "with filledcurves closed"), 2u);  // the band and its legend entry
    // at the stretch 1.5: 0.755433 Pa +- a tenth, 500 mm +- 50
    EXPECT_EQ(count(script, "\n500 0.000755433"), 4u);  // two strokes of the path, marker and bar
    EXPECT_EQ(count(script, " 450 550 0.00067988"), 1u) << script;
    EXPECT_EQ(count(script_of(sphere_curve(9, 3)), "mesh error"), 0u);
}

TEST(PictureFormat, IsDeterminedByTheFileExtension) {
    EXPECT_EQ(picture_format("out/a.svg"), PictureFormat::svg);
    EXPECT_EQ(picture_format("a.b.png"), PictureFormat::png);
    EXPECT_EQ(picture_format("a.pdf"), PictureFormat::pdf);
    EXPECT_THROW((void)picture_format("a.jpg"), Error);
    EXPECT_THROW((void)picture_format("svg"), Error);
}

TEST(DrawPlot, WritesAnSvgWithTheLabelsAndNoOtherFile) {
    const auto folder = std::filesystem::path(::testing::TempDir()) / "soft_draw_plot";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    const auto file = folder / "it's a curve.svg";
    const std::vector<PlotSeries> series = {{"", sphere_curve(25, 3), limit}};
    draw_plot(series, nullptr, {.title = "thick sphere"}, file);
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
