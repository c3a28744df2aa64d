#pragma once
/// The data of a picture as gnuplot data blocks, one "x y" per line. Internal; tested by post/plot_test.
#include <array>
#include <string>
#include <vector>

#include "post/plot.hpp"
#include "post/plot_labels.hpp"

namespace soft::post {

struct Blocks {
    /// Sampled path, strokes separated by an empty line; with a third column if the path is coloured.
    std::string stable, unstable;
    std::vector<std::array<double, 2>> points;  ///< points of `stable` and `unstable`
    std::vector<std::array<double, 2>> edges;   ///< points of the bands
    std::string markers;                        ///< converged steps
    std::string band;                           ///< closed outlines of the mesh error
    std::string tolerances;                     ///< closed outlines of the band of tolerances
    std::string bars;                           ///< "x y xlow xhigh ylow yhigh" at the markers
    std::string limits, bifurcations;           ///< "x y label"
    std::string arrows;                         ///< "x y dx dy" in the middle of each stage, where there are several
    std::vector<PlotLabel> labels;              ///< labels of limit points and bifurcations
};

/// Markers are reduced to about `max_markers`.
[[nodiscard]] Blocks make_blocks(const PlotSeries& series, const PlotAxes& axes, std::size_t max_markers);

/// Measured values of both columns; empty if one was not measured.
[[nodiscard]] std::string point_block(const Measured& measured, const PlotAxes& axes);

}  // namespace soft::post
