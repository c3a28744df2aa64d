#include "view/palette.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace soft::view {
namespace {

/// CIE 1976 lightness of an sRGB colour (IEC 61966-2-1).
double lightness(const Rgb& colour) {
    const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    const double Y = 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
    return Y > 0.008856 ? 116 * std::cbrt(Y) - 16 : 903.3 * Y;
}

TEST(Palette, LightnessIncreasesLinearly) {
    const double low = lightness(viridis_at(0)), high = lightness(viridis_at(1));
    double before = low;
    for (int i = 1; i <= 200; ++i) {
        const double now = lightness(viridis_at(i / 200.0));
        EXPECT_GT(now, before);
        EXPECT_NEAR(now, low + (high - low) * i / 200.0, 2.5);  // of 100
        before = now;
    }
    EXPECT_GT(high - low, 70.0);
}

TEST(Palette, EndsMatchThePublishedTable) {
    const Rgb first = viridis_at(0), last = viridis_at(1);  // S. van der Walt and N. Smith (2015), entries 0 and 255
    EXPECT_NEAR(first.red, 0.267004, 1e-4);
    EXPECT_NEAR(first.green, 0.004874, 1e-4);
    EXPECT_NEAR(first.blue, 0.329415, 1e-4);
    EXPECT_NEAR(last.red, 0.993248, 1e-4);
    EXPECT_NEAR(last.green, 0.906157, 1e-4);
    EXPECT_NEAR(last.blue, 0.143936, 1e-4);
}

TEST(Palette, ValuesOutsideTheRangeAreClamped) {
    EXPECT_EQ(viridis_at(-3).green, viridis_at(0).green);
    EXPECT_EQ(viridis_at(7).green, viridis_at(1).green);
    EXPECT_EQ(viridis_at(std::numeric_limits<double>::quiet_NaN()).green, viridis_at(0).green);
}

}  // namespace
}  // namespace soft::view
