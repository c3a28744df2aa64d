#include "snapping_cap.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

namespace soft::verification {
namespace {

/// r, z of the middle surface (z along the axis, upwards), slope phi (positive downwards), and per radian r0 H and r0 M: horizontal force
/// and meridional bending moment, with the undeformed radius r0. The axial force follows from the pressure, r0 V = p r^2 / 2.
using Meridian = std::array<double, 5>;
/// Unknowns of the shooting method: strain and change of curvature at the apex, and the pressure.
using Shot = std::array<double, 3>;

Meridian slope(const Cap& cap, double s, const Meridian& y, double pressure_Pa) {
    const auto [r, z, phi, horizontal, moment] = y;
    const double nu = cap.poisson, E = cap.young_Pa, t = cap.thickness_m;
    const double stretching = E * t / (1 - nu * nu), bending = stretching * t * t / 12;
    const double phi0 = s / cap.radius_m, r0 = cap.radius_m * std::sin(phi0);
    const double c = std::cos(phi), d = std::sin(phi);
    const double hoop = r / r0 - 1, hoop_bend = (d - std::sin(phi0)) / r0;
    const double H = horizontal / r0, V = 0.5 * pressure_Pa * r * r / r0;
    const double strain = (H * c - V * d) / stretching - nu * hoop;
    const double bend = moment / (r0 * bending) - nu * hoop_bend;
    const double hoop_force = stretching * (hoop + nu * strain), hoop_moment = bending * (hoop_bend + nu * bend);
    return {(1 + strain) * c, -(1 + strain) * d, 1 / cap.radius_m + bend,
            hoop_force + pressure_Pa * r * (1 + strain) * d, hoop_moment * c + r0 * (1 + strain) * (H * d + V * c)};
}

Meridian advanced(const Meridian& y, const Meridian& k, double h) {
    Meridian next = y;
    for (std::size_t i = 0; i < y.size(); ++i) next[i] += h * k[i];
    return next;
}

/// Integrates from near the apex, where the state is uniform, to the rim (fourth-order Runge-Kutta).
Meridian rim_of(const Cap& cap, const Shot& shot) {
    constexpr int steps = 600;
    constexpr double start = 1e-4;  // fraction of the meridian; the error of the uniform state is its square
    const auto [strain, bend, pressure_Pa] = shot;
    const double length_m = cap.radius_m * cap.angle, nu = cap.poisson;
    const double stretching = cap.young_Pa * cap.thickness_m / (1 - nu * nu);
    const double bending = stretching * cap.thickness_m * cap.thickness_m / 12;
    double s = start * length_m;
    Meridian y{(1 + strain) * s, 0, (1 / cap.radius_m + bend) * s, stretching * (1 + nu) * strain * s,
               bending * (1 + nu) * bend * s};
    const double h = (length_m - s) / steps;
    for (int i = 0; i < steps; ++i, s += h) {
        const auto a = slope(cap, s, y, pressure_Pa);
        const auto b = slope(cap, s + 0.5 * h, advanced(y, a, 0.5 * h), pressure_Pa);
        const auto c = slope(cap, s + 0.5 * h, advanced(y, b, 0.5 * h), pressure_Pa);
        const auto d = slope(cap, s + h, advanced(y, c, h), pressure_Pa);
        for (std::size_t k = 0; k < y.size(); ++k) y[k] += h / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
    }
    return y;
}

/// Residuals of the radius and the slope at the clamped rim and of the height of the apex above it, scaled to order 1.
Shot residuals(const Cap& cap, const Shot& shot, double sink_m) {
    const auto rim = rim_of(cap, shot);
    return {(rim[0] - cap.radius_m * std::sin(cap.angle)) / cap.thickness_m, rim[2] - cap.angle,
            (-rim[1] - (cap.height_m() - sink_m)) / cap.thickness_m};
}

double determinant(const std::array<Shot, 3>& a) {
    return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) - a[1][0] * (a[0][1] * a[2][2] - a[0][2] * a[2][1]) +
           a[2][0] * (a[0][1] * a[1][2] - a[0][2] * a[1][1]);
}

/// Newton's method with a finite-difference Jacobian in scaled unknowns, solved by Cramer's rule.
Shot solve(const Cap& cap, Shot shot, double sink_m) {
    const Shot scale{cap.thickness_m / cap.radius_m, 1 / cap.radius_m, cap.classical_pressure_Pa()};
    constexpr double difference = 1e-6, tolerance = 1e-8;
    constexpr int limit = 30;
    for (int i = 0; i < limit; ++i) {
        const auto miss = residuals(cap, shot, sink_m);
        if (std::abs(miss[0]) + std::abs(miss[1]) + std::abs(miss[2]) < tolerance) return shot;
        std::array<Shot, 3> columns{};
        for (std::size_t k = 0; k < 3; ++k) {
            auto moved = shot;
            moved[k] += difference * scale[k];
            const auto there = residuals(cap, moved, sink_m);
            for (std::size_t j = 0; j < 3; ++j) columns[k][j] = (there[j] - miss[j]) / difference;
        }
        const double whole = determinant(columns);
        for (std::size_t k = 0; k < 3; ++k) {
            auto replaced = columns;
            replaced[k] = miss;
            shot[k] -= determinant(replaced) / whole * scale[k];
        }
    }
    throw std::runtime_error("the cap's shooting does not converge");
}

CapState extremum(const CapState& a, const CapState& b, const CapState& c) {
    const double h = b.sink_m - a.sink_m, slope = 0.5 * (c.pressure_Pa - a.pressure_Pa);
    const double bend = a.pressure_Pa - 2 * b.pressure_Pa + c.pressure_Pa;
    return {b.sink_m - h * slope / bend, b.pressure_Pa - 0.5 * slope * slope / bend};
}

}  // namespace

double Cap::shallowness() const {
    return std::pow(12 * (1 - poisson * poisson), 0.25) * angle * std::sqrt(radius_m / thickness_m);
}
double Cap::classical_pressure_Pa() const {
    return 2 * young_Pa * std::pow(thickness_m / radius_m, 2) / std::sqrt(3 * (1 - poisson * poisson));
}
double Cap::height_m() const { return radius_m * (1 - std::cos(angle)); }

std::vector<CapState> cap_path(const Cap& cap, double last_m, int count) {
    std::vector<CapState> path{{0, 0}};
    Shot shot{}, before{};
    for (int i = 1; i <= count; ++i) {
        Shot guess;
        for (std::size_t k = 0; k < 3; ++k) guess[k] = 2 * shot[k] - before[k];
        before = shot;
        const double sink_m = last_m * i / count;
        shot = solve(cap, guess, sink_m);
        path.push_back({sink_m, shot[2]});
    }
    return path;
}

SnapPressures snap_pressures(const Cap& cap, int count) {
    const auto path = cap_path(cap, 2 * cap.height_m(), count);
    std::vector<CapState> found;
    for (std::size_t i = 1; i + 1 < path.size() && found.size() < 2; ++i) {
        const double left = path[i].pressure_Pa - path[i - 1].pressure_Pa;
        const double right = path[i + 1].pressure_Pa - path[i].pressure_Pa;
        if (found.empty() ? left > 0 && right <= 0 : left < 0 && right >= 0)
            found.push_back(extremum(path[i - 1], path[i], path[i + 1]));
    }
    if (found.size() < 2) throw std::runtime_error("the cap does not snap");
    return {found[0], found[1]};
}

}  // namespace soft::verification
