#pragma once
/// Stress and tangent at a point: the law's energy is differentiated in (I1, I2, J) by automatic differentiation,
/// and the kinematic chain rule below carries the result to F, once for all laws.
///   P = W1 dI1/dF + W2 dI2/dF + WJ cof F,   A = sum_ab W_ab dIa (x) dIb + sum_a W_a d2Ia/dF2
///   dI1/dF = 2 F, dI2/dF = 2 (I1 F - F C); second derivatives in index form in the code.
/// Source: derived here; held against nine-variable AD in F by material/law_test.
#include <cmath>

#include "core/dual.hpp"
#include "core/tensor.hpp"
#include "material/law.hpp"

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
            // Near J = 1 the square root loses its digits; five terms of its series in e = J - 1 are exact to 1e-16 there.
            const T e = J - 1.0;
            if (e < 2e-3 && e > -2e-3)
                return e * (1.0 + e * (-1.0 / 6.0 + e * (1.0 / 9.0 + e * (-11.0 / 135.0 + e * (103.0 / 1620.0)))));
            const T root = sqrt(0.5 * (J * J - 1.0) - log(J));
            return e > 0.0 ? root : -root;
        }
    }
    return J - 1.0;
}

/// Energy per undeformed volume [J/m^3] as a function of the invariants of C and of J; p [Pa] is the mixed unknown.
template <class T, HyperelasticLaw L>
[[nodiscard]] T mixed_energy(const Rubber<L>& rubber, double p, const T& I1, const T& I2, const T& J) {
    using std::pow;
    const T contraction = pow(J, -2.0 / 3.0);
    const Invariants<T> bar{contraction * I1, contraction * contraction * I2};
    return rubber.law.isochoric_energy(bar) + p * theta(rubber.volumetric, J) -
           T(0.5 * p * p * rubber.inverse_bulk_modulus);
}

template <class T, HyperelasticLaw L>
[[nodiscard]] T displacement_energy(const Rubber<L>& rubber, const T& I1, const T& I2, const T& J) {
    const T t = theta(rubber.volumetric, J);
    return mixed_energy(rubber, 0.0, I1, I2, J) + 0.5 / rubber.inverse_bulk_modulus * t * t;
}

/// What an integration point gives the element. Reference configuration, Pa.
struct PointResponse {
    Tensor first_piola;      ///< P = dW/dF
    Tangent tangent;         ///< A = dP/dF (only if asked for)
    double jacobian = 1;     ///< J = det F
    double theta = 0;        ///< Theta(J)
    Tensor dtheta_dF;        ///< Theta'(J) cof F
};

enum class Wanted { stress, stress_and_tangent };

/// P and A from a function's derivatives by (I1, I2, J).
void chain_rule(const Tensor& F, const Dual<3>& energy, Wanted wanted, PointResponse& out);

/// I1 = tr C and I2 = (tr^2 C - tr C^2)/2.
[[nodiscard]] inline Invariants<double> principal_invariants(const Tensor& F) {
    const Tensor C = right_cauchy_green(F);
    const double I1 = trace(C);
    double trace_C2 = 0;
    for (const double c : C) trace_C2 += c * c;
    return {I1, 0.5 * (I1 * I1 - trace_C2)};
}

/// Mixed formulation: energy W(F, p) at fixed p.
template <HyperelasticLaw L>
void mixed_response(const Rubber<L>& rubber, const Tensor& F, double p, Wanted wanted, PointResponse& out) {
    const auto [I1, I2] = principal_invariants(F);
    const double J = determinant(F);
    const auto energy =
        mixed_energy(rubber, p, Dual<3>::variable(I1, 0), Dual<3>::variable(I2, 1), Dual<3>::variable(J, 2));
    chain_rule(F, energy, wanted, out);
    const auto t = theta(rubber.volumetric, Dual<1>::variable(J, 0));
    out.theta = t.v;
    out.dtheta_dF = cofactor(F);
    for (double& c : out.dtheta_dF) c *= t.g[0];
}

/// Displacement formulation: energy W(F) with a finite kappa; p is not an unknown.
template <HyperelasticLaw L>
void displacement_response(const Rubber<L>& rubber, const Tensor& F, Wanted wanted, PointResponse& out) {
    const auto [I1, I2] = principal_invariants(F);
    const auto energy = displacement_energy(rubber, Dual<3>::variable(I1, 0), Dual<3>::variable(I2, 1),
                                            Dual<3>::variable(determinant(F), 2));
    chain_rule(F, energy, wanted, out);
}

}  // namespace soft::material
