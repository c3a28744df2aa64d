#pragma once
/// Laws in principal stretches: chain rule from derivatives of W by the logarithmic stretches e_a = ln l_a to derivatives by F.
///   tau_a = dW/de_a (principal Kirchhoff stress), H_ab = d2W/de_a de_b,
///   S = sum_a tau_a/l_a^2 n_a (x) n_a,   dS/dE = sum_ab (H_ab - 2 tau_a d_ab)/(l_a^2 l_b^2) n_aabb
///       + sum_{a != b} (S_b - S_a)/(l_b^2 - l_a^2) (n_abab + n_abba).
/// The quotient is computed without cancellation for any two stretches, including equal ones: with half the difference
/// d = (e_b - e_a)/2 it is (r d/tanh(2 d) - T)/(l_a l_b)^2, T = (tau_a + tau_b)/2 and r = (tau_b - tau_a)/(2 d). For small d, r is
/// computed as the mean of a second derivative of W between the two states (three-point Gauss rule, exact to rounding).
/// Source: Holzapfel, Nonlinear Solid Mechanics (2000), 6.180; the quotient is derived here. Tested by material/law_test.
#include <array>
#include <cmath>

#include "material/invariants.hpp"
#include "math/dual.hpp"
#include "math/spectral.hpp"
#include "math/tensor.hpp"

namespace soft::material {

struct PrincipalSlopes {
    std::array<double, 3> first{};                  ///< tau_a
    std::array<std::array<double, 3>, 3> second{};  ///< H_ab
    std::array<double, 3> difference{};             ///< r of the pairs (0, 1), (0, 2), (1, 2)
};

/// Adds P and, unless `tangent` is null, A = dP/dF for an energy with these slopes. `C` is the spectral decomposition of F^T F.
void add_principal_chain_rule(const Tensor& F, const Spectral& C, const PrincipalSlopes& slopes, Tangent* tangent,
                              Tensor& first_piola);

/// l_a J^-1/3.
[[nodiscard]] IsochoricStretches<double> isochoric_stretches(const Tensor& F);

/// e_a = ln l_a from the spectral decomposition of C.
[[nodiscard]] std::array<double, 3> log_stretches(const Spectral& C);

/// W(exp(e_a - mean e)) with its derivatives by e.
template <class L>
[[nodiscard]] Dual<3> energy_of_log_stretches(const L& law, const std::array<double, 3>& e) {
    std::array<Dual<3>, 3> variable;
    for (int a = 0; a < 3; ++a) variable[a] = Dual<3>::variable(e[a], a);
    const Dual<3> mean = (variable[0] + variable[1] + variable[2]) * (1.0 / 3.0);
    return law.isochoric_energy(
        IsochoricStretches<Dual<3>>{exp(variable[0] - mean), exp(variable[1] - mean), exp(variable[2] - mean)});
}

template <class L>
[[nodiscard]] PrincipalSlopes principal_slopes(const L& law, const std::array<double, 3>& e) {
    // For larger distances the plain quotient loses less than two of its fourteen digits. For smaller ones the error of the Gauss
    // rule, of order (alpha d)^6 / 2e6, is below rounding for all practical exponents.
    constexpr double near = 0.01;
    constexpr std::array<double, 3> node{0.11270166537925831, 0.5, 0.88729833462074169};  // Gauss-Legendre on [0, 1]
    constexpr std::array<double, 3> weight{5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
    PrincipalSlopes slopes;
    const Dual<3> W = energy_of_log_stretches(law, e);
    for (int a = 0; a < 3; ++a) {
        slopes.first[a] = W.g[a];
        for (int b = 0; b < 3; ++b) slopes.second[a][b] = W.hessian(a, b);
    }
    for (int pair = 0; pair < 3; ++pair) {
        const int a = pair == 2 ? 1 : 0, b = pair == 0 ? 1 : 2;
        const double d = 0.5 * (e[b] - e[a]), middle = 0.5 * (e[a] + e[b]);
        if (std::abs(d) > near) {
            slopes.difference[pair] = 0.5 * (W.g[b] - W.g[a]) / d;
            continue;
        }
        for (int k = 0; k < 3; ++k) {
            auto between = e;
            between[a] = middle - node[k] * d;
            between[b] = middle + node[k] * d;
            const Dual<3> V = energy_of_log_stretches(law, between);
            slopes.difference[pair] += 0.5 * weight[k] * (V.hessian(a, a) - 2.0 * V.hessian(a, b) + V.hessian(b, b));
        }
    }
    return slopes;
}

template <class L>
void add_principal_response(const L& law, const Tensor& F, Tangent* tangent, Tensor& first_piola) {
    const Spectral C = spectral_form(right_cauchy_green(F));
    add_principal_chain_rule(F, C, principal_slopes(law, log_stretches(C)), tangent, first_piola);
}

}  // namespace soft::material
