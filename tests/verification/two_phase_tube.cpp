#include "two_phase_tube.hpp"

#include <cmath>
#include <numbers>

namespace soft::verification {
namespace {

ExtraStress extra_stress_of(const GentTube& tube) {
    return [tube](const Triple& l) {
        const double I1 = l[0] * l[0] + l[1] * l[1] + l[2] * l[2];
        const double modulus = tube.mu_Pa * tube.jm / (tube.jm - (I1 - 3));
        return Triple{modulus * l[0] * l[0], modulus * l[1] * l[1], modulus * l[2] * l[2]};
    };
}

/// Locking stretch of the inner wall at an axial stretch of 1.
double locking_stretch(const GentTube& tube) { return std::sqrt(tube.jm + 2); }

}  // namespace

EvenTube even_tube(const GentTube& tube, double inner_stretch) {
    const double max_axial = std::min(3.0, 0.999 * std::sqrt(tube.jm + 3 - inner_stretch * inner_stretch));
    const auto state = closed_tube(extra_stress_of(tube), tube.inner_m, tube.outer_m, inner_stretch, max_axial);
    const double lz = state.axial_stretch;
    const Cylinder cylinder{tube.inner_m, tube.outer_m, lz};
    const double energy_J_m = integral(
        [&](double R) {
            const double hoop = cylinder.deformed_radius_m(R, inner_stretch) / R, radial = 1 / (lz * hoop);
            const double I1 = lz * lz + hoop * hoop + radial * radial;
            return -0.5 * tube.mu_Pa * tube.jm * std::log(1 - (I1 - 3) / tube.jm) * 2 * std::numbers::pi * R;
        },
        tube.inner_m, tube.outer_m);
    const double bore_m = tube.inner_m * inner_stretch;
    return {inner_stretch, lz, state.pressure_Pa, std::numbers::pi * bore_m * bore_m * lz, energy_J_m};
}

Coexistence coexistence(const GentTube& tube, double maximum, double minimum) {
    const auto rising = [&](double pressure_Pa, double low, double high) {
        return even_tube(tube,
                         root_of([&](double l) { return even_tube(tube, l).pressure_Pa - pressure_Pa; }, low, high));
    };
    Coexistence line{.pressure_Pa = 0.5 * (even_tube(tube, maximum).pressure_Pa + even_tube(tube, minimum).pressure_Pa),
                     .thin = {},
                     .bulge = {}};
    constexpr int newton_steps = 6;  // the derivative of the difference of potentials is the difference of volumes
    for (int i = 0; i < newton_steps; ++i) {
        line.thin = rising(line.pressure_Pa, 1.0001, maximum);
        line.bulge = rising(line.pressure_Pa, minimum, 0.9 * locking_stretch(tube));
        const double volume_m2 = line.bulge.volume_m2 - line.thin.volume_m2;
        line.pressure_Pa += (line.bulge.energy_J_m - line.thin.energy_J_m) / volume_m2 - line.pressure_Pa;
    }
    return line;
}

}  // namespace soft::verification
