#pragma once
/// The thick sphere of sample_cases.hpp in closed form.
#include <cmath>
#include <numbers>

#include "../fem/sample_cases.hpp"
#include "model/path.hpp"

namespace soft::solver {

/// Thick incompressible neo-Hookean sphere, B/A = 2: p/mu as a function of l_a (spec: closed form; derived from
/// p = int_a^b 2 (sigma_theta - sigma_r)/r dr).
inline double sphere_pressure(double la) {
    const double lb = std::cbrt(1.0 + (la * la * la - 1.0) / 8.0);
    const auto f = [](double l) { return 2.0 / l + 0.5 / (l * l * l * l); };
    return f(lb) - f(la);
}
inline constexpr double sphere_limit = 0.816424;  // at l_a = 1.8281

inline constexpr double sphere_cavity_m3 = 4.0 / 3.0 * std::numbers::pi * 1e-6;

inline double inner_stretch(const model::Step& step) { return std::cbrt(*step.volume_m3 / sphere_cavity_m3); }

}  // namespace soft::solver
