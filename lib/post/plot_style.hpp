#pragma once
/// What all plots have in common: size, fonts, axes. Lines of a gnuplot script. Tested by post/plot_test.
#include <string>

#include "post/plot.hpp"

namespace soft::post {

/// The terminal for so many panels side by side. SVG and PDF scale; the PNG has twice the pixels so that it prints well.
[[nodiscard]] std::string terminal(PictureFormat format, int panels = 1);

/// Grid, borders and tics.
[[nodiscard]] std::string axes_style();

}  // namespace soft::post
