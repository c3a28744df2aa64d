#pragma once
/// A picture in memory that knows depth: triangles hide what lies behind them to the pixel, which sorting polygons by
/// their distance, as plotting programs do, cannot promise for thin walls close together. Positions in pixels, x to the
/// right, y up from the lower left corner, depth growing towards the eye. Tested by view/raster_test.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/tensor.hpp"
#include "view/palette.hpp"

namespace soft::view {

struct Corner {
    Vector3 at;    ///< pixel, pixel, depth
    double value;  ///< 0 to 1 along the palette
    double light;  ///< 0 to 1
};

using Segment = std::array<Vector3, 2>;

/// How a line is seen: its opacity in front of the surface and behind it, its width in pixels.
struct Stroke {
    Rgb colour;
    double width = 1;
    double in_front = 1, behind = 0;
    double bias = 0;  ///< of depth: so much nearer than it is, to lie on the surface it belongs to
};

class Raster {
public:
    /// White, nothing in it.
    Raster(int width, int height);

    [[nodiscard]] int width() const noexcept { return width_; }
    [[nodiscard]] int height() const noexcept { return height_; }

    /// Colour and depth.
    void fill(const std::array<Corner, 3>& triangle);
    /// Depth alone: hides, but is not seen.
    void hide(const std::array<Vector3, 3>& triangle);
    /// Drawn as one: where segments overlap the ink does not add up. Where `hiding` is given (of the same size), what
    /// lies behind it is left out.
    void lines(std::span<const Segment> segments, const Stroke& stroke, const Raster* hiding = nullptr);

    [[nodiscard]] Rgb colour(int x, int y) const;
    /// Bytes red, green, blue, row by row from below, every `side` x `side` pixels averaged to one.
    [[nodiscard]] std::vector<std::uint8_t> reduced(int side) const;

private:
    void cover(const Segment& segment, const Stroke& stroke, const Raster* hiding, std::vector<float>& opacity) const;
    template <class Paint>
    void visit(const std::array<Vector3, 3>& triangle, Paint&& paint);
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }

    int width_, height_;
    std::vector<float> depth_;
    std::vector<std::array<float, 3>> colour_;
};

}  // namespace soft::view
