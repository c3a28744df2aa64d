#pragma once
/// Slopes for a cubic Hermite interpolant of values known at rows only. Interior slopes are those of the parabola through three
/// neighbouring rows. End slopes are those of the cubic through the four nearest rows (of the parabola if there are only three rows, or
/// if the values are not monotonic within the four and may have a kink). Slopes are limited to keep each interval monotone: to three
/// times the smaller secant (de Boor and Swartz 1977), to 0 at an extremum. The interpolant of a smooth monotone function is third-order
/// accurate, next to an extremum second-order. Tested by post/interpolate_test.
#include <span>
#include <vector>

namespace soft::post {

/// Slopes dq/ds at strictly increasing `s` that keep the interpolant of `q` monotone between neighbours.
[[nodiscard]] std::vector<double> monotone_slopes(std::span<const double> s, std::span<const double> q);

}  // namespace soft::post
