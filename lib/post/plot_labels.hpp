#pragma once
/// Places the labels of marked points in a plot so that they do not overlap each other or the curve. Internal; tested by
/// post/plot_labels_test.
#include <array>
#include <span>
#include <string>
#include <vector>

namespace soft::post {

struct PlotLabel {
    double x = 0, y = 0;
    std::string text;
};

/// The gnuplot commands. A label is placed above, below, right or left of its point, where it covers the fewest points of `curve` (points
/// of the curves in the units of the axes). Coincident points with the same text get one label. A label that would overlap another in
/// all four positions is omitted.
[[nodiscard]] std::string label_commands(std::span<const PlotLabel> labels,
                                         std::span<const std::array<double, 2>> curve);

}  // namespace soft::post
