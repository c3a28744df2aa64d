#include "post/band.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/error.hpp"
#include "path_samples.hpp"
#include "post/plot.hpp"

namespace soft::post {
namespace {

const Curve& sphere() {
    static const Curve curve = make_curve(test::sample_case({"growth"}), test::sphere_path(9, 3));
    return curve;
}

Band read(const std::string& text) { return read_band(core::read_table(text, "band.csv"), sphere()); }

std::string refusal(const std::string& text) {
    try {
        static_cast<void>(read(text));
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        return error.what();
    }
    return "";
}

/// The sphere with the modulus `mu` Pa: all pressures are proportional to it.
Curve sphere_of(double mu) {
    auto steps = test::sphere_path(41, 3);
    for (model::Step& step : steps) step.pressure_Pa *= mu, step.tangent_pressure *= mu;
    return make_curve(test::sample_case({"growth"}), steps);
}

double linear(const BandSum& sum, const char* quantity, std::size_t row = 0) {
    const Band band = sum.band();
    const Column* column = sum.rows().find(quantity);
    return band.find(static_cast<std::size_t>(column - sum.rows().columns.data()))->linear[row];
}

TEST(BandSum, LoadVariesWithTheModulusAtAPrescribedOutput) {
    const Curve fitted = sphere_of(1), plus = sphere_of(1.02), minus = sphere_of(0.98);
    BandSum sum(fitted, parse_requests("growth=250mm,500mm", fitted));
    sum.add_pair(&plus, &minus);
    // proportional: the relative deviation of the pressure is that of the modulus, of the volume zero
    EXPECT_NEAR(linear(sum, "pressure", 0), 0.02e-3 * test::sphere_pressure_Pa(1.25), 1e-9 * 1e-3);
    EXPECT_NEAR(linear(sum, "pressure", 1), 0.02e-3 * test::sphere_pressure_Pa(1.5), 1e-9 * 1e-3);
    EXPECT_NEAR(linear(sum, "volume"), 0, 1e-6);
    EXPECT_TRUE(std::isnan(linear(sum, "growth")));  // it is prescribed
    EXPECT_TRUE(sum.notes().empty());
}

TEST(BandSum, OutputsVaryAtAPrescribedLoad) {
    const Curve fitted = sphere_of(1), plus = sphere_of(1.001), minus = sphere_of(0.999);
    BandSum sum(fitted, parse_requests("pressure=0.5Pa", fitted));
    sum.add_pair(&plus, &minus);
    const double stretch = 1 + sum.rows().find("growth")->values[0] / 1e3;
    // p = mu f(l): at a fixed p, dl = -(f / f') dmu / mu
    const double slope = test::sphere_pressure_slope_Pa(stretch);
    EXPECT_NEAR(linear(sum, "growth"), 1e3 * 0.001 * 0.5 / slope, 1e-3 * 1e3 * 0.001 * 0.5 / slope);
    EXPECT_TRUE(std::isnan(linear(sum, "pressure")));
}

TEST(BandSum, AddsVariancesOfPairsAndComputesTheDeviationOfSamples) {
    const Curve fitted = sphere_of(1), a = sphere_of(1.03), b = sphere_of(0.97), c = sphere_of(1.04),
                d = sphere_of(0.96);
    BandSum sum(fitted, parse_requests("growth=500mm", fitted));
    sum.add_pair(&a, &b);
    sum.add_pair(&c, &d);
    for (const Curve* sample : {&a, &b, &c, &d}) sum.add_sample(sample);
    const double pressure_kPa = test::sphere_pressure_Pa(1.5) / 1e3;
    EXPECT_NEAR(linear(sum, "pressure"), 0.05 * pressure_kPa, 1e-6 * pressure_kPa);
    EXPECT_NEAR(sum.band().widths[0].sampled[0], std::sqrt(0.005 / 3) * pressure_kPa, 1e-6 * pressure_kPa);
    EXPECT_EQ(sum.band().samples, (std::vector<int>{4}));
}

TEST(BandSum, CountsSamplesThatDoNotReachTheValue) {
    // the largest pressure is 0.8164 Pa times the modulus
    const Curve fitted = sphere_of(1), plus = sphere_of(1.1), minus = sphere_of(0.9), third = sphere_of(1.2);
    BandSum sum(fitted, parse_requests("pressure=0.4Pa,0.8Pa", fitted));
    sum.add_pair(&plus, &minus);
    sum.add_sample(&plus);
    sum.add_sample(&minus);
    sum.add_sample(&third);
    sum.add_sample(nullptr);  // not computed
    const Band band = sum.band();
    const std::size_t rows = sum.rows().row_count();
    ASSERT_EQ(rows, 3u);  // 0.8 Pa is crossed before and after the limit point
    EXPECT_EQ(band.samples, (std::vector<int>{3, 2, 2}));
    EXPECT_FALSE(std::isnan(linear(sum, "growth", 0)));
    EXPECT_TRUE(std::isnan(linear(sum, "growth", 1)));
    const std::vector<std::string> notes = sum.notes();
    ASSERT_EQ(notes.size(), 5u);
    EXPECT_EQ(notes[0], "pressure=0.0004kPa: 1 of 4 samples does not reach it and is left out");
    EXPECT_EQ(notes[2], "pressure=0.0008kPa: 2 of 4 samples do not reach it and are left out");
    const std::string text = band_csv(sum.rows(), band);
    EXPECT_EQ(
        text.substr(0, text.find('\n')),
        "step,pressure_kPa,growth_mm,volume_mL,stretch_p99,max_stretch,min_J,stable,pressure_band_kPa,growth_band_mm,"
        "volume_band_mL,pressure_sampled_band_kPa,growth_sampled_band_mm,volume_sampled_band_mL,samples");
    const Band read = read_band(core::read_table(text, "band.csv"), fitted);
    for (std::size_t w = 0; w < band.widths.size(); ++w)
        for (std::size_t row = 0; row < rows; ++row) {
            EXPECT_EQ(std::isnan(read.widths[w].linear[row]), std::isnan(band.widths[w].linear[row]));
            if (!std::isnan(read.widths[w].sampled[row])) {
                EXPECT_EQ(read.widths[w].sampled[row], band.widths[w].sampled[row]);
            }
        }
    EXPECT_EQ(read.samples, band.samples);
}

TEST(BandSum, WarnsWhereNothingVaries) {
    const Curve fitted = sphere_of(1);
    BandSum sum(fitted, parse_requests("growth=500mm", fitted));
    sum.add_pair(&fitted, &fitted);
    ASSERT_EQ(sum.notes().size(), 1u);
    EXPECT_NE(sum.notes()[0].find("no quantity of the curve depends on the constants"), std::string::npos);
    EXPECT_THROW(BandSum(fitted, parse_requests("pressure=5Pa", fitted)), Error);
}

TEST(Band, PrefersTheSampledWidth) {
    const Band linear = read("step,pressure_kPa,growth_mm,pressure_band_kPa\n1,10,100,0.5\n2,20,300,1\n");
    EXPECT_EQ(linear.widths[0].values, (std::vector<double>{10, 20}));
    EXPECT_EQ(linear.widths[0].half(1), 1);
    EXPECT_TRUE(std::isnan(linear.widths[1].half(0)));
    EXPECT_EQ(
        read("pressure_kPa,growth_mm,pressure_band_kPa,pressure_sampled_band_kPa\n10,100,0.5,0.6\n").widths[0].half(0),
        0.6);
}

TEST(Band, IsDrawnAlongTheAxisThatIsNotPrescribed) {
    const Curve fitted = sphere_of(1), plus = sphere_of(1.02), minus = sphere_of(0.98);
    BandSum sum(fitted, parse_requests("growth=500mm,250mm", fitted));
    sum.add_pair(&plus, &minus);
    PlotSeries series{"", fitted, {}, sum.band()};
    const auto script = [&](const PlotRequest& request) {
        return plot_script({&series, 1}, nullptr, request, PictureFormat::svg);
    };
    const auto block = [&](const std::string& text, const std::string& name) {
        const std::size_t at = text.find("$" + name + " << END\n");
        EXPECT_NE(at, std::string::npos) << name;
        return at == std::string::npos ? "" : text.substr(at, text.find("\nEND\n", at) - at);
    };
    const std::string upright = block(script({}), "constants1"), bars = block(script({}), "constants_bars1");
    EXPECT_EQ(std::ranges::count(bars, '\n'), 2);
    // the outline starts at the smaller growth, at the upper end of its bar, although it was requested second
    double x = 0, y = 0;
    ASSERT_EQ(std::sscanf(upright.c_str(), "$constants1 << END\n%lf %lf", &x, &y), 2);
    EXPECT_NEAR(x, 250, 1e-9);
    EXPECT_NEAR(y, 1.02e-3 * test::sphere_pressure_Pa(1.25), 1e-9);
    EXPECT_NE(block(script({.title = "", .x = "pressure", .y = "growth"}), "constants1"), "");
    EXPECT_NE(script({}).find("±1 standard deviation"), std::string::npos);
}

TEST(Band, IsRefusedOnACurveOfAnotherMaterial) {
    const Curve fitted = sphere_of(1), plus = sphere_of(1.02), minus = sphere_of(0.98);
    BandSum sum(fitted, parse_requests("growth=500mm", fitted));
    sum.add_pair(&plus, &minus);
    const auto draws = [&](double mu) {
        const PlotSeries series{"", sphere_of(mu), {}, sum.band()};
        return plot_script({&series, 1}, nullptr, {}, PictureFormat::svg);
    };
    EXPECT_NO_THROW((void)draws(1.03));  // within the error of another mesh
    try {
        (void)draws(1.5);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        EXPECT_EQ(
            std::string(error.what()),
            "--band: the table has pressure 0.0007554 kPa where the curve has 0.001133 kPa; give the table of a result "
            "with the material of the fit");
    }
}

TEST(Band, RejectsTablesWithoutABand) {
    EXPECT_EQ(
        refusal("pressure_kPa,growth_mm\n10,100\n"),
        "band.csv: has no column such as pressure_band_kPa for this curve; give a table written by scripts/uncertainty");
    EXPECT_EQ(refusal("pressure_kPa,growth_mm,pressure_band_kPa\n10,100,-1\n"),
              "band.csv:2: column 3 'pressure_band_kPa': the width of the band is negative");
    EXPECT_NE(refusal("pressure_kPa,growth_mm,pressure_band_kPa\n10,100,x\n"), "");
}

}  // namespace
}  // namespace soft::post
