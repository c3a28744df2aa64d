#pragma once
/// Slopes for a cubic Hermite interpolant of values that are known at rows only: those of the parabola through three neighbouring
/// rows, at both ends of the cubic through the four nearest (of the parabola where there are three, or where the values turn
/// within the four and may have a kink). Where an interval would not be monotone they are cut down: to three times the smaller
/// secant (de Boor and Swartz 1977), to 0 at an extremum. The interpolant of a smooth monotone function is of third order, beside
/// an extremum of second. Tested by post/interpolate_test.
#include <span>
#include <vector>

namespace soft::post {

/// Slopes dq/ds at strictly increasing `s` that keep the interpolant of `q` monotone between neighbours.
[[nodiscard]] std::vector<double> monotone_slopes(std::span<const double> s, std::span<const double> q);

}  // namespace soft::post
