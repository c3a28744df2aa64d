/// An infinitely long circular cylinder.
#include "geometry/keys.hpp"
#include "geometry/obstacle.hpp"

namespace soft::geometry {
namespace {

ObstacleSurface build(const ObstacleInput& input) {
    const std::string own = input.path + ".cylinder.";
    const design::Values& values = input.values;
    model::Cylinder cylinder{point_of(values, own + "point"), unit_vector(values, own + "axis"),
                             values.number(own + "radius"), side_of(values, own + "inside")};
    if (input.kinematics == model::Kinematics::axisymmetric) {
        if (!is_parallel(cylinder.axis, 0))
            throw values.refuse(own + "axis", "the axis of a cylinder in an axisymmetric model is x", "use [1, 0, 0]");
        if (cylinder.point[1] != 0 || cylinder.point[2] != 0)
            throw values.refuse(own + "point", "the axis of a cylinder in an axisymmetric model is x",
                                "use y = 0 and z = 0");
    }
    if (input.kinematics == model::Kinematics::plane_strain) {
        if (!is_parallel(cylinder.axis, 2))
            throw values.refuse(own + "axis", "the axis of a cylinder in a plane strain model is parallel to z",
                                "use [0, 0, 1]");
        cylinder.point[2] = 0;
    }
    return cylinder;
}

}  // namespace

ObstacleShape cylinder_obstacle() {
    using design::Kind;
    return {{"cylinder",
             {vector_key("cylinder.point", Kind::length, "a point of the axis: [x, y, z]"),
              vector_key("cylinder.axis", Kind::ratio, "direction of the axis: [x, y, z]"),
              value_key("cylinder.radius", Kind::length, design::above(0), "radius of the infinitely long cylinder"),
              inside_key("cylinder")}},
            ObstacleStorage::design,
            build};
}

}  // namespace soft::geometry
