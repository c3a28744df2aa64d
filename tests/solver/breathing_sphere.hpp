#pragma once
/// The equation of motion of an incompressible thick sphere: r^3 - a^3 = R^3 - A^3 leaves one unknown, the inner radius a.
/// Its kinetic energy is m(a)/2 a'^2 with m = 4 pi rho a^4 (1/a - 1/b), and Lagrange's equation
///     m a'' + m'(a)/2 a'^2 = 4 pi a^2 (p - p_elastic(a/A)),     b^3 = B^3 + a^3 - A^3,   db/da = a^2 / b^2.
/// Derived here; independent of the library. Used by solver/dynamics_test and the verification.
#include <cmath>
#include <numbers>
#include <vector>

namespace soft::solver {

struct BreathingSphere {
    double inner_m, outer_m, density_kg_m3;
};

/// a/A at `count` equally spaced times of the duration, from rest under a constant pressure; `elastic_Pa(a/A)` is that of the wall.
/// Fourth-order Runge-Kutta method with 4000 steps or slightly more.
template <class Elastic>
[[nodiscard]] std::vector<double> breathing_stretches(const BreathingSphere& sphere, double pressure_Pa,
                                                      Elastic&& elastic_Pa, double duration_s, int count) {
    const double A = sphere.inner_m, B = sphere.outer_m, weight = 4.0 * std::numbers::pi * sphere.density_kg_m3;
    const auto acceleration = [&](double a, double v) {
        const double b = std::cbrt(B * B * B + a * a * a - A * A * A), a2 = a * a, b2 = b * b;
        const double m = weight * (a2 * a - a2 * a2 / b);
        const double slope = weight * (3.0 * a2 - 4.0 * a2 * a / b + a2 * a2 * a2 / (b2 * b2));
        return (4.0 * std::numbers::pi * a2 * (pressure_Pa - elastic_Pa(a / A)) - 0.5 * slope * v * v) / m;
    };
    const int steps = (4000 + count - 1) / count;  // to each time
    const double h = duration_s / (count * steps);
    std::vector<double> stretches;
    double a = A, v = 0;
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < steps; ++j) {
            const double a1 = v, v1 = acceleration(a, v), a2 = v + 0.5 * h * v1,
                         v2 = acceleration(a + 0.5 * h * a1, a2);
            const double a3 = v + 0.5 * h * v2, v3 = acceleration(a + 0.5 * h * a2, a3), a4 = v + h * v3,
                         v4 = acceleration(a + h * a3, a4);
            a += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
            v += h / 6.0 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
        }
        stretches.push_back(a / A);
    }
    return stretches;
}

}  // namespace soft::solver
