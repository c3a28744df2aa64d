#pragma once
/// Points of an obstacle in the coordinates of the mesh. Private to the module. Tested by geometry/obstacle_test.
#include <vector>

#include "model/case.hpp"

namespace soft::geometry {

/// Points of the obstacle: the obstacle contains the ball of this radius about the point.
struct OwnPoint {
    mesh::Point point;
    double radius_m;
};
/// The centre of a sphere, points on the axis of a cylinder and on the edges of a box, vertices and points on edges of a faceted obstacle (up
/// to 5000); those in the bounding box of the mesh, and on its side of the mirror planes. None for a plane and where the actuator is inside.
[[nodiscard]] std::vector<OwnPoint> own_points(const model::Obstacle& obstacle, const model::Case& model);

}  // namespace soft::geometry
