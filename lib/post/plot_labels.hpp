#pragma once
/// Where the values of marked points stand in a plot, so that they hide neither each other nor the curve. Internal; tested by
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

/// gnuplot's commands: a label above, below, right or left of its point, wherever the fewest of `curve` (points of the curves, in the
/// units of the axes) lie. One for points with one text in one place; none for a label that every place would put upon another.
[[nodiscard]] std::string label_commands(std::span<const PlotLabel> labels,
                                         std::span<const std::array<double, 2>> curve);

}  // namespace soft::post
