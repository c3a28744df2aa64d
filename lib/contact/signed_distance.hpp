#pragma once
/// Signed distance from an obstacle of any kind, in the coordinates of the mesh. Tested by geometry/obstacle_test and contact/contact_test.
#include <functional>

#include "contact/distance.hpp"

namespace soft::contact {

/// Of a point from the surface, negative where the actuator must not be. A faceted obstacle must be closed, but a section may be open at
/// the axis, and an extruded profile at its ends.
using SignedDistance = std::function<double(const mesh::Point& point)>;
[[nodiscard]] SignedDistance signed_distance(const model::Obstacle& obstacle);

/// The same with the gradient; of a faceted obstacle without second derivatives.
[[nodiscard]] std::function<Distance(const mesh::Point& point)> distance_with_gradient(const model::Obstacle& obstacle);

}  // namespace soft::contact
