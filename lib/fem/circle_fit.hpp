#pragma once
/// Least-squares circle through weighted points in a plane, as A (u^2 + v^2) + B u + C v + D = 0 with B^2 + C^2 - 4 A D = 1 and the
/// smallest sum of squares. A straight line (A = 0) is not a special case, and points on an arc are fitted exactly.
/// Source: V. Pratt, Computer Graphics 21 (1987) 145. Tested by fem/face_shape_test.
#include <array>
#include <span>
#include <vector>

namespace soft::fem {

using PlanePoint = std::array<double, 2>;

/// Curvature 2 A [1/m] with its derivatives with respect to the points (`gradient` is overwritten; nullptr: not computed). Positive
/// where the centre of the circle is to the left of the polyline through the points in the order `along`, however often it winds.
/// NaN for coincident points.
[[nodiscard]] double fitted_curvature(std::span<const PlanePoint> points, std::span<const double> weights,
                                      std::span<const std::size_t> along, std::vector<PlanePoint>* gradient);

}  // namespace soft::fem
