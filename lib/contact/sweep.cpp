#include "contact/sweep.hpp"

#include <algorithm>
#include <cmath>

#include "math/vector.hpp"

namespace soft::contact {

Sweep sweep(const std::function<Distance(const mesh::Point&)>& distance, const mesh::Point& from,
            const mesh::Point& to) {
    constexpr double least_step = 1.0 / 64;  // of the way
    const Vector3 way = difference(to, from);
    const double length = norm(way);
    Sweep result;
    if (length == 0) return result;
    Distance here = distance(from);
    Vector3 outward = here.gradient;
    bool is_inside = here.value_m < 0;
    if (is_inside) result = {0, -here.value_m};
    for (double at = 0; at < 1;) {
        const double next_at = std::min(1.0, at + std::max(std::abs(here.value_m) / length, least_step));
        const Distance next = distance(along(from, next_at, way));
        const bool passes_unseen = here.value_m >= 0 && next.value_m >= 0 &&
                                   are_opposite(here.gradient, next.gradient) &&
                                   here.value_m + next.value_m <= (next_at - at) * length;
        if (!is_inside && result.entry == 1 && (next.value_m < 0 || passes_unseen)) {
            result.entry = std::min(next_at, at + here.value_m / length);
            outward = here.gradient;
        }
        result.leaves = result.leaves || passes_unseen || (is_inside && next.value_m >= 0);
        is_inside = next.value_m < 0;
        result.deepest_m = std::max(result.deepest_m, -next.value_m);
        here = next;
        at = next_at;
    }
    result.to_other_side = result.entry < 1 && are_opposite(outward, here.gradient);
    return result;
}

}  // namespace soft::contact
