#include "post/plot_labels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/text.hpp"
#include "post/gnuplot.hpp"

namespace soft::post {
namespace {

/// In shares of the plot, both ways: a letter, a line, the distance of a label from its point, points that are the same.
constexpr double letter_width = 0.014, line_height = 0.05, label_distance = 0.055, same_place = 0.03;

using Spot = std::array<double, 2>;

struct LabelBox {
    Spot centre{}, half{};
    [[nodiscard]] bool holds(const Spot& p) const {
        return std::abs(p[0] - centre[0]) < half[0] && std::abs(p[1] - centre[1]) < half[1];
    }
    [[nodiscard]] bool overlaps(const LabelBox& other) const {
        return std::abs(other.centre[0] - centre[0]) < half[0] + other.half[0] &&
               std::abs(other.centre[1] - centre[1]) < half[1] + other.half[1];
    }
};

/// What turns coordinates into shares of the plot.
struct PlotFrame {
    Spot low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Spot high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    void include(const Spot& p) {
        for (std::size_t i = 0; i < 2; ++i) {
            low[i] = std::min(low[i], p[i]);
            high[i] = std::max(high[i], p[i]);
        }
    }
    [[nodiscard]] Spot share(const Spot& p) const {
        Spot share{};
        for (std::size_t i = 0; i < 2; ++i) share[i] = high[i] > low[i] ? (p[i] - low[i]) / (high[i] - low[i]) : 0.5;
        return share;
    }
};

struct PlacedLabel {
    LabelBox box;
    Spot at{};
    std::string text;
};

}  // namespace

std::string label_commands(std::span<const PlotLabel> labels, std::span<const Spot> curve) {
    PlotFrame frame;
    for (const Spot& point : curve) frame.include(point);
    for (const PlotLabel& label : labels) frame.include({label.x, label.y});
    std::vector<Spot> shares;
    for (const Spot& point : curve) shares.push_back(frame.share(point));
    std::vector<PlacedLabel> placed;
    std::string commands;
    for (const PlotLabel& label : labels) {
        const Spot at = frame.share({label.x, label.y});
        const bool is_there = std::ranges::any_of(placed, [&](const PlacedLabel& other) {
            return other.text == label.text && LabelBox{other.at, {same_place, same_place}}.holds(at);
        });
        if (is_there) continue;
        const Spot half{0.5 * letter_width * static_cast<double>(label.text.size()), 0.5 * line_height};
        const double beside = half[0] + 0.5 * label_distance;
        const std::array<Spot, 4> shifts{{{0, label_distance}, {0, -label_distance}, {beside, 0}, {-beside, 0}}};
        const Spot* best = nullptr;
        std::ptrdiff_t fewest = 0;
        for (const Spot& shift : shifts) {
            const LabelBox box{{at[0] + shift[0], at[1] + shift[1]}, half};
            const bool hides =
                std::ranges::any_of(placed, [&](const PlacedLabel& other) { return other.box.overlaps(box); });
            const bool is_outside = box.centre[0] - half[0] < -same_place || box.centre[0] + half[0] > 1 + same_place ||
                                    box.centre[1] - half[1] < 0;
            if (hides || (is_outside && shift[1] <= 0)) continue;
            const auto points = std::ranges::count_if(shares, [&](const Spot& point) { return box.holds(point); });
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
