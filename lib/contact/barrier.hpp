#pragma once
/// Energy density of a signed gap d below the contact distance h, per stiffness and undeformed area [m]:
///   b(d) = -h (d/h - 1)^2 ln(d/h) for continued h < d < h, 0 beyond, with two continuous derivatives,
/// and its Taylor polynomial of second degree about continued h below. Newton's method passes through states in which walls overlap; there
/// the polynomial acts as a linear spring, to which overlap adds  h (-300 (d/h)^3 - 600 (d/h)^5).  The gap is positive up to a contact pressure
/// of 12.8 k, and above -h up to 3950 k. Pressures on the undeformed area are that large where walls of large stretch press with many times
/// their initial modulus on an area that has grown 50 to 100 times.
/// Source: Li et al., Incremental Potential Contact, ACM Trans. Graph. 39 (2020), eq. 6; the continuation: derived here.
/// Tested by contact/distance_test.
#include <cmath>

namespace soft::contact {

struct Barrier {
    double value_m = 0, slope = 0, curvature_1_m = 0;
};

inline constexpr double continued = 0.2;
inline constexpr double cubic = 300, quintic = 600;

/// h > 0
[[nodiscard]] inline Barrier barrier(double d, double h) {
    if (d >= h) return {};
    const double s = std::fmax(d / h, continued), below = s - 1, log = std::log(s);
    Barrier at{-h * below * below * log, -(2 * below * log + below * below / s),
               (-2 * log - 4 * below / s + below * below / (s * s)) / h};
    const double beyond = std::fmin(d - continued * h, 0.0);
    at.value_m += beyond * (at.slope + 0.5 * beyond * at.curvature_1_m);
    at.slope += beyond * at.curvature_1_m;
    const double overlap = std::fmin(d / h, 0.0), square = overlap * overlap;
    at.value_m -= h * overlap * square * (cubic + quintic * square);
    at.slope -= square * (3 * cubic + 5 * quintic * square);
    at.curvature_1_m -= overlap * (6 * cubic + 20 * quintic * square) / h;
    return at;
}

}  // namespace soft::contact
