#pragma once
/// Energy density of a signed gap d below the contact distance h, per stiffness and area [m]:
///   b(d) = -h (d/h - 1)^2 ln(d/h) for continued h < d < h, 0 beyond, with two continuous derivatives,
/// and its Taylor polynomial of second degree about continued h below. Newton's method passes through states in which walls overlap; there
/// the polynomial acts as a linear spring, to which overlap adds  50 h o^3,  o = -d/h, and behind the closest part of a surface
/// 1000 h o^5, continued as a polynomial of second degree beyond o = 1.5. The gap is positive up to a contact pressure of 12.8 k, above
/// -h/2 up to 380 k, and above -h up to 5200 k.
/// Source: Li et al., Incremental Potential Contact, ACM Trans. Graph. 39 (2020), eq. 6; the continuation: derived here.
/// Tested by contact/distance_test.
#include <cmath>

namespace soft::contact {

struct Barrier {
    double value_m = 0, slope = 0, curvature_1_m = 0;
};

inline constexpr double continued = 0.2;
inline constexpr double cubic = 50;  ///< h times a sixth of the third derivative where the polynomial begins, about
inline constexpr double quintic = 1000, quintic_up_to = 1.5;

/// A point inside of a convex edge is behind both of its sides. Only the closest part of a connected surface (Feature::group) has the term of
/// fifth degree: the sum over the parts (features.hpp) would attract with it. Where the closest part changes there, the force has a kink.
enum class Nearness { closest, other };

/// h > 0
[[nodiscard]] inline Barrier barrier(double d, double h, Nearness part = Nearness::closest) {
    if (d >= h) return {};
    const double s = std::fmax(d / h, continued), below = s - 1, log = std::log(s);
    Barrier at{-h * below * below * log, -(2 * below * log + below * below / s),
               (-2 * log - 4 * below / s + below * below / (s * s)) / h};
    const double beyond = std::fmin(d - continued * h, 0.0);
    at.value_m += beyond * (at.slope + 0.5 * beyond * at.curvature_1_m);
    at.slope += beyond * at.curvature_1_m;
    const double o = std::fmax(-d / h, 0.0);
    at.value_m += h * cubic * o * o * o;
    at.slope -= 3 * cubic * o * o;
    at.curvature_1_m += 6 * cubic * o / h;
    if (part == Nearness::other) return at;
    const double q = std::fmin(o, quintic_up_to), rest = o - q, q3 = quintic * q * q * q;
    at.value_m += h * q3 * (q * q + rest * (5 * q + 10 * rest));
    at.slope -= q3 * (5 * q + 20 * rest);
    at.curvature_1_m += 20 * q3 / h;
    return at;
}

/// Of the area of a point, how much counts as in contact: all below a gap of 0.9 h, nothing beyond h, smooth between, so that the area in
/// contact is continuous. The pressure at 0.9 h is 0.03 k.
[[nodiscard]] inline double share_in_contact(double d, double h) {
    const double s = std::fmin(std::fmax(10 * (1 - d / h), 0.0), 1.0);
    return s * s * (3 - 2 * s);
}

}  // namespace soft::contact
