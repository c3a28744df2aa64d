#pragma once
/// Picture of one or more paths: any column of the curve over any other. Each path is the smooth curve of post::Path, its
/// unstable part dashed, converged steps as markers, limit points as filled triangles and bifurcations as filled squares with
/// their value (plot_labels.hpp), the errors of the mesh (`solve --tolerance`) and of the constants as bands with bars, measured points
/// as crosses. Paths differ in their markers, so nothing depends on colour unless a third quantity is asked for; the colours are those of Okabe and Ito (2008), told apart by all eyes.
/// Tested by post/plot_test.
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "post/band.hpp"
#include "post/curve.hpp"
#include "post/measured.hpp"
#include "solution/path.hpp"

namespace soft::post {

struct PlotRequest {
    std::string title = {};      ///< one line above the picture; may be empty
    std::string x = {}, y = {};  ///< quantities ("elongation") or columns ("elongation_mm"); empty: see plot_axes
    std::string colour = {};     ///< the same, shown by the colour of the path; empty: none
};

struct PlotSeries {
    std::string label;  ///< in the legend, where there are several
    Curve curve;
    solution::PathEnd end;          ///< its limit points and bifurcations are drawn
    std::optional<Band> band = {};  ///< of its constants, drawn where both axes are in its table
};

enum class PictureFormat { svg, png, pdf };

/// By the ending of the name; Error(usage) for another one.
[[nodiscard]] PictureFormat picture_format(const std::filesystem::path& file);

/// Columns of the curve.
struct PlotAxes {
    std::size_t x = 0, y = 0;
    std::optional<std::size_t> colour = {};
};
/// What is asked for; else the load over the first output (the cavity volume where a case measures none), of a motion the
/// first output over time: where there are measured data, the first output that was measured. Error: usage for a quantity the
/// curve does not have or that was not measured, bad_input where it measures nothing.
[[nodiscard]] PlotAxes plot_axes(const Curve& curve, const PlotRequest& request, const Measured* measured = nullptr);

/// The gnuplot script that writes the picture to gnuplot's stdout. `measured` (or nullptr) belongs to the first series.
/// Errors as plot_axes; bad_input where a further series does not have the axes of the first.
[[nodiscard]] std::string plot_script(std::span<const PlotSeries> series, const Measured* measured,
                                      const PlotRequest& request, PictureFormat format);

/// Writes the picture (temporary name in the same folder, renamed when whole). Needs the program gnuplot.
/// Errors: as picture_format and plot_script; cannot_create without gnuplot or where the file cannot be written.
void draw_plot(std::span<const PlotSeries> series, const Measured* measured, const PlotRequest& request,
               const std::filesystem::path& file);

}  // namespace soft::post
