#include "beam_formula.hpp"

#include <array>
#include <cmath>

namespace soft::verification {
namespace {

constexpr double first_root = 1.875104068711961;  // of cos x cosh x = -1
constexpr double shear_factor = 5.0 / 6.0;

/// w, phi, moment E I phi' and shear force k G A (w' - phi), per depth.
using Section = std::array<double, 4>;

Section end_of(const Beam& beam, Section y, double omega) {
    const double A = beam.height_m, I = std::pow(beam.height_m, 3) / 12.0, square = omega * omega;
    const auto slope = [&](const Section& s) -> Section {
        return {s[1] + s[3] / (shear_factor * beam.shear_modulus_Pa * A), s[2] / (beam.modulus_Pa * I),
                -s[3] - beam.density_kg_m3 * I * square * s[1], -beam.density_kg_m3 * A * square * s[0]};
    };
    const auto moved = [](Section s, const Section& k, double h) {
        for (std::size_t i = 0; i < s.size(); ++i) s[i] += h * k[i];
        return s;
    };
    constexpr int steps = 400;  // Runge's fourth-order method
    const double h = beam.length_m / steps;
    for (int i = 0; i < steps; ++i) {
        const auto a = slope(y), b = slope(moved(y, a, 0.5 * h)), c = slope(moved(y, b, 0.5 * h)),
                   d = slope(moved(y, c, h));
        for (std::size_t k = 0; k < y.size(); ++k) y[k] += h / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]);
    }
    return y;
}

/// Zero if the moment and the shear force can vanish at the free end.
double determinant(const Beam& beam, double omega) {
    const auto by_moment = end_of(beam, {0, 0, 1, 0}, omega);
    const auto by_force = end_of(beam, {0, 0, 0, 1.0 / beam.length_m}, omega);
    return by_moment[2] * by_force[3] - by_moment[3] * by_force[2];
}

}  // namespace

double Beam::slender_frequency() const {
    return std::pow(first_root / length_m, 2) * height_m * std::sqrt(modulus_Pa / (12.0 * density_kg_m3));
}

double Beam::frequency() const {
    double low = 0.5 * slender_frequency(), high = 1.001 * slender_frequency();
    const bool sign = determinant(*this, low) > 0.0;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        ((determinant(*this, middle) > 0.0) == sign ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace soft::verification
