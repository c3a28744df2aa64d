#pragma once
/// Picture of one or more paths: any column of the curve over any other. Each path is drawn as the smooth curve of post::Path, with the
/// unstable part dashed, converged steps as markers, limit points as filled triangles and bifurcations as filled squares with their
/// value (plot_labels.hpp), errors of the mesh (`solve --tolerance`) as a band with bars, tolerances (sensitivity.hpp) as a band, and measured points as
/// crosses. Paths have different markers, so colour carries no information unless a third quantity is requested. The colours are those
/// of Okabe and Ito (2008), which are safe for colour-blind readers.
/// Tested by post/plot_test.
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/path.hpp"
#include "post/curve.hpp"
#include "post/gnuplot.hpp"
#include "post/measured.hpp"

namespace soft::post {

struct PlotRequest {
    std::string title = {};      ///< one line above the picture; empty: no title
    std::string x = {}, y = {};  ///< quantities ("elongation") or columns ("elongation_mm"); empty: see plot_axes
    std::string colour = {};     ///< quantity or column shown by the colour of the path; empty: none
};

struct PlotSeries {
    std::string label;  ///< in the legend, if there are several paths
    Curve curve;
    model::PathEnd end;  ///< its limit points and bifurcations are drawn
};

/// Columns of the curve.
struct PlotAxes {
    std::size_t x = 0, y = 0;
    std::optional<std::size_t> colour = {};
};
/// The requested axes. Default: the load over the first output (over the cavity volume if the case has no output); for a motion the
/// first output over time. With measured data, the first measured output is used. Throws Error: usage for a quantity that the curve does
/// not have or that was not measured, bad_input if the case has no output and no cavity volume.
[[nodiscard]] PlotAxes plot_axes(const Curve& curve, const PlotRequest& request, const Measured* measured = nullptr);

/// The gnuplot script that writes the picture to gnuplot's stdout. `measured` (or nullptr) belongs to the first series.
/// Throws as plot_axes; bad_input if another series does not have the axes of the first.
[[nodiscard]] std::string plot_script(std::span<const PlotSeries> series, const Measured* measured,
                                      const PlotRequest& request, PictureFormat format);

/// Writes the picture atomically (to a temporary file in the same folder, then renamed). Needs the program gnuplot.
/// Throws as picture_format and plot_script; cannot_create without gnuplot or if the file cannot be written.
void draw_plot(std::span<const PlotSeries> series, const Measured* measured, const PlotRequest& request,
               const std::filesystem::path& file);

}  // namespace soft::post
