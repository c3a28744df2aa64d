#pragma once
/// Smooth shading of a surface with discontinuities at its feature edges. Used by view/picture.hpp.
#include <array>
#include <span>
#include <vector>

#include "view/camera.hpp"
#include "view/skin.hpp"

namespace soft::view {

/// Light at the corners of each face, 0 to 1: Lambert's law for a lamp to the upper left of the eye. The normal at a corner is
/// the mean over the faces at that vertex whose normals differ by less than 45 degrees. Back faces are lit in the same way.
[[nodiscard]] std::vector<std::array<double, 4>> corner_light(std::span<const Face> faces,
                                                              std::span<const Point> positions, const Screen& screen);

}  // namespace soft::view
