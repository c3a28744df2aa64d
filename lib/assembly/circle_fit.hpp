#pragma once
/// The circle that fits weighted points in a plane best, as A (u^2 + v^2) + B u + C v + D = 0 with B^2 + C^2 - 4 A D = 1 and the
/// least sum of squares: a straight line (A = 0) is nothing special, and points on an arc are met exactly.
/// Source: V. Pratt, Computer Graphics 21 (1987) 145. Tested by assembly/face_shape_test.
#include <array>
#include <span>
#include <vector>

namespace soft::assembly {

using PlanePoint = std::array<double, 2>;

/// Curvature 2 A [1/m] with its derivatives by the points (`gradient` is overwritten; nullptr: not wanted). Positive where the
/// middle of the circle is to the left of the way from point to point in the order `along`, however often it goes round.
/// NaN for points that are all on one spot.
[[nodiscard]] double fitted_curvature(std::span<const PlanePoint> points, std::span<const double> weights,
                                      std::span<const std::size_t> along, std::vector<PlanePoint>* gradient);

}  // namespace soft::assembly
