#include "geometry/fiber_keys.hpp"

#include <numbers>

namespace soft::geometry {

std::vector<design::Key> fiber_keys(const std::string& prefix, const FiberDefaults& defaults) {
    const bool optional = defaults.k1.starts_with("0 ");
    return {
        {.path = prefix + ".angle",
         .kind = design::Kind::angle,
         .fallback = defaults.angle,
         .meaning = std::string{"angle between the fibres and the axis x"} + defaults.angle_meaning,
         .min = 0,
         .max = 0.5 * std::numbers::pi},
        {.path = prefix + ".families",
         .kind = design::Kind::count,
         .fallback = "2",
         .meaning =
             "2: fibres at plus and minus the angle, as in a braid; 1: a single helix, which twists (model: solid)",
         .min = 1,
         .max = 2},
        {.path = prefix + ".k1",
         .kind = design::Kind::pressure,
         .fallback = defaults.k1,
         .meaning =
             std::string{
                 "stiffness of each family at small stretch, k1/(2 k2) [exp(k2 (I4 - 1)^2) - 1] per volume of the layer"} +
             (optional ? "; 0 = no fibres" : ""),
         .min = 0,
         .min_open = !optional},
        {.path = prefix + ".k2",
         .kind = design::Kind::ratio,
         .fallback = "1",
         .meaning = "rate at which the fibres stiffen",
         .min = 0,
         .min_open = true}};
}

model::Fibers fibers_of(const design::Values& values, const std::string& prefix) {
    return {values.number(prefix + ".angle"), values.number(prefix + ".k1"), values.number(prefix + ".k2"),
            values.count(prefix + ".families")};
}

}  // namespace soft::geometry
