#include "membrane_formula.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace soft::verification {
namespace {

/// Tension along the first direction, for mu h = 1.
double tension(double l1, double l2) { return l1 / l2 - 1 / std::pow(l1 * l2, 3); }

/// The meridional stretch for a given tension; it increases with the tension.
double meridian_stretch(double tension1, double l2, double guess) {
    double l1 = guess;
    for (int i = 0; i < 40; ++i) {
        const double step = (tension(l1, l2) - tension1) / (1 / l2 + 3 / (l1 * std::pow(l1 * l2, 3)));
        l1 -= step;
        if (std::abs(step) < 1e-15) break;
    }
    return l1;
}

struct Integrated {
    double rim_radius, deflection, mean_deflection;
    bool upright;  ///< the slope has reached a right angle
};

/// For unit radius and mu h = 1; `pressure` is p a/(mu h).
Integrated integrate(double apex_stretch, double pressure) {
    constexpr int steps = 500;
    struct State {
        double r, tension1;
    };
    struct Rate {
        double r, tension1, fall;
    };
    bool upright = false;
    double guess = apex_stretch;
    const auto rate = [&](double R, const State& s) -> Rate {
        const double l2 = s.r / R, sine = pressure * s.r / (2 * s.tension1);
        if (upright || !(s.tension1 > 0 && sine < 1)) {
            upright = true;
            return {0, 0, 0};
        }
        const double l1 = guess = meridian_stretch(s.tension1, l2, guess);
        const double cosine = std::sqrt(1 - sine * sine);
        return {l1 * cosine, (tension(l2, l1) - s.tension1) * l1 * cosine / s.r, l1 * sine};
    };
    constexpr double step = 1.0 / steps;
    // First step: the apex is a sphere, l1 = l2, T1 = T2, to second order in R.
    State s{apex_stretch * step, tension(apex_stretch, apex_stretch)};
    double fall = 0.5 * apex_stretch * pressure * s.r / (2 * s.tension1) * step, moment = 0;
    for (int i = 1; i < steps && !upright; ++i) {
        const double R = i * step;
        const Rate a = rate(R, s);
        const Rate b = rate(R + 0.5 * step, {s.r + 0.5 * step * a.r, s.tension1 + 0.5 * step * a.tension1});
        const Rate c = rate(R + 0.5 * step, {s.r + 0.5 * step * b.r, s.tension1 + 0.5 * step * b.tension1});
        const Rate d = rate(R + step, {s.r + step * c.r, s.tension1 + step * c.tension1});
        fall += step / 6 * (a.fall + 2 * b.fall + 2 * c.fall + d.fall);
        // Mean of w over the area: int w 2 R dR = int -w' R^2 dR, as w = 0 at the rim.
        const double middle = R + 0.5 * step, end = R + step;
        moment += step / 6 * (a.fall * R * R + 2 * (b.fall + c.fall) * middle * middle + d.fall * end * end);
        s = {s.r + step / 6 * (a.r + 2 * b.r + 2 * c.r + d.r),
             s.tension1 + step / 6 * (a.tension1 + 2 * b.tension1 + 2 * c.tension1 + d.tension1)};
    }
    return {s.r, fall, moment, upright};
}

}  // namespace

MembraneState membrane_at(const Membrane& membrane, double apex_stretch) {
    // Without pressure the sheet is flat and its rim is at apex_stretch; with pressure the radius of the rim decreases.
    double low = 0, high = 1;
    const auto too_much = [&](double pressure) {
        const Integrated sheet = integrate(apex_stretch, pressure);
        return sheet.upright || sheet.rim_radius < 1;
    };
    while (!too_much(high)) high *= 2;
    for (int i = 0; i < 45; ++i) (too_much(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
    const Integrated sheet = integrate(apex_stretch, low);
    const double a = membrane.radius_m;
    return {low * membrane.mu_Pa * membrane.thickness_m / a, a * sheet.deflection, a * sheet.mean_deflection};
}

MembraneState membrane_deflected(const Membrane& membrane, double mean_deflection_m) {
    double low = 1 + 1e-9, high = 3;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (membrane_at(membrane, middle).mean_deflection_m > mean_deflection_m ? high : low) = middle;
    }
    return membrane_at(membrane, low);
}

double hencky_deflection(double q, double poisson) {
    // Radial force N = E h q^(2/3)/4 sum b_2n rho^2n, deflection q^(1/3) sum a_2n (1 - rho^(2n+2)); all follow from b_0, and
    // b_0 from the fixed rim: sum (2n + 1 - poisson) b_2n = 0.
    const auto edge = [&](double b) {
        const std::array<double, 8> terms{b,
                                          -1 / std::pow(b, 2),
                                          -2 / (3 * std::pow(b, 5)),
                                          -13 / (18 * std::pow(b, 8)),
                                          -17 / (18 * std::pow(b, 11)),
                                          -37 / (27 * std::pow(b, 14)),
                                          -1205 / (567 * std::pow(b, 17)),
                                          -219241 / (63504 * std::pow(b, 20))};
        double sum = 0;
        for (std::size_t n = 0; n < terms.size(); ++n) sum += (2.0 * static_cast<double>(n) + 1 - poisson) * terms[n];
        return sum;
    };
    double low = 1.3, high = 4;
    for (int i = 0; i < 60; ++i) (edge(0.5 * (low + high)) > 0 ? high : low) = 0.5 * (low + high);
    const double b = low;
    return std::cbrt(q) * (1 / b + 1 / (2 * std::pow(b, 4)) + 5 / (9 * std::pow(b, 7)) + 55 / (72 * std::pow(b, 10)) +
                           7 / (6 * std::pow(b, 13)) + 205 / (108 * std::pow(b, 16)) +
                           17051 / (5292 * std::pow(b, 19)) + 2864485 / (508032 * std::pow(b, 22)));
}

}  // namespace soft::verification
