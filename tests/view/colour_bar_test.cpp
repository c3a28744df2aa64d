#include "view/colour_bar.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>

#include "picture_samples.hpp"
#include "post/gnuplot.hpp"

namespace soft::view {
namespace {

using namespace test;

std::vector<std::string> texts(double low, double high) {
    std::vector<std::string> all;
    for (const Tick& tick : bar_ticks(low, high)) all.push_back(tick.text);
    return all;
}

using Texts = std::vector<std::string>;

TEST(ColourBar, TicksAreRoundAndHaveEnoughDecimalsToBeDistinct) {
    EXPECT_EQ(texts(0, 0.4), (Texts{"0", "0.1", "0.2", "0.3", "0.4"}));
    EXPECT_EQ(texts(-1.3, 9.7), (Texts{"0", "2", "4", "6", "8"}));
    EXPECT_EQ(texts(0.99241, 1.0039), (Texts{"0.994", "0.996", "0.998", "1.000", "1.002"}));
    EXPECT_EQ(texts(-448.5226, -448.4777), (Texts{"-448.52", "-448.51", "-448.50", "-448.49", "-448.48"}));
    EXPECT_EQ(texts(0, 2e6), (Texts{"0", "5.0e+05", "1.0e+06", "1.5e+06", "2.0e+06"}));
}

TEST(ColourBar, ThereAreFourToNineTicksInsideTheRangeWithDistinctTexts) {
    for (const double middle : {0.0, 1.0, -448.5, 411.0, 123456.0, 3e-7})
        for (const double span : {1e-4, 0.00137, 0.3, 1.0, 7.3, 999.0, 4e6}) {
            const double low = middle - span / 3, high = low + span;
            const auto ticks = bar_ticks(low, high);
            EXPECT_GE(ticks.size(), 4U) << low << " " << high;
            EXPECT_LE(ticks.size(), 10U) << low << " " << high;
            std::set<std::string> different;
            for (const Tick& tick : ticks) {
                EXPECT_GE(tick.value, low - 1e-5 * span);
                EXPECT_LE(tick.value, high + 1e-5 * span);
                EXPECT_NEAR(std::stod(tick.text), tick.value, 1e-3 * span) << tick.text;
                different.insert(tick.text);
            }
            EXPECT_EQ(different.size(), ticks.size());
        }
    EXPECT_LE(bar_ticks(1e20, std::nextafter(1e20, 2e20)).size(), 10U);  // terminates
}

/// A text of an SVG picture made by gnuplot: its reference point, size and letters.
struct Text {
    double x, y, size;
    bool upright;
    std::string letters;
};

std::vector<Text> texts_of(const std::string& svg) {
    static const std::regex one(
        R"re(<g transform="translate\(([-\d.]+),([-\d.]+)\)( rotate\([-\d.]+\))?"[^>]*font-size="([\d.]+)"[^>]*>\s*<text[^>]*>(?:<tspan[^>]*>)?([^<]*))re");
    std::vector<Text> all;
    for (std::sregex_iterator hit(svg.begin(), svg.end(), one), end; hit != end; ++hit)
        all.push_back({std::stod((*hit)[1]), std::stod((*hit)[2]), std::stod((*hit)[4]), (*hit)[3].length() == 0,
                       (*hit)[5].str()});
    return all;
}

/// The texts of a picture of the cube as positioned by gnuplot: the script with SVG instead of PNG output.
std::vector<Text> texts_of_picture(const PictureStyle& look, double low, double high) {
    const Cube cube;
    PictureStyle wanted = look;
    wanted.range = Range{low, high};
    const Shot shot = cube.pulled(0.5 * (low + high));
    const Framing frame = framing(cube.body, wanted, {&shot, 1});
    std::string script = picture_script(wanted, frame, shot, paint(cube.body, frame, shot));
    script.replace(script.find("pngcairo"), 8, "svg");
    return texts_of(post::gnuplot_output(script, "x"));
}

/// Points are 4/3 of a pixel in the PNG terminal; a letter of Sans is about 0.6 of its size wide.
double width_of(const Text& text) { return 0.6 * 4 / 3 * text.size * static_cast<double>(text.letters.size()); }

TEST(ColourBar, LongNumbersAndLabelsStayInsideThePicture) {
    const Cube cube;
    PictureStyle look = cube.look;
    for (const post::QuantityInfo& info : post::quantities())
        for (const double low : {0.994, -448.52, -123456.0, 1e12}) {
            look.quantity = info.quantity;
            const double unit = info.SI_per_unit, span = std::max(1e-3, 1e-4 * std::abs(low));
            bool label = false;
            double numbers_end = 0, label_begin = 0;
            for (const Text& text : texts_of_picture(look, low * unit, (low + span) * unit)) {
                if (text.letters.starts_with(info.label)) {
                    label = true;
                    EXPECT_LT(text.x + 0.5 * text.size, look.width_px) << info.name << " " << low;
                    EXPECT_GT(text.y, 0.5 * width_of(text)) << info.name;
                    label_begin = text.x - text.size;
                } else if (text.upright && text.x > 0.8 * look.width_px) {
                    numbers_end = std::max(numbers_end, text.x + width_of(text));
                }
            }
            EXPECT_TRUE(label) << info.name;
            EXPECT_GT(numbers_end, 0) << info.name;
            EXPECT_LT(numbers_end, label_begin) << info.name << " " << low;
        }
}

}  // namespace
}  // namespace soft::view
