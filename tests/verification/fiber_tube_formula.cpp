#include "fiber_tube_formula.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "inflation_formula.hpp"

namespace soft::verification {
namespace {

using Three = std::array<double, 3>;  ///< of (hoop, axial, twist x A)

struct Stress {
    double radial, hoop, axial, shear;  ///< sigma + q I
};

Stress stress_at(const FiberTube& tube, const Three& state, double R_m) {
    const double A = tube.inner_m, lz = state[1], tau = state[2] / A;
    const double r = std::sqrt(state[0] * state[0] * A * A + (R_m * R_m - A * A) / lz);
    const double stretch_r = R_m / (r * lz), stretch_t = r / R_m, shear = r * tau;
    const double I1 = stretch_r * stretch_r + stretch_t * stretch_t + shear * shear + lz * lz;
    const double w = 2 * tube.slope_Pa(I1);
    Stress s{w * stretch_r * stretch_r, w * (stretch_t * stretch_t + shear * shear), w * lz * lz, w * shear * lz};
    const double fraction = (R_m - A) / (tube.outer_m - A);
    if (fraction < tube.layer_begin || fraction > tube.layer_end) return s;
    for (int family = 0; family < tube.families; ++family) {
        const double sine = (family == 0 ? 1 : -1) * std::sin(tube.angle_rad), cosine = std::cos(tube.angle_rad);
        const double f_t = sine * stretch_t + cosine * shear, f_x = cosine * lz;
        const double x = f_t * f_t + f_x * f_x - 1;
        if (x <= 0) continue;
        const double pull = 2 * tube.k1_Pa * x * std::exp(tube.k2 * x * x);
        s.hoop += pull * f_t * f_t;
        s.axial += pull * f_x * f_x;
        s.shear += pull * f_t * f_x;
    }
    return s;
}

/// Residuals of the three equilibrium equations, divided by the initial modulus of the rubber.
Three imbalance(const FiberTube& tube, const Three& state, double pressure_Pa) {
    const double A = tube.inner_m, wall = tube.outer_m - A, mu = 2 * tube.slope_Pa(3);
    const std::array<double, 4> bounds{A, A + tube.layer_begin * wall, A + tube.layer_end * wall, tube.outer_m};
    const auto over_wall = [&](const std::function<double(const Stress&, double r)>& integrand) {
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i)
            if (bounds[i + 1] > bounds[i])
                sum += integral(
                    [&](double R) {  // dr = R dR / (r lz)
                        const double r = std::sqrt(state[0] * state[0] * A * A + (R * R - A * A) / state[1]);
                        return integrand(stress_at(tube, state, R), r) * R / (r * state[1]);
                    },
                    bounds[i], bounds[i + 1]);
        return sum;
    };
    return {(over_wall([](const Stress& s, double r) { return (s.hoop - s.radial) / r; }) - pressure_Pa) / mu,
            over_wall([](const Stress& s, double r) { return (2 * s.axial - s.hoop - s.radial) * r; }) / (mu * A * A),
            over_wall([](const Stress& s, double r) { return s.shear * r * r; }) / (mu * A * A * A)};
}

double determinant(const Three& a, const Three& b, const Three& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Newton's method with derivatives by central differences.
void equilibrate(const FiberTube& tube, Three& state, double pressure_Pa) {
    constexpr int most = 60;
    constexpr double difference = 1e-7, enough = 1e-12;
    for (int i = 0; i < most; ++i) {
        const Three miss = imbalance(tube, state, pressure_Pa);
        std::array<Three, 3> slope;  // [unknown][balance]
        for (std::size_t k = 0; k < 3; ++k) {
            Three up = state, down = state;
            up[k] += difference;
            down[k] -= difference;
            const Three right = imbalance(tube, up, pressure_Pa), left = imbalance(tube, down, pressure_Pa);
            for (std::size_t j = 0; j < 3; ++j) slope[k][j] = (right[j] - left[j]) / (2 * difference);
        }
        const double whole = determinant(slope[0], slope[1], slope[2]);
        const Three step{determinant(miss, slope[1], slope[2]) / whole, determinant(slope[0], miss, slope[2]) / whole,
                         determinant(slope[0], slope[1], miss) / whole};
        double size = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            state[k] -= step[k];
            size = std::max(size, std::abs(step[k]));
        }
        if (size < enough) return;
        if (!(size < 1)) break;
    }
    throw std::runtime_error("fiber_tube_state: no state at this pressure");
}

}  // namespace

FiberTubeState fiber_tube_state(const FiberTube& tube, double pressure_Pa) {
    constexpr int steps = 12;
    Three state{1, 1, 0};
    for (int i = 1; i <= steps; ++i) equilibrate(tube, state, pressure_Pa * i / steps);
    return {state[0], state[1], state[2] / tube.inner_m};
}

double fiber_tube_pressure_Pa(const FiberTube& tube, const FiberTubeState& state) {
    return imbalance(tube, {state.hoop, state.axial, state.twist_1_m * tube.inner_m}, 0)[0] * 2 * tube.slope_Pa(3);
}

double neutral_angle_rad(FiberTube tube, double pressure_Pa) {
    constexpr double degree = std::numbers::pi / 180;
    const auto lengthening = [&](double angle_rad) {
        tube.angle_rad = angle_rad;
        return fiber_tube_state(tube, pressure_Pa).axial - 1;
    };
    constexpr int most = 20;
    constexpr double enough_rad = 1e-12;
    double before = 54 * degree, angle = 55.5 * degree, value_before = lengthening(before);
    for (int i = 0; i < most && std::abs(angle - before) > enough_rad; ++i) {
        const double value = lengthening(angle), next = angle - value * (angle - before) / (value - value_before);
        before = std::exchange(angle, next);
        value_before = value;
    }
    return angle;
}

}  // namespace soft::verification
