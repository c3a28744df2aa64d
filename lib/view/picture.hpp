#pragma once
/// Picture of the deformed body coloured by a field, as PNG: surface with shading, the undeformed outline, lines of the obstacles, title,
/// scale bar and colour bar. Body and lines are rendered here (view/raster.hpp), text and bars by the program gnuplot, which needs no
/// display. Tested by view/picture_test.
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/files.hpp"
#include "post/quantity.hpp"
#include "view/camera.hpp"
#include "view/obstacle_lines.hpp"
#include "view/raster.hpp"
#include "view/skin.hpp"

namespace soft::view {

/// SI values at the two ends of the palette.
struct Range {
    double low = 0, high = 1;
};

struct PictureStyle {
    post::Quantity quantity = post::Quantity::stretch;
    Camera camera;
    std::optional<Range> range;             ///< empty: range of the values in the shots
    int width_px = 1600, height_px = 1200;  ///< maximum height: a long body gets a lower picture, at least half of it
};

/// One state of the body.
struct Shot {
    std::vector<Point> bases_m;        ///< view/skin.hpp
    std::vector<double> values;        ///< SI, one per base
    std::string title;                 ///< one line
    std::vector<Vector3> shifts = {};  ///< displacement of each obstacle
};

/// A skin with its undeformed bases, drawn in one or more states, and the obstacles around it.
struct Body {
    const Skin& skin;
    std::vector<Point> undeformed_bases_m;
    const model::Case* model = nullptr;  ///< with obstacles, otherwise null
    Extent extent = Extent::modelled;
};

/// Common to all pictures of a series: the window of the projection, the space in which obstacles are drawn, and the colour range.
struct Framing {
    Screen screen;
    Window space;
    int width_px = 0, height_px = 0;  ///< even
    double m_per_px = 1;
    std::array<double, 2> centre_m{};  ///< centre of the drawn body and its outline, to the right and up
    Range range;
};

/// The framing that contains all shots and the undeformed body. The colour range is that of the values, but at least a thousandth
/// of the quantity's unit and 1e-4 of the largest value, so that a uniform field has one colour despite rounding.
[[nodiscard]] Framing framing(const Body& body, const PictureStyle& style, std::span<const Shot> shots);

/// Renders the body without text. Each pixel of the frame is `oversampling` x `oversampling` pixels of the raster.
inline constexpr int oversampling = 2;
[[nodiscard]] Raster paint(const Body& body, const Framing& frame, const Shot& shot);

/// The gnuplot script (including the bytes of the image) that writes the PNG to gnuplot's stdout.
[[nodiscard]] std::string picture_script(const PictureStyle& style, const Framing& frame, const Shot& shot,
                                         const Raster& raster);

/// The PNG in memory. Errors: post::gnuplot_bytes.
[[nodiscard]] core::Bytes picture_png(const Body& body, const PictureStyle& style, const Framing& frame,
                                      const Shot& shot, std::string_view location);

/// Writes FILE.png (temporary name in the same folder, renamed when complete). Error(cannot_create) if gnuplot is missing or the
/// file cannot be written.
void draw_picture(const Body& body, const PictureStyle& style, const Framing& frame, const Shot& shot,
                  const std::filesystem::path& file);

}  // namespace soft::view
