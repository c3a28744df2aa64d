/// A sphere.
#include "geometry/keys.hpp"
#include "geometry/obstacle.hpp"

namespace soft::geometry {
namespace {

ObstacleSurface build(const ObstacleInput& input) {
    const std::string own = input.path + ".sphere.";
    const design::Values& values = input.values;
    const model::Sphere sphere{point_of(values, own + "center"), values.number(own + "radius"),
                               side_of(values, own + "inside")};
    if (input.kinematics == model::Kinematics::axisymmetric && (sphere.center[1] != 0 || sphere.center[2] != 0))
        throw values.refuse(own + "center", "the center of a sphere in an axisymmetric model is on the axis x",
                            "use y = 0 and z = 0");
    if (input.kinematics == model::Kinematics::plane_strain)
        throw values.refuse(own + "center", "a plane strain model has no spheres", "use a cylinder along z");
    return sphere;
}

}  // namespace

ObstacleShape sphere_obstacle() {
    using design::Kind;
    return {{"sphere",
             {vector_key("sphere.center", Kind::length, "center: [x, y, z]"),
              value_key("sphere.radius", Kind::length, design::above(0), "radius"), inside_key("sphere")}},
            ObstacleStorage::design,
            build};
}

}  // namespace soft::geometry
