#pragma once
/// Common style of all plots (size, fonts, axes) as lines of a gnuplot script. Tested by post/plot_test.
#include <string>

#include "post/plot.hpp"

namespace soft::post {

/// The terminal for the given number of panels side by side. SVG and PDF are scalable; PNG has twice the pixels for printing.
[[nodiscard]] std::string terminal(PictureFormat format, int panels = 1);

/// Grid, borders and tics.
[[nodiscard]] std::string axes_style();

}  // namespace soft::post
