#include "post/sensitivity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "path_samples.hpp"
#include "post/plot.hpp"

namespace soft::post {
namespace {

/// p = 2 w u with the displacement u [m] and a wall w = 3 mm; at a fixed position along the path u' = 0.5 m/m. kPa, mm.
struct Spring {
    model::Case model = test::sample_case({"elongation"});
    std::vector<model::Step> steps;

    Spring() {
        model.parameters = {{"geometry.wall", "mm", 1e-3, 3e-3, 0, 0}};
        constexpr double w = 3e-3, factor = 2e9;
        for (const double u : {0.01, 0.02, 0.04}) {
            model::Step step;
            step.pressure_Pa = factor * w * u;
            step.tangent_pressure = 7 * factor * w;
            step.outputs = {u};
            step.tangent_outputs = {7};
            step.derivatives = {factor * u + factor * w * 0.5, 0.5};
            steps.push_back(step);
        }
    }

    /// A modulus of 1 MPa: the load changes by `percent` per 1 %.
    void add_modulus(double percent) {
        model.parameters.push_back({"material.mu", "MPa", 1e6, 1e6, 0, 0});
        for (model::Step& step : steps) {
            step.derivatives.push_back(percent * step.pressure_Pa / 1e6);
            step.derivatives.push_back(0);
        }
    }
};

TEST(Sensitivity, TableHasTheDerivativesAtAFixedOutputAndAtAFixedLoad) {
    const Spring spring;
    const Curve curve = make_curve(spring.model, spring.steps);
    const std::string text = sensitivity_csv(curve, spring.model, std::array{2});
    const std::size_t first = text.find('\n') + 1, second = text.find('\n', first) + 1;
    EXPECT_EQ(text.substr(0, first - 1),
              "step,pressure_kPa,elongation_mm,parameter,value,unit,d_load,d_output,d_load_percent,d_output_percent");
    // d_load = 2e9 u per m = 20 kPa/mm at 10 mm; d_output = -u/w; both in percent: 1 and -1
    double d_load = 0, d_output = 0, load_percent = 0, output_percent = 0;
    ASSERT_EQ(std::sscanf(text.c_str() + first, "0,60,10,geometry.wall,3,mm,%lf,%lf,%lf,%lf", &d_load, &d_output,
                          &load_percent, &output_percent),
              4);
    EXPECT_NEAR(d_load, 20, 1e-9);
    EXPECT_NEAR(d_output, -10.0 / 3, 1e-9);
    EXPECT_NEAR(load_percent, 1, 1e-9);
    EXPECT_NEAR(output_percent, -1, 1e-9);
    const std::string third = text.substr(text.find('\n', second) + 1);
    EXPECT_NE(third.find(",,"), std::string::npos);  // a limit row has no d_output
    EXPECT_TRUE(third.ends_with(",\n"));
}

TEST(Sensitivity, BandOfTolerancesAddsSquaresOrSizes) {
    Spring spring;
    spring.add_modulus(1);
    Curve curve = make_curve(spring.model, spring.steps);
    const std::vector<std::string> texts{"geometry.wall=0.1mm", "material.mu=4%"};
    EXPECT_EQ(add_tolerance_band(curve, spring.model, parse_tolerances(texts, spring.model)), "material.mu");
    // last row: 240 kPa; wall 80 kPa/mm x 0.1 mm = 8 kPa; mu 9.6 kPa
    EXPECT_NEAR(curve.find("band_worst_pressure")->values.back(), 17.6, 1e-9);
    EXPECT_NEAR(curve.find("band_rss_pressure")->values.back(), std::hypot(8, 9.6), 1e-9);
    // the output at a fixed load: over the stiffness of 6 kPa/mm
    EXPECT_NEAR(curve.find("band_rss_elongation")->values.back(), std::hypot(8, 9.6) / 6, 1e-9);
}

TEST(Sensitivity, BandOfCorrelatedDeviationsHasTheirCovariance) {
    Spring spring;
    spring.add_modulus(1);
    // 8 kPa by the wall and 9.6 kPa by mu, with a correlation of -0.5; and 0.2 mm of another wall
    const double wall = 1e-4, mu = 4e4;
    Deviations deviations{{0, 1}, {wall * wall, -0.5 * wall * mu, -0.5 * wall * mu, mu * mu}};
    deviations.add({{0}, {4 * wall * wall}});
    Curve curve = make_curve(spring.model, spring.steps);
    static_cast<void>(add_tolerance_band(curve, spring.model, deviations));
    EXPECT_NEAR(curve.find("band_rss_pressure")->values.back(), std::sqrt(64 + 9.6 * 9.6 - 8 * 9.6 + 256), 1e-9);
    EXPECT_NEAR(curve.find("band_worst_pressure")->values.back(), 8 + 9.6 + 16, 1e-9);
}

TEST(Sensitivity, BandIsDrawnOverTheFirstOutputOnly) {
    const Spring spring;
    PlotSeries series{"", make_curve(spring.model, spring.steps), {}};
    const std::vector<std::string> texts{"geometry.wall=0.1mm"};
    static_cast<void>(add_tolerance_band(series.curve, spring.model, parse_tolerances(texts, spring.model)));
    const auto block = [&](const PlotRequest& request) {
        const std::string script = plot_script({&series, 1}, nullptr, request, PictureFormat::svg);
        const std::size_t at = script.find("$tolerances1 << END\n");
        return at == std::string::npos ? "" : script.substr(at, script.find("\nEND\n", at) - at);
    };
    double x = 0, y = 0;
    ASSERT_EQ(std::sscanf(block({}).c_str(), "$tolerances1 << END\n%lf %lf", &x, &y), 2);
    EXPECT_NEAR(x, 10, 1e-9);
    EXPECT_NEAR(y, 60 + 2, 1e-9);
    EXPECT_NE(block({.x = "pressure", .y = "elongation"}), "");
    EXPECT_EQ(block({.x = "elongation", .y = "stretch_p99"}), "");
}

TEST(Sensitivity, BarsAreSortedUpwardsByTheirSize) {
    Spring spring;
    spring.add_modulus(-2);
    const std::string script =
        sensitivity_script(make_curve(spring.model, spring.steps), spring.model, PictureFormat::svg);
    EXPECT_NE(script.find("set ytics ('geometry.wall' 0, 'material.mu' 1)"), std::string::npos);
    EXPECT_NE(script.find("\n-2 1\n"), std::string::npos);
}

TEST(Sensitivity, TolerancesAreOfNumbersThatHaveOne) {
    const Spring spring;
    for (const char* text : {"geometry.wal=0.1mm", "geometry.wall", "geometry.wall=0.1kPa", "geometry.wall=-1mm"})
        EXPECT_THROW(static_cast<void>(parse_tolerances(std::vector<std::string>{text}, spring.model)), Error) << text;
}

}  // namespace
}  // namespace soft::post
