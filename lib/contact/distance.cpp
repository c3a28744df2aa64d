#include "contact/distance.hpp"

#include <algorithm>
#include <limits>

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

/// From the box without its rounding: beside it along one direction, along two, or along all.
Distance distance(const model::Box& box, const mesh::Point& x) {
    Vector3 arm{};
    std::size_t beside = 0, side = 0;
    double highest_m = -std::numeric_limits<double>::max();
    for (std::size_t d = 0; d < 3; ++d) {
        const double middle = 0.5 * (box.low[d] + box.high[d]), low = std::min(box.low[d] + box.radius_m, middle),
                     high = std::max(box.high[d] - box.radius_m, middle);
        arm[d] = x[d] - std::clamp(x[d], low, high);
        if (arm[d] != 0) ++beside;
        if (const double height_m = std::max(low - x[d], x[d] - high); height_m > highest_m) {
            highest_m = height_m;
            side = d;
        }
    }
    if (beside < 2) {
        Distance flat{highest_m - box.radius_m, {}, {}};
        flat.gradient[side] = x[side] > 0.5 * (box.low[side] + box.high[side]) ? 1 : -1;
        return flat;
    }
    Vector3 axis{};  // of the edge; none at a corner
    for (std::size_t d = 0; d < 3 && beside == 2; ++d) axis[d] = arm[d] == 0 ? 1 : 0;
    return radial(arm, axis, box.radius_m, model::Side::outside);
}

}  // namespace soft::contact
