#pragma once
/// The deformed body in colour: skin, palette, light, the undeformed outline, title, scale bar and colour bar, as PNG.
/// Body and outline are drawn here (view/raster.hpp), text and bars by the program gnuplot, which needs no display.
/// Tested by view/picture_test.
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/files.hpp"
#include "fields/quantity.hpp"
#include "view/camera.hpp"
#include "view/raster.hpp"
#include "view/skin.hpp"

namespace soft::view {

/// SI values at the two ends of the palette.
struct Range {
    double low = 0, high = 1;
};

struct Look {
    fields::Quantity quantity = fields::Quantity::stretch;
    Camera camera;
    std::optional<Range> range;             ///< empty: that of the shots
    int width_px = 1600, height_px = 1200;  ///< at most so high: a long body gets a low picture, not below half of this
};

/// One state of the body.
struct Shot {
    std::vector<Point> bases_m;  ///< view/skin.hpp
    std::vector<double> values;  ///< SI, one a base
    std::string title;           ///< one line
};

/// A skin with its undeformed bases, ready to be drawn in many states.
struct Body {
    const Skin& skin;
    std::vector<Point> undeformed_bases_m;
};

/// What all pictures of a series share: the window of the projection and the range of colours.
struct Framing {
    Screen screen;
    int width_px = 0, height_px = 0;  ///< even
    double m_per_px = 1;
    std::array<double, 2> centre_m{};  ///< of the drawn body and its outline, to the right and up
    Range range;
};

/// Holds all shots and the undeformed body. The range is that of the values, widened to a thousandth of the quantity's
/// unit and to 1e-4 of the largest value: an even field has one colour, whatever its rounding.
[[nodiscard]] Framing framing(const Body& body, const Look& look, std::span<const Shot> shots);

/// The body alone. The frame's pixels, each of `oversampling` x `oversampling` of the raster.
inline constexpr int oversampling = 2;
[[nodiscard]] Raster paint(const Body& body, const Framing& frame, const Shot& shot);

/// Round length of a scale bar: 1, 2 or 5 times a power of ten, the largest that is not longer than `longest_m`.
[[nodiscard]] double scale_bar_m(double longest_m);

/// The gnuplot script (with the image's bytes in it) that writes the PNG to gnuplot's stdout.
[[nodiscard]] std::string picture_script(const Look& look, const Framing& frame, const Shot& shot,
                                         const Raster& raster);

/// The PNG. Errors: post::gnuplot_bytes.
[[nodiscard]] core::Bytes picture_png(const Body& body, const Look& look, const Framing& frame, const Shot& shot,
                                      std::string_view place);

/// Writes FILE.png (temporary name in the same folder, renamed when whole). Error(cannot_create) without gnuplot or
/// where the file cannot be written.
void draw_picture(const Body& body, const Look& look, const Framing& frame, const Shot& shot,
                  const std::filesystem::path& file);

}  // namespace soft::view
