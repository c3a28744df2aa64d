#pragma once
/// The straight way of a point past an obstacle, in small steps: none is longer than the distance from the obstacle, as far as that is
/// possible, and two neighbouring points on opposite sides are seen. Private to the module. Tested by contact/obstacle_test.
#include <functional>

#include "contact/distance.hpp"

namespace soft::contact {

struct Sweep {
    /// Share of the way at which the point enters the obstacle; 0 where it begins inside, 1 where it stays outside.
    double entry = 1;
    double deepest_m = 0;  ///< depth in the obstacle
    bool leaves = false;   ///< it enters and leaves
    /// It ends, inside or outside, where the nearest surface faces the opposite way of that where it entered.
    bool to_other_side = false;
};

/// Whether two surfaces are two sides of an obstacle, by their unit normals: not those of a sharp edge.
[[nodiscard]] inline bool are_opposite(const Vector3& a, const Vector3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] < -0.7;
}

/// `distance`: of the obstacle, in whose coordinates the positions are.
[[nodiscard]] Sweep sweep(const std::function<Distance(const mesh::Point&)>& distance, const mesh::Point& from,
                          const mesh::Point& to);

}  // namespace soft::contact
