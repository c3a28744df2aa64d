#pragma once
/// Volume of the convex hull of points [m^3], by CGAL; 0 for coplanar points. Tested by surface/hull_test.
#include <span>

#include "mesh/mesh.hpp"

namespace soft::surface {

[[nodiscard]] double hull_volume_m3(std::span<const mesh::Point> points);

}  // namespace soft::surface
