#pragma once
/// Distances from an obstacle in the coordinates of the mesh. Private to the module. Tested by geometry/obstacle_test.
#include <functional>
#include <vector>

#include "model/case.hpp"

namespace soft::geometry {

/// Signed distance of a point from the surface of the obstacle, negative where the actuator must not be. For a faceted obstacle of
/// any closed surface; a section may be open at the axis, and an extruded profile at its ends.
using SignedDistance = std::function<double(const mesh::Point& point)>;
[[nodiscard]] SignedDistance signed_distance(const model::Obstacle& obstacle);

/// Points of the obstacle: the obstacle contains the ball of this radius about the point.
struct OwnPoint {
    mesh::Point point;
    double radius_m;
};
/// The centre of a sphere, points on the axis of a cylinder, vertices and points on edges of a faceted obstacle (up to 5000); those in the bounding
/// box of the mesh, and on its side of the mirror planes. None for a plane and where the actuator is inside.
[[nodiscard]] std::vector<OwnPoint> own_points(const model::Obstacle& obstacle, const model::Case& model);

}  // namespace soft::geometry
