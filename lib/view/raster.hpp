#pragma once
/// Software rasterizer with a depth buffer: hidden surfaces are removed per pixel, which sorting polygons by distance, as plotting
/// programs do, cannot guarantee for thin walls close together. Positions in pixels, x to the right, y up from the lower left corner,
/// depth increasing towards the eye. Tested by view/raster_test.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "math/tensor.hpp"
#include "view/palette.hpp"

namespace soft::view {

struct Corner {
    Vector3 at;    ///< pixel, pixel, depth
    double value;  ///< 0 to 1 along the palette
    double light;  ///< 0 to 1
};

using Segment = std::array<Vector3, 2>;

/// Style of a line: opacity in front of the surface and behind it, width in pixels.
struct Stroke {
    Rgb colour;
    double width = 1;
    double in_front = 1, behind = 0;
    double bias = 0;  ///< added to the depth, so that a line on a surface is in front of it
};

class Raster {
public:
    /// A white, empty picture; without colours it only hides lines of another one.
    enum class Colours { none, white };
    Raster(int width, int height, Colours colours = Colours::white);

    [[nodiscard]] int width() const noexcept { return width_; }
    [[nodiscard]] int height() const noexcept { return height_; }

    /// Draws colour and depth of a picture with colours.
    void fill(const std::array<Corner, 3>& triangle);
    /// Draws depth only: an invisible triangle that hides lines behind it.
    void hide(const std::array<Vector3, 3>& triangle);
    /// Draws the segments as one line: opacities do not add up where segments overlap. Parts behind the raster `hiding` (of the
    /// same size), if given, are omitted.
    void lines(std::span<const Segment> segments, const Stroke& stroke, const Raster* hiding = nullptr);

    [[nodiscard]] Rgb colour(int x, int y) const;
    /// Bytes red, green, blue, row by row from the bottom; blocks of `side` x `side` pixels are averaged to one.
    [[nodiscard]] std::vector<std::uint8_t> reduced(int side) const;

private:
    void cover(const Segment& segment, const Stroke& stroke, const Raster* hiding);
    template <class Paint>
    void visit(const std::array<Vector3, 3>& triangle, Paint&& paint);
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }

    int width_, height_;
    std::vector<float> depth_;
    std::vector<std::uint8_t> colour_;  // red, green, blue of each pixel
    std::vector<float> opacity_;        // of the lines being drawn
};

}  // namespace soft::view
