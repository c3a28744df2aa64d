#pragma once
/// Lines that show the rigid obstacles of a case in pictures: grids on planes, circles and generators of cylinders and spheres, outlines of
/// boxes, edges of faceted surfaces. An obstacle of a section of revolution is revolved unless the section itself is drawn. Used by view/picture.hpp.
/// Tested by view/obstacle_lines_test.
#include <array>
#include <vector>

#include "model/case.hpp"
#include "view/skin.hpp"

namespace soft::view {

/// A box with edges along the axes.
struct Window {
    Point low{}, high{};
};

using Line = std::array<Point, 2>;

/// The lines of an obstacle inside the window, as short segments, displaced by `shift`. Obstacles are mirrored with the actuator.
[[nodiscard]] std::vector<Line> obstacle_lines(const model::Case& model, const model::Obstacle& obstacle,
                                               const Vector3& shift, const Window& window, Extent extent);

}  // namespace soft::view
