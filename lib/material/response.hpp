#pragma once
/// Stress and tangent at a point. The energy of the law is differentiated by its own variables (I1, I2, J; the principal
/// stretches; I4) with automatic differentiation. Chain rules that are common to all laws (material/chain_rule.hpp, principal.hpp)
/// convert the derivatives to derivatives by F. For many points use material/point_batch.hpp.
/// Reference configuration throughout, Pa. Tested by material/law_test and material/derivative_test, which differentiate by the nine
/// components of F.
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "material/chain_rule.hpp"
#include "material/law.hpp"
#include "material/principal.hpp"
#include "math/dual.hpp"
#include "math/tensor.hpp"

namespace soft::material {

/// Theta(J) with derivatives. The mixed form is sign(J-1) sqrt((J^2 - 1 - 2 ln J)/2), smooth through J = 1.
template <class T>
[[nodiscard]] T theta(VolumetricLaw law, const T& J) {
    using std::log;
    using std::sqrt;
    switch (law) {
        case VolumetricLaw::quadratic: return J - 1.0;
        case VolumetricLaw::log: return log(J);
        case VolumetricLaw::mixed: {
            // Near J = 1 the square root loses digits by cancellation; five terms of the series in e = J - 1 are exact to 1e-16.
            const T e = J - 1.0;
            if (e < 2e-3 && e > -2e-3)
                return e * (1.0 + e * (-1.0 / 6.0 + e * (1.0 / 9.0 + e * (-11.0 / 135.0 + e * (103.0 / 1620.0)))));
            const T root = sqrt(0.5 * (J * J - 1.0) - log(J));
            return e > 0.0 ? root : -root;
        }
    }
    return J - 1.0;
}

/// The unit vectors e1, e2 of the fibre frame at a point; used only by rubbers with fibres.
struct FiberAxes {
    Vector3 e1{1, 0, 0}, e2{0, 1, 0};
};

/// Stress and tangent at a quadrature point. Reference configuration, Pa.
struct PointResponse {
    Tensor first_piola;   ///< P = dW/dF
    Tangent tangent;      ///< A = dP/dF (only if requested)
    double jacobian = 1;  ///< J = det F
    double theta = 0;     ///< Theta (mixed form only)
    Tensor dtheta_dF;     ///< dTheta/dF (mixed form only)
};

/// P and, if requested, A from derivatives by (I1, I2, J).
void apply_chain_rule(const Tensor& F, const Slopes& slopes, Wanted wanted, PointResponse& out);

[[nodiscard]] Slopes slopes_of(const Dual<3>& energy);
[[nodiscard]] Slopes slopes_of(const std::array<Dual<3>, 3>& coefficients);

/// Adds the stress and tangent of all fibre families.
void add_fibers_response(const Fibers& fibers, const FiberAxes& axes, const Tensor& F, Wanted wanted,
                         PointResponse& out);

/// Small strain: P = 2 mu dev e + p I, with Theta = tr e. The tangent is constant and excludes the derivative of p.
void linear_response(double mu_Pa, const Tensor& F, double p, Wanted wanted, PointResponse& out);

/// I1 = tr C and I2 = (tr^2 C - tr C^2)/2.
template <class T>
[[nodiscard]] Invariants<T> principal_invariants(const TensorOf<T>& F) {
    const TensorOf<T> C = right_cauchy_green(F);
    const T I1 = trace(C);
    T trace_C2{};
    for (const T& c : C) trace_C2 += c * c;
    return {I1, 0.5 * (I1 * I1 - trace_C2)};
}

/// W_s of laws in invariants, without fibres.
template <class L, class T>
requires InvariantLaw<L> || CoupledLaw<L>
[[nodiscard]] T shear_energy(const L& law, const Invariants<T>& I, const T& J) {
    if constexpr (CoupledLaw<L>) {
        return law.shear_energy(I, J);
    } else {
        using std::pow;
        const T contraction = pow(J, -2.0 / 3.0);
        return law.isochoric_energy(Invariants<T>{contraction * I.I1, contraction * contraction * I.I2});
    }
}

/// Theta of the rubber.
template <class L, class T>
[[nodiscard]] T dilatation(const Rubber<L>& rubber, const Invariants<T>& I, const T& J) {
    if constexpr (OwnDilatation<L>)
        return L::dilatation(I, J);
    else
        return theta(rubber.volumetric, J);
}

/// Direction of family 0 (+ angle) or 1 (- angle).
[[nodiscard]] inline Vector3 fiber_direction(const Fibers& fibers, const FiberAxes& axes, int family) {
    const double c = std::cos(fibers.angle_rad), s = (family == 0 ? 1.0 : -1.0) * std::sin(fibers.angle_rad);
    Vector3 a0;
    for (std::size_t i = 0; i < 3; ++i) a0[i] = c * axes.e1[i] + s * axes.e2[i];
    return a0;
}

/// I4 = |F a0|^2.
[[nodiscard]] inline double squared_fiber_stretch(const Tensor& F, const Vector3& a0) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double component = F[3 * i] * a0[0] + F[3 * i + 1] * a0[1] + F[3 * i + 2] * a0[2];
        sum += component * component;
    }
    return sum;
}

/// Derivatives of the energy by (I1, I2, J) (for laws in principal stretches only of the volumetric part), and Theta with its
/// derivatives (mixed form only).
struct LawSlopes {
    Slopes energy;
    double theta = 0;
    std::array<double, 3> theta_slopes{};
};

namespace detail {

/// The variables of the chain rule as dual numbers.
struct Variables {
    Invariants<Dual<3>> I;
    Dual<3> J;
    Variables(const Invariants<double>& values, double jacobian)
        : I{Dual<3>::variable(values.I1, 0), Dual<3>::variable(values.I2, 1)}, J(Dual<3>::variable(jacobian, 2)) {}
};

/// Derivatives of the shear energy in a step plus `volumetric`, a function of (I1, I2, J).
template <class L>
[[nodiscard]] Slopes with_shear(const Rubber<L>& rubber, const Variables& at, const Dual<3>& volumetric,
                                const EnergyOfStep& step) {
    if constexpr (StretchLaw<L>)
        return slopes_of(volumetric);
    else
        return slopes_of(step(shear_energy(rubber.law, at.I, at.J)) + volumetric);
}

}  // namespace detail

/// Mixed formulation: energy W(F, p) at fixed p.
template <Law L>
requires(!StressLaw<L> && !std::same_as<L, LinearElastic>) [[nodiscard]] LawSlopes
    mixed_slopes(const Rubber<L>& rubber, const Invariants<double>& I, double J, double p,
                 const EnergyOfStep& step = {}) {
    const detail::Variables at(I, J);
    const Dual<3> dilation = dilatation(rubber, at.I, at.J);
    return {detail::with_shear(rubber, at, p * dilation, step), dilation.v, dilation.g};
}

/// Displacement formulation: energy W(F) with a finite K.
template <Law L>
requires(!std::same_as<L, LinearElastic>) [[nodiscard]] LawSlopes
    displacement_slopes(const Rubber<L>& rubber, const Invariants<double>& I, double J, const EnergyOfStep& step = {}) {
    const detail::Variables at(I, J);
    if constexpr (StressLaw<L>) {
        return {slopes_of(rubber.law.stress_coefficients(at.I, at.J)), 0.0, {}};
    } else {
        const Dual<3> dilation = dilatation(rubber, at.I, at.J);
        const Dual<3> volumetric = 0.5 / rubber.inverse_bulk_modulus * dilation * dilation;
        return {detail::with_shear(rubber, at, volumetric, step), 0.0, {}};
    }
}

/// True if the derivatives by (I1, I2, J) do not determine the response completely: principal stretches or fibres.
template <class L>
[[nodiscard]] bool has_terms_beyond_invariants(const Rubber<L>& rubber) {
    return StretchLaw<L> || (MayHaveFibers<L> && rubber.fibers);
}

/// Adds the contributions that do not depend on (I1, I2, J) only: principal stretches and fibres.
template <class L>
void add_terms_beyond_invariants(const Rubber<L>& rubber, const FiberAxes& axes, const Tensor& F, Wanted wanted,
                                 PointResponse& out, const EnergyOfStep& step = {}) {
    if constexpr (StretchLaw<L>)
        add_principal_response(rubber.law, step, F, wanted == Wanted::stress_and_tangent ? &out.tangent : nullptr,
                               out.first_piola);
    if constexpr (MayHaveFibers<L>)
        if (rubber.fibers) add_fibers_response(*rubber.fibers, axes, F, wanted, out);
}

/// Mixed formulation: energy W(F, p) at fixed p. Throws std::logic_error for laws without that form (LawInfo::mixed).
template <Law L>
void mixed_response(const Rubber<L>& rubber, const FiberAxes& axes, const Tensor& F, double p, Wanted wanted,
                    PointResponse& out) {
    if constexpr (std::same_as<L, LinearElastic>) {
        linear_response(rubber.law.mu_Pa, F, p, wanted, out);
    } else if constexpr (StressLaw<L>) {
        throw std::logic_error("mixed_response: a stress without an energy has no mixed form");
    } else {
        out.jacobian = determinant(F);
        const LawSlopes slopes = mixed_slopes(rubber, principal_invariants(F), out.jacobian, p);
        apply_chain_rule(F, slopes.energy, wanted, out);
        out.theta = slopes.theta;
        chain_rule(F, slopes.theta_slopes, out.dtheta_dF);
        add_terms_beyond_invariants(rubber, axes, F, wanted, out);
    }
}

/// Displacement formulation: energy W(F) with a finite K; p is not an unknown.
template <Law L>
void displacement_response(const Rubber<L>& rubber, const FiberAxes& axes, const Tensor& F, Wanted wanted,
                           PointResponse& out) {
    if constexpr (std::same_as<L, LinearElastic>) {
        const double K = 1.0 / rubber.inverse_bulk_modulus;
        linear_response(rubber.law.mu_Pa, F, K * (trace(F) - 3.0), wanted, out);
        if (wanted == Wanted::stress) return;
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k) out.tangent[9 * (4 * i) + 4 * k] += K;
    } else {
        out.jacobian = determinant(F);
        const LawSlopes slopes = displacement_slopes(rubber, principal_invariants(F), out.jacobian);
        apply_chain_rule(F, slopes.energy, wanted, out);
        add_terms_beyond_invariants(rubber, axes, F, wanted, out);
    }
}

/// For smaller displacement gradients the energy, which is quadratic in the strain, loses more digits by rounding than the stress, which
/// is linear in the strain.
inline constexpr double small_gradient = 1e-4;

/// W_s(F) - W_s(I) as the work of the stress along the straight path from I to F, by Simpson's rule. For displacement gradients
/// H = F - I below small_gradient its relative error is (eps + |H|^4)/|H|, whereas direct evaluation of W_s has eps/|H|^2.
template <Law L>
requires MayHaveFibers<L>
[[nodiscard]] double small_strain_energy(const Rubber<L>& rubber, const FiberAxes& axes, const Tensor& F) {
    Tensor H = F;
    for (int i = 0; i < 3; ++i) H[4 * i] -= 1.0;
    double sum = 0;
    PointResponse response;
    for (const auto& [fraction, weight] : {std::pair{0.0, 1.0}, {0.5, 4.0}, {1.0, 1.0}}) {
        Tensor between = identity_tensor;
        for (int m = 0; m < 9; ++m) between[m] += fraction * H[m];
        mixed_response(rubber, axes, between, 0.0, Wanted::stress, response);  // at p = 0: the derivative of W_s
        for (int m = 0; m < 9; ++m) sum += weight / 6.0 * response.first_piola[m] * H[m];
    }
    return sum;
}

[[nodiscard]] inline bool is_small_gradient(const Tensor& F) {
    double largest = 0;
    for (int m = 0; m < 9; ++m) largest = std::max(largest, std::abs(F[m] - identity_tensor[m]));
    return largest < small_gradient;
}

/// W_s(F) per undeformed volume [J/m^3] and Theta: W = W_s + K/2 Theta^2. nullopt for a law without an energy.
struct EnergyParts {
    double shear = 0, dilatation = 0;
};
template <Law L>
[[nodiscard]] std::optional<EnergyParts> energy_parts(const Rubber<L>& rubber, const FiberAxes& axes, const Tensor& F) {
    if constexpr (StressLaw<L>) {
        return std::nullopt;
    } else if constexpr (std::same_as<L, LinearElastic>) {
        const double dilation = trace(F) - 3.0;
        double e2 = 0;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                const double e = 0.5 * (F[3 * i + j] + F[3 * j + i]) - (i == j ? 1.0 : 0.0);
                e2 += e * e;
            }
        return EnergyParts{rubber.law.mu_Pa * (e2 - dilation * dilation / 3.0), dilation};
    } else {
        const double J = determinant(F);
        const auto shear_at = [&](const Tensor& at, double jacobian) {
            double shear = 0;
            if constexpr (StretchLaw<L>)
                shear =
                    energy_of_log_stretches(rubber.law, isochoric_log_stretches(spectral_form(right_cauchy_green(at))));
            else
                shear = shear_energy(rubber.law, principal_invariants(at), jacobian);
            for (int family = 0; rubber.fibers && family < rubber.fibers->families; ++family)
                shear += fiber_energy(*rubber.fibers,
                                      squared_fiber_stretch(at, fiber_direction(*rubber.fibers, axes, family)));
            return shear;
        };
        const double shear = is_small_gradient(F)
                                 ? shear_at(identity_tensor, 1.0) + small_strain_energy(rubber, axes, F)
                                 : shear_at(F, J);
        const EnergyParts parts{shear, dilatation(rubber, principal_invariants(F), J)};
        return parts;
    }
}

/// W of the law without fibres and change of volume; 0 for laws without an isochoric energy.
template <Law L>
[[nodiscard]] double isochoric_energy(const Rubber<L>& rubber, const Tensor& F) {
    if constexpr (StretchLaw<L>)
        return energy_of_log_stretches(rubber.law, isochoric_log_stretches(spectral_form(right_cauchy_green(F))));
    else if constexpr (InvariantLaw<L>)
        return shear_energy(rubber.law, principal_invariants(F), determinant(F));
    else
        return 0.0;
}

/// The derivative of step(W) by F.
template <Law L>
[[nodiscard]] Tensor isochoric_stress(const Rubber<L>& rubber, const Tensor& F, const EnergyOfStep& step) {
    PointResponse point;
    if constexpr (MayBeInelastic<L>) {
        const detail::Variables at(principal_invariants(F), determinant(F));
        apply_chain_rule(F, detail::with_shear(rubber, at, Dual<3>{}, step), Wanted::stress, point);
        if constexpr (StretchLaw<L>) add_principal_response(rubber.law, step, F, nullptr, point.first_piola);
    } else {
        throw std::logic_error("isochoric_stress: the law has no isochoric energy");
    }
    return point.first_piola;
}

}  // namespace soft::material
