#include "view/raster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace soft::view {

namespace {

/// Twice the signed area of (a, b, p) in the picture.
double area(const Vector3& a, const Vector3& b, double x, double y) {
    return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
}

/// Palette colour with shading: bright enough that the colour remains recognizable, with a faint specular highlight.
std::array<double, 3> lit(double value, double light) {
    const Rgb colour = viridis_at(value);
    const double strength = 0.68 + 0.32 * light;
    const double squared = light * light, fourth = squared * squared, gloss = 0.12 * fourth * fourth;
    const auto mixed = [&](double c) { return strength * c + gloss * (1.0 - strength * c); };
    return {mixed(colour.red), mixed(colour.green), mixed(colour.blue)};
}

std::uint8_t byte_of(double c) { return static_cast<std::uint8_t>(std::lround(255 * c)); }

}  // namespace

Raster::Raster(int width, int height, Colours colours)
    : width_(width),
      height_(height),
      depth_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
             -std::numeric_limits<float>::infinity()),
      colour_(colours == Colours::white ? 3 * depth_.size() : 0, 255) {}

template <class Paint>
void Raster::visit(const std::array<Vector3, 3>& t, Paint&& paint) {
    const double whole = area(t[0], t[1], t[2][0], t[2][1]);
    if (whole == 0.0) return;  // seen edge-on
    const auto [left, right] = std::minmax({t[0][0], t[1][0], t[2][0]});
    const auto [low, high] = std::minmax({t[0][1], t[1][1], t[2][1]});
    const int x0 = std::max(0, static_cast<int>(std::floor(left))),
              x1 = std::min(width_ - 1, static_cast<int>(std::ceil(right)));
    const int y0 = std::max(0, static_cast<int>(std::floor(low))),
              y1 = std::min(height_ - 1, static_cast<int>(std::ceil(high)));
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) {
            const double px = x + 0.5, py = y + 0.5;
            const std::array<double, 3> share{area(t[1], t[2], px, py) / whole, area(t[2], t[0], px, py) / whole,
                                              area(t[0], t[1], px, py) / whole};
            if (share[0] < 0 || share[1] < 0 || share[2] < 0) continue;
            const auto depth = static_cast<float>(share[0] * t[0][2] + share[1] * t[1][2] + share[2] * t[2][2]);
            const std::size_t i = index(x, y);
            if (depth <= depth_[i]) continue;
            depth_[i] = depth;
            paint(i, share);
        }
}

void Raster::fill(const std::array<Corner, 3>& c) {
    visit({c[0].at, c[1].at, c[2].at}, [&](std::size_t i, const std::array<double, 3>& s) {
        const auto colour = lit(s[0] * c[0].value + s[1] * c[1].value + s[2] * c[2].value,
                                s[0] * c[0].light + s[1] * c[1].light + s[2] * c[2].light);
        for (std::size_t k = 0; k < 3; ++k) colour_[3 * i + k] = byte_of(colour[k]);
    });
}

void Raster::hide(const std::array<Vector3, 3>& triangle) {
    visit(triangle, [](std::size_t, const std::array<double, 3>&) {});
}

void Raster::cover(const Segment& segment, const Stroke& stroke, const Raster* hiding) {
    const auto& [from, to] = segment;
    const double dx = to[0] - from[0], dy = to[1] - from[1], squared = dx * dx + dy * dy, half = 0.5 * stroke.width;
    const int x0 = std::max(0, static_cast<int>(std::floor(std::min(from[0], to[0]) - half)));
    const int x1 = std::min(width_ - 1, static_cast<int>(std::ceil(std::max(from[0], to[0]) + half)));
    const int y0 = std::max(0, static_cast<int>(std::floor(std::min(from[1], to[1]) - half)));
    const int y1 = std::min(height_ - 1, static_cast<int>(std::ceil(std::max(from[1], to[1]) + half)));
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) {
            const double px = x + 0.5 - from[0], py = y + 0.5 - from[1];
            const double t = squared > 0 ? std::clamp((px * dx + py * dy) / squared, 0.0, 1.0) : 0.0;
            const double ax = px - t * dx, ay = py - t * dy;
            if (ax * ax + ay * ay > half * half) continue;
            const auto depth = static_cast<float>(from[2] + t * (to[2] - from[2]) + stroke.bias);
            const std::size_t i = index(x, y);
            if (hiding != nullptr && depth < hiding->depth_[i]) continue;
            const double ink = depth < depth_[i] ? stroke.behind : stroke.in_front;
            opacity_[i] = std::max(opacity_[i], static_cast<float>(ink));
        }
}

void Raster::lines(std::span<const Segment> segments, const Stroke& stroke, const Raster* hiding) {
    opacity_.assign(depth_.size(), 0.0F);
    for (const Segment& segment : segments) cover(segment, stroke, hiding);
    const std::array<double, 3> ink{stroke.colour.red, stroke.colour.green, stroke.colour.blue};
    for (std::size_t i = 0; i < opacity_.size(); ++i)
        for (std::size_t k = 0; k < 3 && opacity_[i] > 0; ++k) {
            const double before = colour_[3 * i + k] / 255.0;
            colour_[3 * i + k] = byte_of(before + opacity_[i] * (ink[k] - before));
        }
}

Rgb Raster::colour(int x, int y) const {
    const std::uint8_t* c = &colour_[3 * index(x, y)];
    return {c[0] / 255.0, c[1] / 255.0, c[2] / 255.0};
}

std::vector<std::uint8_t> Raster::reduced(int side) const {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(3 * static_cast<std::size_t>(width_ / side) * static_cast<std::size_t>(height_ / side));
    for (int y = 0; y + side <= height_; y += side)
        for (int x = 0; x + side <= width_; x += side)
            for (std::size_t k = 0; k < 3; ++k) {
                int sum = side * side / 2;
                for (int j = 0; j < side; ++j)
                    for (int i = 0; i < side; ++i) sum += colour_[3 * index(x + i, y + j) + k];
                bytes.push_back(static_cast<std::uint8_t>(sum / (side * side)));
            }
    return bytes;
}

}  // namespace soft::view
