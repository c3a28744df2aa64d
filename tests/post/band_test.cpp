#include "post/band.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "path_samples.hpp"
#include "post/plot.hpp"

namespace soft::post {
namespace {

const Curve& sphere() {
    static const Curve curve = make_curve(test::sample_case({"growth"}), test::sphere_path(9, 3));
    return curve;
}

Band read(const std::string& text) { return read_band(table::read_table(text, "band.csv"), sphere()); }

std::string refusal(const std::string& text) {
    try {
        static_cast<void>(read(text));
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        return error.what();
    }
    return "";
}

TEST(Band, TakesTheSampledWidthWhereThereIsOne) {
    const Band linear = read("step,pressure_kPa,growth_mm,band_linear\n1,10,100,0.5\n2,20,300,1\n");
    EXPECT_FALSE(linear.sampled);
    EXPECT_EQ(linear.half, (std::vector<double>{0.5, 1}));
    EXPECT_EQ(linear.points.find(linear.load)->values, (std::vector<double>{10, 20}));
    EXPECT_EQ(read("pressure_kPa,growth_mm,band_linear,band_sampled\n10,100,0.5,0.6\n").half,
              (std::vector<double>{0.6}));
}

TEST(Band, IsDrawnAroundTheLoadWhicheverAxisItIsOn) {
    PlotSeries series{"", sphere(), {}, read("pressure_kPa,growth_mm,band_linear\n10,100,0.5\n20,300,1\n")};
    const auto script = [&](const PlotRequest& request) {
        return plot_script({&series, 1}, nullptr, request, PictureFormat::svg);
    };
    EXPECT_NE(script({}).find("\n100 10 100 100 9.5 10.5\n300 20 300 300 19 21\nEND"), std::string::npos);
    EXPECT_NE(script({.title = "", .x = "pressure", .y = "growth"})
                  .find("\n10 100 9.5 10.5 100 100\n20 300 19 21 300 300\nEND"),
              std::string::npos);
    EXPECT_NE(script({}).find("one standard deviation of the constants"), std::string::npos);
    EXPECT_EQ(script({.title = "", .x = "growth", .y = "volume"}).find("one standard deviation"), std::string::npos);
}

TEST(Band, RefusesTablesWithoutOne) {
    EXPECT_EQ(refusal("pressure_kPa,growth_mm\n10,100\n"),
              "band.csv: has no column band_linear or band_sampled; give a table that scripts/uncertainty has written");
    EXPECT_EQ(refusal("pressure_kPa,growth_mm,band_linear\n10,100,-1\n"), "band.csv:2: the band is less than 0 wide");
    EXPECT_NE(refusal("pressure_kPa,band_linear\n10,1\n"), "");
}

}  // namespace
}  // namespace soft::post
