#pragma once
/// Lines that show the rigid obstacles of a case in pictures: grids on planes, circles and generators of cylinders and spheres, edges of
/// faceted surfaces. An obstacle of a section of revolution is revolved unless the section itself is drawn. Used by view/picture.hpp.
/// Tested by view/obstacle_lines_test.
#include <array>
#include <span>
#include <vector>

#include "model/case.hpp"
#include "view/skin.hpp"

namespace soft::view {

/// A box with edges along the axes.
struct Window {
    Point low{}, high{};
};

using Line = std::array<Point, 2>;

/// The lines inside the window, as short segments. `shifts`: displacement of each obstacle. Obstacles are mirrored with the actuator.
[[nodiscard]] std::vector<Line> obstacle_lines(const model::Case& model, std::span<const Vector3> shifts,
                                               const Window& window, Extent extent);

/// Displacement of each obstacle at a row of a static path. `reached`: load factor at the end of each stage before that of the row.
[[nodiscard]] std::vector<Vector3> obstacle_shifts(const model::Case& model, int stage, double load_factor,
                                                   std::span<const double> reached);

}  // namespace soft::view
