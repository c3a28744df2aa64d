#include "view/picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/text.hpp"
#include "core/units.hpp"
#include "post/gnuplot.hpp"
#include "view/colour_bar.hpp"
#include "view/creases.hpp"

namespace soft::view {

namespace {

// Margins around the body for the bars and the title, as fractions of the picture.
constexpr double left_margin = 0.05, right_margin = 0.2, top_margin = 0.11, bottom_margin = 0.12;

/// Screen coordinates and depth of a point [m].
Vector3 project(const Screen& screen, const Point& x) {
    return {dot(screen.right, x), dot(screen.up, x), dot(screen.eye, x)};
}

/// Obstacles are drawn this far around the body, over its diagonal.
constexpr double space_around = 0.08;

struct Box2 {
    std::array<double, 2> low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    std::array<double, 2> high{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};
};

void enclose(Box2& box, Window& space, const Skin& skin, const Screen& screen, std::span<const Point> bases) {
    for (const Point& x : vertex_positions(skin, bases)) {
        const Vector3 at = project(screen, x);
        for (std::size_t i = 0; i < 3; ++i) {
            space.low[i] = std::min(space.low[i], x[i]);
            space.high[i] = std::max(space.high[i], x[i]);
        }
        for (std::size_t i = 0; i < 2; ++i) {
            box.low[i] = std::min(box.low[i], at[i]);
            box.high[i] = std::max(box.high[i], at[i]);
        }
    }
}

Range range_of(const PictureStyle& style, std::span<const Shot> shots) {
    if (style.range) return *style.range;
    Range range{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
    for (const Shot& shot : shots)
        for (const double value : shot.values) {
            range.low = std::min(range.low, value);
            range.high = std::max(range.high, value);
        }
    const double size = std::max(std::abs(range.low), std::abs(range.high));
    const double least = std::max(1e-3 * post::info(style.quantity).SI_per_unit, 1e-4 * size);
    const double missing = least - (range.high - range.low);
    if (missing > 0) {
        range.low -= 0.5 * missing;
        range.high += 0.5 * missing;
    }
    return range;
}

/// Vertex positions in pixels of the raster.
std::vector<Vector3> in_raster(const Framing& frame, std::span<const Point> positions) {
    const double scale = oversampling / frame.m_per_px;
    const double x0 = oversampling * frame.width_px * (left_margin + (1 - right_margin - left_margin) / 2);
    const double y0 = oversampling * frame.height_px * (bottom_margin + (1 - top_margin - bottom_margin) / 2);
    std::vector<Vector3> out;
    for (const Point& x : positions) {
        const Vector3 at = project(frame.screen, x);
        out.push_back(
            {x0 + scale * (at[0] - frame.centre_m[0]), y0 + scale * (at[1] - frame.centre_m[1]), scale * at[2]});
    }
    return out;
}

std::vector<Segment> segments(std::span<const std::array<std::int32_t, 2>> edges, std::span<const Vector3> at) {
    std::vector<Segment> out;
    for (const auto& [a, b] : edges) out.push_back({at[static_cast<std::size_t>(a)], at[static_cast<std::size_t>(b)]});
    return out;
}

void fill_body(Raster& raster, const Body& body, const Framing& frame, const Shot& shot,
               std::span<const Point> positions, std::span<const Vector3> at) {
    const auto& skin = body.skin;
    const auto light = corner_light(skin.faces, positions, frame.screen);
    const double span = frame.range.high - frame.range.low;
    for (std::size_t f = 0; f < skin.faces.size(); ++f) {
        std::array<Corner, 4> corner;
        for (std::size_t i = 0; i < 4; ++i) {
            const auto v = static_cast<std::size_t>(skin.faces[f][i]);
            const double value = shot.values[static_cast<std::size_t>(skin.vertices[v].base)];
            corner[i] = {at[v], (value - frame.range.low) / span, light[f][i]};
        }
        raster.fill({corner[0], corner[1], corner[2]});
        if (skin.faces[f][3] != skin.faces[f][2]) raster.fill({corner[0], corner[2], corner[3]});
    }
}

/// Draws edges and silhouette of the undeformed body. Lines hidden by the undeformed body are omitted; lines behind the deformed body
/// are drawn faintly.
void draw_outline(Raster& raster, const Body& body, const Framing& frame) {
    const auto positions = vertex_positions(body.skin, body.undeformed_bases_m);
    const auto at = in_raster(frame, positions);
    Raster itself(raster.width(), raster.height(), Raster::Colours::none);
    for (const auto& [a, b, c] : triangles(body.skin))
        itself.hide(
            {at[static_cast<std::size_t>(a)], at[static_cast<std::size_t>(b)], at[static_cast<std::size_t>(c)]});
    auto edges = segments(body.skin.creases, at);
    const auto rim = segments(silhouette(body.skin.faces, positions, frame.screen.eye), at);
    edges.insert(edges.end(), rim.begin(), rim.end());
    const Stroke stroke{.colour = {0.25, 0.25, 0.25},
                        .width = 1.6 * oversampling,
                        .in_front = 0.8,
                        .behind = 0.4,
                        .bias = 1.5 * oversampling};
    raster.lines(edges, stroke, &itself);
}

void draw_obstacles(Raster& raster, const Body& body, const Framing& frame, const Shot& shot) {
    if (body.model == nullptr || body.model->obstacles.empty()) return;
    std::vector<Segment> lines;
    for (std::size_t k = 0; k < shot.shifts.size(); ++k)
        for (const Line& line :
             obstacle_lines(*body.model, body.model->obstacles[k], shot.shifts[k], frame.space, body.extent)) {
            const auto at = in_raster(frame, line);
            lines.push_back({at[0], at[1]});
        }
    raster.lines(lines, {.colour = {0.1, 0.3, 0.65}, .width = 1.2 * oversampling, .in_front = 0.7, .behind = 0.15});
}

struct Image {
    int left = 0, low = 0, width = 1, height = 1;
    std::vector<std::uint8_t> bytes;
};

/// What is not white: gnuplot draws pixel by pixel.
Image drawn_part(const std::vector<std::uint8_t>& bytes, int width) {
    const auto row_bytes = 3 * static_cast<std::size_t>(width);
    const int height = static_cast<int>(bytes.size() / row_bytes);
    int left = width, right = -1, low = height, high = -1;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::uint8_t* c = &bytes[static_cast<std::size_t>(y) * row_bytes + 3 * static_cast<std::size_t>(x)];
            if (c[0] == 255 && c[1] == 255 && c[2] == 255) continue;
            left = std::min(left, x);
            right = std::max(right, x);
            low = std::min(low, y);
            high = y;
        }
    if (high < 0) return {0, 0, 1, 1, {255, 255, 255}};
    Image image{left, low, right - left + 1, high - low + 1, {}};
    for (int y = low; y <= high; ++y) {
        const auto begin =
            bytes.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) * row_bytes) + 3 * left;
        image.bytes.insert(image.bytes.end(), begin, begin + 3 * image.width);
    }
    return image;
}

std::string number(double value) { return core::rounded_text(value, 8); }

std::string palette_text() {
    std::string text;
    int i = 0;
    for (const Rgb& colour : viridis())
        text += (text.empty() ? "" : ", ") + std::to_string(i++) + " " + number(colour.red) + " " +
                number(colour.green) + " " + number(colour.blue);
    return text;
}

}  // namespace

Framing framing(const Body& body, const PictureStyle& style, std::span<const Shot> shots) {
    constexpr double highest = std::numeric_limits<double>::max();
    Framing frame{.screen = screen_of(style.camera),
                  .space = {{highest, highest, highest}, {-highest, -highest, -highest}},
                  .range = range_of(style, shots)};
    Box2 box;
    enclose(box, frame.space, body.skin, frame.screen, body.undeformed_bases_m);
    for (const Shot& shot : shots) enclose(box, frame.space, body.skin, frame.screen, shot.bases_m);
    const double margin = space_around * norm(difference(frame.space.high, frame.space.low));
    for (std::size_t i = 0; i < 3; ++i) {
        frame.space.low[i] -= margin;
        frame.space.high[i] += margin;
    }
    std::array<double, 2> size{};
    for (std::size_t i = 0; i < 2; ++i) {
        frame.centre_m[i] = 0.5 * (box.low[i] + box.high[i]);
        size[i] = std::max(box.high[i] - box.low[i], std::numeric_limits<double>::min());
    }
    const double width = style.width_px * (1 - left_margin - right_margin), margins = 1 - top_margin - bottom_margin;
    const double ideal = width * size[1] / size[0] / margins;  // height of the picture if the width sets the scale
    const double height = std::clamp(ideal, 0.5 * style.height_px, 1.0 * style.height_px);
    frame.width_px = style.width_px / 2 * 2;
    frame.height_px = static_cast<int>(height) / 2 * 2;
    frame.m_per_px = std::max(size[0] / width, size[1] / (frame.height_px * margins));
    return frame;
}

Raster paint(const Body& body, const Framing& frame, const Shot& shot) {
    Raster raster(oversampling * frame.width_px, oversampling * frame.height_px);
    const auto positions = vertex_positions(body.skin, shot.bases_m);
    const auto at = in_raster(frame, positions);
    fill_body(raster, body, frame, shot, positions, at);
    raster.lines(segments(body.skin.creases, at), {.colour = {0.1, 0.1, 0.1},
                                                   .width = 0.8 * oversampling,
                                                   .in_front = 0.55,
                                                   .behind = 0,
                                                   .bias = 1.5 * oversampling});
    draw_outline(raster, body, frame);
    draw_obstacles(raster, body, frame, shot);
    return raster;
}

std::string picture_script(const PictureStyle& style, const Framing& frame, const Shot& shot, const Raster& raster) {
    const auto& info = post::info(style.quantity);
    const std::string w = std::to_string(frame.width_px), h = std::to_string(frame.height_px);
    const double font = frame.width_px / 64.0;
    // A letter is about 0.78 of the font size in points wide; long titles use a smaller font.
    const double title_font = std::min(
        font, 0.96 * frame.width_px / (0.78 * static_cast<double>(std::max<std::size_t>(shot.title.size(), 1))));
    const std::string label = std::string(info.label) + (info.unit.empty() ? "" : " (" + std::string(info.unit) + ")");
    const double bar_m = round_step(0.25 * frame.width_px * frame.m_per_px), bar_px = bar_m / frame.m_per_px;
    const double x0 = left_margin * frame.width_px, y0 = 0.7 * font;

    std::string script =
        "set terminal pngcairo size " + w + "," + h + " font 'Sans," + number(font) + "' linewidth 2\n";
    script += "set encoding utf8\nunset border\nunset tics\nunset key\n";
    for (const char* side : {"lmargin", "bmargin"}) script += std::string("set ") + side + " at screen 0\n";
    for (const char* side : {"rmargin", "tmargin"}) script += std::string("set ") + side + " at screen 1\n";
    // Pixel k of the image is centred at k; other ranges would draw one column and one row twice.
    script += "set xrange [-0.5:" + number(frame.width_px - 0.5) +
              "]\nset yrange [-0.5:" + number(frame.height_px - 0.5) + "]\n";
    script += "set palette defined (" + palette_text() + ")\n";
    script += colour_bar_script({.low = frame.range.low / info.SI_per_unit,
                                 .high = frame.range.high / info.SI_per_unit,
                                 .label = label,
                                 .width_px = 1.0 * frame.width_px,
                                 .height_px = 1.0 * frame.height_px,
                                 .font = font});
    script += "set label 1 " + post::gnuplot_text(shot.title) +
              " noenhanced at screen 0.5, screen 0.955 center font 'Sans," + number(title_font) + "' front\n";
    script += "set arrow 1 from " + number(x0) + "," + number(y0) + " to " + number(x0 + bar_px) + "," + number(y0) +
              " nohead linewidth 3 linecolor rgb 'black' front\n";
    script += "set label 2 " + post::gnuplot_text(core::quantity_text(bar_m, core::Dimension::length)) + " at " +
              number(x0 + bar_px / 2) + "," + number(y0 + 1.2 * font) + " center front\n";
    const Image image = drawn_part(raster.reduced(oversampling), frame.width_px);
    script += "plot '-' binary array=(" + std::to_string(image.width) + "," + std::to_string(image.height) +
              ") origin=(" + std::to_string(image.left) + "," + std::to_string(image.low) +
              ") format='%uchar%uchar%uchar' using 1:2:3 with rgbimage, NaN with points palette\n";
    script.append(image.bytes.begin(), image.bytes.end());
    return script;
}

core::Bytes picture_png(const Body& body, const PictureStyle& style, const Framing& frame, const Shot& shot,
                        std::string_view location) {
    return post::gnuplot_bytes(picture_script(style, frame, shot, paint(body, frame, shot)), location);
}

void draw_picture(const Body& body, const PictureStyle& style, const Framing& frame, const Shot& shot,
                  const std::filesystem::path& file) {
    post::run_gnuplot(picture_script(style, frame, shot, paint(body, frame, shot)), file);
}

}  // namespace soft::view
