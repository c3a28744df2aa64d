#pragma once
/// The numbers of a picture as gnuplot's data blocks, "x y" a line. Internal; held by post/plot_test.
#include <array>
#include <string>
#include <vector>

#include "post/plot.hpp"
#include "post/plot_labels.hpp"

namespace soft::post {

struct Blocks {
    /// Sampled path, strokes apart by an empty line; with a third column where there is one for the colour.
    std::string stable, unstable;
    std::vector<std::array<double, 2>> points;  ///< of the same
    std::vector<std::array<double, 2>> edges;   ///< of the bands
    std::string markers;                        ///< converged steps
    std::string band;                           ///< outline of the errors, there and back
    std::string constants;                      ///< band of the constants, as outlines apart by an empty line
    std::string constants_bars;                 ///< the same at the rows of its table, "x y xlow xhigh ylow yhigh"
    std::string bars;                           ///< "x y xlow xhigh ylow yhigh" at the markers
    std::string limits, bifurcations;           ///< "x y label"
    std::vector<PlotLabel> labels;              ///< of both
};

/// Markers are thinned out to about `max_markers`.
[[nodiscard]] Blocks make_blocks(const PlotSeries& series, const PlotAxes& axes, std::size_t max_markers);

/// Measured values of both columns; empty where one was not measured.
[[nodiscard]] std::string point_block(const Measured& measured, const PlotAxes& axes);

}  // namespace soft::post
