#include "inflation_formula.hpp"

#include <cmath>
#include <numbers>

namespace soft::verification {

double integral(const std::function<double(double)>& f, double from, double to) {
    constexpr std::array<double, 4> at{0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
    constexpr std::array<double, 4> weight{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                           0.1012285362903763};
    constexpr int intervals = 64;
    const double half = 0.5 * (to - from) / intervals;
    double sum = 0;
    for (int i = 0; i < intervals; ++i) {
        const double middle = from + (2 * i + 1) * half;
        for (std::size_t k = 0; k < at.size(); ++k)
            sum += weight[k] * (f(middle - half * at[k]) + f(middle + half * at[k]));
    }
    return half * sum;
}

double sphere_pressure_Pa(const ExtraStress& extra_stress, double inner_stretch, double ratio) {
    const double outer =
        std::cbrt(1.0 + (inner_stretch * inner_stretch * inner_stretch - 1.0) / (ratio * ratio * ratio));
    return integral(
        [&](double l) {
            const Triple s = extra_stress({l, l, 1.0 / (l * l)});
            return 2.0 * (s[0] - s[2]) / (l * (l * l * l - 1.0));
        },
        outer, inner_stretch);
}

double neo_hookean_sphere_pressure_Pa(double mu_Pa, double inner_stretch, double ratio) {
    const double outer =
        std::cbrt(1.0 + (inner_stretch * inner_stretch * inner_stretch - 1.0) / (ratio * ratio * ratio));
    const auto f = [](double l) { return 2.0 / l + 0.5 / std::pow(l, 4); };
    return mu_Pa * (f(outer) - f(inner_stretch));
}

double Cylinder::deformed_radius_m(double R_m, double inner_stretch) const {
    const double a = inner_m * inner_stretch;
    return std::sqrt(a * a + (R_m * R_m - inner_m * inner_m) / axial_stretch);
}

double cylinder_pressure_Pa(const ExtraStress& extra_stress, const Cylinder& c, double inner_stretch) {
    return integral(
        [&](double R) {  // dr = R dR / (r lz)
            const double r = c.deformed_radius_m(R, inner_stretch), hoop = r / R;
            const Triple s = extra_stress({c.axial_stretch, hoop, 1.0 / (c.axial_stretch * hoop)});
            return (s[1] - s[2]) * R / (r * r * c.axial_stretch);
        },
        c.inner_m, c.outer_m);
}

double layered_cylinder_pressure_Pa(const ExtraStress& inside, const ExtraStress& outside, const Cylinder& c,
                                    double interface_m, double inner_stretch) {
    const Cylinder outer{interface_m, c.outer_m, c.axial_stretch};
    return cylinder_pressure_Pa(inside, {c.inner_m, interface_m, c.axial_stretch}, inner_stretch) +
           cylinder_pressure_Pa(outside, outer, c.deformed_radius_m(interface_m, inner_stretch) / interface_m);
}

double neo_hookean_cylinder_pressure_Pa(double mu_Pa, double inner_stretch, double ratio) {
    const double outer = std::sqrt(1.0 + (inner_stretch * inner_stretch - 1.0) / (ratio * ratio));
    return mu_Pa *
           (std::log(inner_stretch / outer) + 0.5 * (1.0 / (outer * outer) - 1.0 / (inner_stretch * inner_stretch)));
}

double hoop_stress_Pa(const ExtraStress& extra_stress, double hoop_stretch, double radial_stress_Pa) {
    const Triple s = extra_stress({1.0, hoop_stretch, 1.0 / hoop_stretch});
    return radial_stress_Pa + s[1] - s[2];
}

TubeState closed_tube(const ExtraStress& extra_stress, double inner_m, double outer_m, double inner_stretch,
                      double max_axial_stretch) {
    // Axial force of the wall minus that of the pressure on the caps, over pi; sigma_r = -p + int (sigma_t - sigma_r) dr/r.
    // With 2 sigma_z = (2 sigma_z - sigma_t - sigma_r) + (sigma_t + sigma_r) and equilibrium, int (sigma_t + sigma_r) r dr
    // = p a^2, so the balance 2 int sigma_z r dr = p a^2 reads int (2 s_z - s_t - s_r) r dr = 0, without the pressure.
    const auto surplus = [&](double lz) {
        const Cylinder c{inner_m, outer_m, lz};
        return integral(
            [&](double R) {
                const double r = c.deformed_radius_m(R, inner_stretch), hoop = r / R;
                const Triple s = extra_stress({lz, hoop, 1.0 / (lz * hoop)});
                return (2.0 * s[0] - s[1] - s[2]) * R / lz;
            },
            inner_m, outer_m);
    };
    const double lz = root_of(surplus, 0.7, max_axial_stretch);
    return {cylinder_pressure_Pa(extra_stress, {inner_m, outer_m, lz}, inner_stretch), lz};
}

PairState sphere_pair(const std::function<double(double)>& small, const std::function<double(double)>& large,
                      double small_limit, double volume_ratio) {
    const auto other = [&](double l) { return std::cbrt(2 * volume_ratio - l * l * l); };
    constexpr double rest = 1 + 1e-9;
    const double l = root_of([&](double x) { return small(x) - large(other(x)); }, rest, small_limit);
    return {l, other(l), small(l)};
}

Peak first_peak(const std::function<double(double)>& f, double low, double high) {
    constexpr int samples = 400;
    const double step = (high - low) / samples;
    int best = 0;
    while (best + 1 < samples && f(low + (best + 1) * step) > f(low + best * step)) ++best;
    double a = low + std::max(best - 1, 0) * step, b = low + (best + 1) * step;
    const double golden = 1.0 / std::numbers::phi;
    for (int i = 0; i < 100; ++i) {
        const double c = b - golden * (b - a), d = a + golden * (b - a);
        if (f(c) < f(d))
            a = c;
        else
            b = d;
    }
    return {0.5 * (a + b), f(0.5 * (a + b))};
}

double root_of(const std::function<double(double)>& f, double low, double high) {
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) break;  // no double lies between them
        (f(middle) < 0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace soft::verification
