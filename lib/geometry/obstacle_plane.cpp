/// A half space. The actuator is on the side to which the normal points.
#include "geometry/keys.hpp"
#include "geometry/obstacle.hpp"

namespace soft::geometry {
namespace {

ObstacleSurface build(const ObstacleInput& input) {
    const std::string point = input.path + ".plane.point", normal = input.path + ".plane.normal";
    model::Plane plane{point_of(input.values, point), unit_vector(input.values, normal)};
    if (input.kinematics == model::Kinematics::axisymmetric) {
        if (!is_parallel(plane.normal, 0))
            throw input.values.refuse(normal, "a plane in an axisymmetric model is normal to x",
                                      "use [1, 0, 0] or [-1, 0, 0]");
        plane.point[1] = plane.point[2] = 0;
    }
    if (input.kinematics == model::Kinematics::plane_strain) {
        if (plane.normal[2] != 0)
            throw input.values.refuse(normal, "a plane in a plane strain model is parallel to z", "use [x, y, 0]");
        plane.point[2] = 0;
    }
    return plane;
}

}  // namespace

ObstacleShape plane_obstacle() {
    using design::Kind;
    return {{"plane",
             {vector_key("plane.point", Kind::length, "a point of the plane: [x, y, z]"),
              vector_key("plane.normal", Kind::ratio, "normal of the plane, to the side of the actuator: [x, y, z]")}},
            ObstacleStorage::design,
            build};
}

}  // namespace soft::geometry
