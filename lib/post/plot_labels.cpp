#include "post/plot_labels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/text.hpp"
#include "post/gnuplot.hpp"

namespace soft::post {
namespace {

/// In fractions of the plot size: width of a letter, height of a line, distance of a label from its point, distance of coincident points.
constexpr double letter_width = 0.014, line_height = 0.05, label_distance = 0.055, same_point = 0.03;

using PlotPoint = std::array<double, 2>;

struct LabelBox {
    PlotPoint centre{}, half{};
    [[nodiscard]] bool contains(const PlotPoint& p) const {
        return std::abs(p[0] - centre[0]) < half[0] && std::abs(p[1] - centre[1]) < half[1];
    }
    [[nodiscard]] bool overlaps(const LabelBox& other) const {
        return std::abs(other.centre[0] - centre[0]) < half[0] + other.half[0] &&
               std::abs(other.centre[1] - centre[1]) < half[1] + other.half[1];
    }
};

/// Maps coordinates to fractions of the plot size.
struct PlotFrame {
    PlotPoint low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    PlotPoint high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    void include(const PlotPoint& p) {
        for (std::size_t i = 0; i < 2; ++i) {
            low[i] = std::min(low[i], p[i]);
            high[i] = std::max(high[i], p[i]);
        }
    }
    [[nodiscard]] PlotPoint share(const PlotPoint& p) const {
        PlotPoint share{};
        for (std::size_t i = 0; i < 2; ++i) share[i] = high[i] > low[i] ? (p[i] - low[i]) / (high[i] - low[i]) : 0.5;
        return share;
    }
};

struct PlacedLabel {
    LabelBox box;
    PlotPoint at{};
    std::string text;
};

}  // namespace

std::string label_commands(std::span<const PlotLabel> labels, std::span<const PlotPoint> curve) {
    PlotFrame frame;
    for (const PlotPoint& point : curve) frame.include(point);
    for (const PlotLabel& label : labels) frame.include({label.x, label.y});
    std::vector<PlotPoint> shares;
    for (const PlotPoint& point : curve) shares.push_back(frame.share(point));
    std::vector<PlacedLabel> placed;
    std::string commands;
    for (const PlotLabel& label : labels) {
        const PlotPoint at = frame.share({label.x, label.y});
        const bool is_duplicate = std::ranges::any_of(placed, [&](const PlacedLabel& other) {
            return other.text == label.text && LabelBox{other.at, {same_point, same_point}}.contains(at);
        });
        if (is_duplicate) continue;
        const PlotPoint half{0.5 * letter_width * static_cast<double>(label.text.size()), 0.5 * line_height};
        const double beside = half[0] + 0.5 * label_distance;
        const std::array<PlotPoint, 4> shifts{{{0, label_distance}, {0, -label_distance}, {beside, 0}, {-beside, 0}}};
        const PlotPoint* best = nullptr;
        std::ptrdiff_t fewest = 0;
        for (const PlotPoint& shift : shifts) {
            const LabelBox box{{at[0] + shift[0], at[1] + shift[1]}, half};
            const bool is_hidden =
                std::ranges::any_of(placed, [&](const PlacedLabel& other) { return other.box.overlaps(box); });
            const bool is_outside = box.centre[0] - half[0] < -same_point || box.centre[0] + half[0] > 1 + same_point ||
                                    box.centre[1] - half[1] < 0;
            if (is_hidden || (is_outside && shift[1] <= 0)) continue;
            const auto points =
                std::ranges::count_if(shares, [&](const PlotPoint& point) { return box.contains(point); });
            if (best != nullptr && points >= fewest) continue;
            best = &shift;
            fewest = points;
        }
        if (best == nullptr) continue;
        placed.push_back({{{at[0] + (*best)[0], at[1] + (*best)[1]}, half}, at, label.text});
        commands += "set label " + gnuplot_text(label.text) + " at " + core::number_text(label.x) + "," +
                    core::number_text(label.y) + " center offset graph " + core::rounded_text((*best)[0], 3) +
                    ", graph " + core::rounded_text((*best)[1], 3) + " noenhanced front\n";
    }
    return commands;
}

}  // namespace soft::post
