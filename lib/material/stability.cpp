#include "material/stability.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/text.hpp"
#include "material/response.hpp"
#include "math/spectral.hpp"

namespace soft::material {
namespace {

using Stretches = std::array<double, 3>;
using Matrix = std::array<std::array<double, 3>, 3>;

/// Search steps per unit of ln(stretch). The steps of 0.5 % also find narrow unstable ranges.
constexpr double steps_per_unit = 200.0;
constexpr int max_bisections = 60;

enum class Increments { isochoric, all };

template <class L>
Increments increments_of(const Rubber<L>& rubber) {
    const bool coupled = CoupledLaw<L> || StressLaw<L>;
    return coupled && rubber.inverse_bulk_modulus > 0.0 ? Increments::all : Increments::isochoric;
}

/// d tau_a / d e_b at principal stretches.
template <class L>
Matrix stiffness_at(const Rubber<L>& rubber, const Stretches& stretch) {
    std::array<Dual<3>, 3> l2;  // squared stretches
    Dual<3> log_J;
    for (int a = 0; a < 3; ++a) {
        const auto e = Dual<3>::variable(std::log(stretch[a]), a);
        l2[a] = exp(2.0 * e);
        log_J += e;
    }
    const Dual<3> J = exp(log_J);
    const Invariants<Dual<3>> I{l2[0] + l2[1] + l2[2], l2[0] * l2[1] + l2[1] * l2[2] + l2[2] * l2[0]};
    Matrix matrix{};
    if constexpr (StressLaw<L>) {  // P = c1 2 F + c2 2 (I1 F - F C) + cJ cof F, tau = P F^T
        const auto slopes = displacement_slopes(rubber, {I.I1.v, I.I2.v}, J.v).energy;
        std::array<Dual<3>, 3> c;
        const std::array<Dual<3>, 3> variable{I.I1, I.I2, J};
        for (int m = 0; m < 3; ++m) {
            c[m] = slopes.first[m];
            for (int n = 0; n < 3; ++n) c[m] += slopes.second[m][n] * (variable[n] - variable[n].v);
        }
        for (int a = 0; a < 3; ++a) {
            const Dual<3> tau = 2.0 * l2[a] * (c[0] + c[1] * (I.I1 - l2[a])) + c[2] * J;
            for (int b = 0; b < 3; ++b) matrix[a][b] = tau.g[b];
        }
        return matrix;
    } else {
        Dual<3> W;
        if constexpr (StretchLaw<L>) {
            // Only isochoric increments are needed, so the stretches need not be divided by J. That division would mix the three
            // stiffnesses, and the rounding error of the largest one would exceed a small one.
            W = energy_of_log_stretches(rubber.law,
                                        std::array<Dual<3>, 3>{0.5 * log(l2[0]), 0.5 * log(l2[1]), 0.5 * log(l2[2])});
        } else {
            W = shear_energy(rubber.law, I, J);
            if (increments_of(rubber) == Increments::all) {
                const Dual<3> dilation = dilatation(rubber, I, J);
                W += 0.5 / rubber.inverse_bulk_modulus * dilation * dilation;
            }
        }
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b) matrix[a][b] = W.hessian(a, b);
        return matrix;
    }
}

/// Positive if and only if the second-order work of all increments is positive. For isochoric increments (the plane normal to
/// (1, 1, 1)) this is the minimum of the trace and the determinant of the quadratic form in the plane; the determinant is the sum of
/// the cofactors divided by 3. In this form, products of stiffnesses of the same sign are only added, so small products are not lost
/// next to products that are larger by sixteen orders of magnitude, as occur with powers of large stretches.
double min_work(const Matrix& matrix, Increments increments) {
    const auto at = [&](int a, int b) { return 0.5 * (matrix[a][b] + matrix[b][a]); };
    if (increments == Increments::isochoric) {
        const double sides = at(0, 1) + at(1, 2) + at(2, 0);
        const double trace = 2.0 / 3.0 * (at(0, 0) + at(1, 1) + at(2, 2) - sides);
        double determinant = 0;
        for (int a = 0; a < 3; ++a) {
            const int b = (a + 1) % 3, c = (a + 2) % 3;
            determinant += at(b, b) * at(c, c) - at(b, c) * at(b, c);
            determinant += 2.0 * (at(a, b) * at(a, c) - at(b, c) * at(a, a));
        }
        return std::min(trace, determinant / 3.0);
    }
    Tensor symmetric;
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) symmetric[3 * a + b] = at(a, b);
    const Spectral form = spectral_form(symmetric);
    return std::min({form.value[0], form.value[1], form.value[2]});
}

/// Principal stretches of the mode; nullopt if the rubber has no such state.
template <class L>
std::optional<Stretches> stretches_of(const Rubber<L>& rubber, Mode mode, double l) {
    double t = mode == Mode::uniaxial ? 1.0 / std::sqrt(l) : mode == Mode::planar ? 1.0 / l : 1.0 / (l * l);
    if (increments_of(rubber) == Increments::all) {
        const auto state = homogeneous_state(rubber, mode, l);
        if (!state) return std::nullopt;
        t = state->lateral_stretch;
    }
    return Stretches{l, mode == Mode::uniaxial ? t : mode == Mode::planar ? 1.0 : l, t};
}

enum class Stability { stable, unstable, undefined };

template <class L>
Stability stability_at(const Rubber<L>& rubber, Mode mode, double stretch) {
    const auto stretches = stretches_of(rubber, mode, stretch);
    if (!stretches) return Stability::undefined;
    const double work = min_work(stiffness_at(rubber, *stretches), increments_of(rubber));
    if (!std::isfinite(work)) return Stability::undefined;
    return work > 0.0 ? Stability::stable : Stability::unstable;
}

template <class L>
std::optional<double> first_unstable(const Rubber<L>& rubber, Mode mode, double end) {
    const int steps = std::max(1, static_cast<int>(std::ceil(steps_per_unit * std::abs(std::log(end)))));
    double stable = 0.0;  // ln l
    for (int i = 0; i <= steps; ++i) {
        double unstable = std::log(end) * i / steps;
        const Stability stability = stability_at(rubber, mode, std::exp(unstable));
        if (stability == Stability::undefined) return std::nullopt;
        if (stability == Stability::stable) {
            stable = unstable;
            continue;
        }
        for (int k = 0; k < max_bisections; ++k) {
            const double middle = 0.5 * (stable + unstable);
            (stability_at(rubber, mode, std::exp(middle)) == Stability::stable ? stable : unstable) = middle;
        }
        return std::exp(unstable);
    }
    return std::nullopt;
}

template <class L>
std::vector<StabilityLimit> limits_of(const Rubber<L>& rubber, const StretchRange& range) {
    std::vector<StabilityLimit> limits;
    if constexpr (!std::same_as<L, LinearElastic>)
        for (const Mode mode : {Mode::uniaxial, Mode::equibiaxial, Mode::planar})
            for (const Sense sense : {Sense::tension, Sense::compression}) {
                const double end = sense == Sense::tension ? range.max : range.min;
                if (const auto stretch = first_unstable(rubber, mode, end)) limits.push_back({mode, sense, *stretch});
            }
    return limits;
}

std::string_view name_of(Mode mode) {
    switch (mode) {
        case Mode::uniaxial: return "uniaxial";
        case Mode::equibiaxial: return "equibiaxial";
        case Mode::planar: return "planar";
        case Mode::simple_shear: return "shear";
    }
    return "";
}

}  // namespace

std::vector<StabilityLimit> stability_limits(const AnyRubber& rubber, const StretchRange& range) {
    return std::visit(
        [&](auto matrix) {
            matrix.fibers.reset();
            return limits_of(matrix, range);
        },
        rubber);
}

std::string stability_text(const std::vector<StabilityLimit>& limits) {
    std::string text;
    for (const Sense sense : {Sense::tension, Sense::compression}) {
        std::vector<std::string> parts;
        for (const StabilityLimit& limit : limits)
            if (limit.sense == sense)
                parts.push_back(std::string(name_of(limit.mode)) + " " + core::rounded_text(limit.stretch, 3));
        if (parts.empty()) continue;
        text += (text.empty() ? "unstable " : " and ") + std::string(sense == Sense::tension ? "beyond" : "below") +
                " a stretch of " + core::join(parts);
    }
    return text;
}

}  // namespace soft::material
