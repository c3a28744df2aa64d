#include "view/picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/files.hpp"
#include "picture_samples.hpp"
#include "view/colour_bar.hpp"

namespace soft::view {
namespace {

using namespace test;

/// Width and height in the head of a PNG file (PNG specification, IHDR).
std::pair<int, int> png_size(const std::filesystem::path& file) {
    const core::Bytes bytes = core::read_file(file);
    const auto number = [&](std::size_t at) {
        int value = 0;
        for (std::size_t i = 0; i < 4; ++i) value = 256 * value + std::to_integer<int>(bytes.at(at + i));
        return value;
    };
    EXPECT_EQ(std::to_integer<int>(bytes.at(1)), 'P');
    return {number(16), number(20)};
}

TEST(Picture, TheScaleBarHasARoundLengthThatFits) {
    EXPECT_DOUBLE_EQ(round_step(0.0231), 0.02);
    EXPECT_DOUBLE_EQ(round_step(0.0199), 0.01);
    EXPECT_DOUBLE_EQ(round_step(0.5), 0.5);
    EXPECT_DOUBLE_EQ(round_step(0.099), 0.05);
    EXPECT_DOUBLE_EQ(round_step(9.0), 5.0);
}

TEST(Picture, TheFrameContainsTheUndeformedAndEveryDeformedBody) {
    const Cube cube;
    const Shot shot = cube.pulled(1.5);
    const Framing frame = framing(cube.body, cube.look, {&shot, 1});
    EXPECT_DOUBLE_EQ(frame.centre_m[0], 1.0);  // from x = 0 to 2
    EXPECT_DOUBLE_EQ(frame.centre_m[1], 0.5);
    EXPECT_EQ(frame.width_px, 400);
    EXPECT_LT(2.0 / frame.m_per_px, 400);
    EXPECT_GT(2.0 / frame.m_per_px, 200);
}

/// The share of the palette whose hue is nearest to a colour, whatever its brightness.
double share_of(const Rgb& seen) {
    const auto unit = [](const Rgb& c) {
        const double size = std::sqrt(c.red * c.red + c.green * c.green + c.blue * c.blue);
        return Vector3{c.red / size, c.green / size, c.blue / size};
    };
    double best = 0, nearest = 2;
    for (int i = 0; i <= 100; ++i) {
        const Vector3 a = unit(seen), b = unit(viridis_at(i / 100.0));
        const double distance = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
        if (distance < nearest) {
            nearest = distance;
            best = i / 100.0;
        }
    }
    return best;
}

TEST(Picture, TheColourOfAPixelIsThatOfItsValueInTheRange) {
    const Cube cube;
    for (const double value : {1.0, 1.25, 1.5, 1.75, 2.0}) {
        const Shot shot = cube.pulled(value);
        const Framing frame = framing(cube.body, cube.look, {&shot, 1});
        const Raster raster = paint(cube.body, frame, shot);
        int coloured = 0;
        for (int y = 0; y < raster.height(); y += 5)
            for (int x = 0; x < raster.width(); x += 5) {
                const Rgb seen = raster.colour(x, y);
                const double high = std::max({seen.red, seen.green, seen.blue}),
                             low = std::min({seen.red, seen.green, seen.blue});
                if (high - low < 0.2) continue;  // background and lines
                ++coloured;
                EXPECT_NEAR(share_of(seen), value - 1.0, 0.12);
            }
        // the deformed front face, 2 m x 1 m
        const double face = 2 * std::pow(oversampling / frame.m_per_px, 2) / 25;
        EXPECT_NEAR(coloured, face, 0.1 * face) << value;
        EXPECT_EQ(raster.colour(1, 1).green, 1.0);
    }
}

TEST(Picture, WithoutARangeTheColoursSpanTheValuesOfAllShots) {
    Cube cube;
    cube.look.range.reset();
    const std::array<Shot, 2> shots{cube.pulled(1.2), cube.pulled(1.7)};
    const Framing both = framing(cube.body, cube.look, shots);
    EXPECT_DOUBLE_EQ(both.range.low, 1.2);
    EXPECT_DOUBLE_EQ(both.range.high, 1.7);
    const Framing one =
        framing(cube.body, cube.look, {shots.data(), 1});  // uniform field: rounding must not span the range
    EXPECT_NEAR(one.range.high - one.range.low, 1e-3, 1e-12);
}

TEST(Picture, TheHeightAdaptsToALongBody) {
    Cube cube;
    cube.look.camera = {0, 0};
    const Shot shot = cube.pulled(1.5);
    EXPECT_LT(framing(cube.body, cube.look, {&shot, 1}).height_px, 300);
    cube.look.camera = {90, 0};  // a square
    EXPECT_EQ(framing(cube.body, cube.look, {&shot, 1}).height_px, 300);
}

TEST(Picture, ATitleIsNotExecutedAsACommand) {
    const Cube cube;
    const Shot shot = cube.pulled(1.5, "it's\n` touch hacked ` @x {/Bold y}");
    const Framing frame = framing(cube.body, cube.look, {&shot, 1});
    const std::string script = picture_script(cube.look, frame, shot, paint(cube.body, frame, shot));
    EXPECT_NE(script.find("set label 1 'it''s?` touch hacked ` @x {/Bold y}' noenhanced"), std::string::npos);
    const auto folder = fresh_folder("soft_title");
    draw_picture(cube.body, cube.look, frame, shot, folder / "a.png");
    EXPECT_FALSE(std::filesystem::exists("hacked"));
}

TEST(Picture, IsAPngOfTheFramesSize) {
    const Cube cube;
    const Shot shot = cube.pulled(1.5);
    const Framing frame = framing(cube.body, cube.look, {&shot, 1});
    const auto folder = fresh_folder("soft_picture");
    draw_picture(cube.body, cube.look, frame, shot, folder / "a.png");
    EXPECT_EQ(png_size(folder / "a.png"), std::pair(frame.width_px, frame.height_px));
}

}  // namespace
}  // namespace soft::view
