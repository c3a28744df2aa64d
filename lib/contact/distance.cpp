#include "contact/distance.hpp"

namespace soft::contact {

namespace {

/// |arm| - radius with its derivatives by x, where d arm/dx projects onto the space orthogonal to `axis` (the whole space for axis 0).
Distance radial(const Vector3& arm, const Vector3& axis, double radius_m, model::Side side) {
    const double length = norm(arm), sign = side == model::Side::outside ? 1 : -1;
    Distance found{sign * (length - radius_m), {}, {}};
    if (length == 0) return found;
    for (std::size_t i = 0; i < 3; ++i) found.gradient[i] = sign * arm[i] / length;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            found.hessian[i][j] =
                sign * ((i == j ? 1.0 : 0.0) - axis[i] * axis[j] - arm[i] * arm[j] / (length * length)) / length;
    return found;
}

}  // namespace

Distance distance(const model::Plane& plane, const mesh::Point& x) {
    return {dot(difference(x, plane.point), plane.normal), plane.normal, {}};
}

Distance distance(const model::Cylinder& cylinder, const mesh::Point& x) {
    const Vector3 from = difference(x, cylinder.point);
    return radial(along(from, -dot(from, cylinder.axis), cylinder.axis), cylinder.axis, cylinder.radius_m,
                  cylinder.side);
}

Distance distance(const model::Sphere& sphere, const mesh::Point& x) {
    return radial(difference(x, sphere.center), {}, sphere.radius_m, sphere.side);
}

}  // namespace soft::contact
