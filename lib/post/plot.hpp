#pragma once
/// Picture of the path: its load (pressure, traction or load factor) over the first output (over the cavity volume where a
/// case measures none), the rows as circles on the smooth curve of post::Path, the unstable part dashed, limit points as
/// filled triangles with their load, bifurcations as filled squares with theirs. Nothing depends on colour.
/// Held by post/plot_test.
#include <filesystem>
#include <string>

#include "post/curve.hpp"
#include "solution/path.hpp"

namespace soft::post {

struct PlotText {
    std::string title;  ///< one line above the picture; may be empty
};

enum class PictureFormat { svg, png };

/// By the ending of the name; Error(usage) for another one.
[[nodiscard]] PictureFormat picture_format(const std::filesystem::path& file);

/// The gnuplot script that writes the picture to gnuplot's stdout. Error(bad_input) where the curve has neither an output nor a volume.
/// Of `end` the limit points and bifurcations are drawn.
[[nodiscard]] std::string plot_script(const Curve& curve, const solution::PathEnd& end, const PlotText& text,
                                      PictureFormat format);

/// Writes the picture (temporary name in the same folder, renamed when whole). Needs the program gnuplot.
/// Errors: as picture_format and plot_script; cannot_create without gnuplot or where the file cannot be written.
void draw_plot(const Curve& curve, const solution::PathEnd& end, const PlotText& text,
               const std::filesystem::path& file);

}  // namespace soft::post
