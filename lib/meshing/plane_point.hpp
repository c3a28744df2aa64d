#pragma once
/// Points of the plane of a section [m], and vector operations on them.
#include <array>
#include <cmath>

#include "math/vector.hpp"

namespace soft::meshing {

using soft::along, soft::cross, soft::dot, soft::norm;  // of three components

using PlanePoint = std::array<double, 2>;

[[nodiscard]] inline PlanePoint minus(PlanePoint a, PlanePoint b) { return {a[0] - b[0], a[1] - b[1]}; }
[[nodiscard]] inline double dot(PlanePoint a, PlanePoint b) { return a[0] * b[0] + a[1] * b[1]; }
/// Twice the area between them, positive where b is to the left of a.
[[nodiscard]] inline double cross(PlanePoint a, PlanePoint b) { return a[0] * b[1] - a[1] * b[0]; }
[[nodiscard]] inline double length(PlanePoint a) { return std::hypot(a[0], a[1]); }

}  // namespace soft::meshing
