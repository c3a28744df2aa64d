#pragma once
/// Signed distance of a point from a smooth obstacle, positive on the actuator's side, with its first and second derivatives by the
/// point. Undefined on the axis of a cylinder and in the centre of a sphere, where the derivatives are zero. The second derivatives of a box jump
/// where its edges begin; deeper in it than their radius also the first.
/// Tested by contact/distance_test.
#include <array>

#include "model/obstacle.hpp"

namespace soft::contact {

struct Distance {
    double value_m = 0;
    Vector3 gradient{};                ///< unit vector
    std::array<Vector3, 3> hessian{};  ///< [1/m], symmetric
};

[[nodiscard]] Distance distance(const model::Plane& plane, const mesh::Point& x);
[[nodiscard]] Distance distance(const model::Cylinder& cylinder, const mesh::Point& x);
[[nodiscard]] Distance distance(const model::Sphere& sphere, const mesh::Point& x);
[[nodiscard]] Distance distance(const model::Box& box, const mesh::Point& x);

}  // namespace soft::contact
