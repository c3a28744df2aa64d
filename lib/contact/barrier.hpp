#pragma once
/// Energy density of a signed gap d below the contact distance h, per stiffness and area [m]:
///   b(d) = -h (d/h - 1)^2 ln(d/h) for continued h < d < h, 0 beyond, with two continuous derivatives,
/// and its Taylor polynomial of second degree about continued h below. Newton's method passes through states in which walls overlap; there
/// the polynomial acts as a linear spring, to which overlap adds  -stiffening d^3 / (6 h^2).  The gap is positive up to a contact pressure of
/// 12.8 k, and above -h up to 200 k.
/// Source: Li et al., Incremental Potential Contact, ACM Trans. Graph. 39 (2020), eq. 6; the continuation: derived here.
/// Tested by contact/distance_test.
#include <cmath>

namespace soft::contact {

struct Barrier {
    double value_m = 0, slope = 0, curvature_1_m = 0;
};

inline constexpr double continued = 0.2;
inline constexpr double stiffening = 300;  ///< about the third derivative where the polynomial begins

/// h > 0
[[nodiscard]] inline Barrier barrier(double d, double h) {
    if (d >= h) return {};
    const double s = std::fmax(d / h, continued), below = s - 1, log = std::log(s);
    Barrier at{-h * below * below * log, -(2 * below * log + below * below / s),
               (-2 * log - 4 * below / s + below * below / (s * s)) / h};
    const double beyond = std::fmin(d - continued * h, 0.0);
    at.value_m += beyond * (at.slope + 0.5 * beyond * at.curvature_1_m);
    at.slope += beyond * at.curvature_1_m;
    const double overlap = std::fmin(d / h, 0.0), third = stiffening * overlap;
    at.value_m -= h * overlap * overlap * third / 6;
    at.slope -= overlap * third / 2;
    at.curvature_1_m -= third / h;
    return at;
}

}  // namespace soft::contact
