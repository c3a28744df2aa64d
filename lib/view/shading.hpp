#pragma once
/// Light on a surface: smooth where it is smooth, with a step at its edges. For view/picture.hpp.
#include <array>
#include <span>
#include <vector>

#include "view/camera.hpp"
#include "view/skin.hpp"

namespace soft::view {

/// Light at the corners of each face, 0 to 1: Lambert's law for a lamp over the left shoulder of the eye. The normal at
/// a corner is the mean over the faces there that are not beyond an edge of 45 degrees. A face seen from behind is lit
/// alike.
[[nodiscard]] std::vector<std::array<double, 4>> corner_light(std::span<const Face> faces,
                                                              std::span<const Point> positions, const Screen& screen);

}  // namespace soft::view
