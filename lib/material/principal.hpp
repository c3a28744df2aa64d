#pragma once
/// Laws in principal stretches, in the form of Valanis and Landel: W_s = w(x_1) + w(x_2) + w(x_3), x_a = e_a - (e_1 + e_2 + e_3)/3,
/// e_a = ln l_a. Chain rule from derivatives of W by e_a to derivatives by F:
///   tau_a = dW/de_a (principal Kirchhoff stress), H_ab = d2W/de_a de_b,
///   S = sum_a tau_a/l_a^2 n_a (x) n_a,   dS/dE = sum_ab (H_ab - 2 tau_a d_ab)/(l_a^2 l_b^2) n_aabb
///       + sum_{a != b} (S_b - S_a)/(l_b^2 - l_a^2) (n_abab + n_abba).
/// The quotient is computed without cancellation for any two stretches, including equal ones: with half the difference
/// d = (e_b - e_a)/2 it is (r d/tanh(2 d) - T)/(l_a l_b)^2, T = (tau_a + tau_b)/2 and r = (tau_b - tau_a)/(2 d). For small d, r is
/// computed as the mean of w'' between the two states by a three-point Gauss rule.
/// Sources: Holzapfel, Nonlinear Solid Mechanics (2000), 6.180; Valanis, Landel, J. Appl. Phys. 38 (1967) 2997; the quotient is derived
/// here. Tested by material/law_test.
#include <array>
#include <cmath>

#include "material/inelastic.hpp"
#include "material/invariants.hpp"
#include "math/dual.hpp"
#include "math/spectral.hpp"
#include "math/tensor.hpp"

namespace soft::material {

inline constexpr std::array<std::array<int, 2>, 3> principal_pairs{{{0, 1}, {0, 2}, {1, 2}}};

struct PrincipalSlopes {
    std::array<double, 3> first{};                  ///< tau_a
    std::array<std::array<double, 3>, 3> second{};  ///< H_ab
    std::array<double, 3> difference{};             ///< r of the pairs
};

/// Adds P and, unless `tangent` is null, A = dP/dF for an energy with these slopes. `C` is the spectral decomposition of F^T F.
void add_principal_chain_rule(const Tensor& F, const Spectral& C, const PrincipalSlopes& slopes, Tangent* tangent,
                              Tensor& first_piola);

/// x_a from the spectral decomposition of C.
[[nodiscard]] std::array<double, 3> isochoric_log_stretches(const Spectral& C);

/// (w'(x_b) - w'(x_a))/(2 d) of the pairs. `at`: w(x_a).
template <class L>
[[nodiscard]] std::array<double, 3> pair_quotients(const L& law, const std::array<double, 3>& x,
                                                   const std::array<Dual<1>, 3>& at) {
    // For larger distances the plain quotient loses about two of its fourteen digits. For smaller ones the relative error of the Gauss
    // rule is of the order of (2 alpha d)^6 / 2e6: 3e-11 at an exponent of 20.
    constexpr double near = 0.005;
    constexpr std::array<double, 3> node{0.11270166537925831, 0.5, 0.88729833462074169};  // Gauss-Legendre on [0, 1]
    constexpr std::array<double, 3> weight{5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
    std::array<double, 3> quotients{};
    for (int pair = 0; pair < 3; ++pair) {
        const auto [a, b] = principal_pairs[pair];
        const double change = x[b] - x[a];
        if (std::abs(change) > 2.0 * near) {
            quotients[pair] = (at[b].g[0] - at[a].g[0]) / change;
            continue;
        }
        for (int k = 0; k < 3; ++k)
            quotients[pair] +=
                weight[k] * law.energy_of_log_stretch(Dual<1>::variable(x[a] + node[k] * change, 0)).h[0];
    }
    return quotients;
}

/// `difference` only with `of_tangent`.
template <class L>
[[nodiscard]] PrincipalSlopes principal_slopes(const L& law, const EnergyOfStep& step, const std::array<double, 3>& x,
                                               bool of_tangent) {
    std::array<Dual<1>, 3> at;
    for (int a = 0; a < 3; ++a) at[a] = law.energy_of_log_stretch(Dual<1>::variable(x[a], 0));
    const Dual<1> third = (at[0] + at[1] + at[2]) * (1.0 / 3.0);
    Dual<3> W = 3.0 * third.v;
    for (int a = 0; a < 3; ++a) {
        W.g[a] = at[a].g[0] - third.g[0];
        for (int b = a; b < 3; ++b)
            W.h[Dual<3>::packed(a, b)] = (a == b ? at[a].h[0] : 0.0) - (at[a].h[0] + at[b].h[0] - third.h[0]) / 3.0;
    }
    PrincipalSlopes slopes;
    if (of_tangent) {
        const double by_W = step.slope(W.v);
        slopes.difference = pair_quotients(law, x, at);
        for (double& quotient : slopes.difference) quotient *= by_W;
    }
    W = step(W);
    for (int a = 0; a < 3; ++a) {
        slopes.first[a] = W.g[a];
        for (int b = 0; b < 3; ++b) slopes.second[a][b] = W.hessian(a, b);
    }
    return slopes;
}

template <class L>
void add_principal_response(const L& law, const EnergyOfStep& step, const Tensor& F, Tangent* tangent,
                            Tensor& first_piola) {
    const Spectral C = spectral_form(right_cauchy_green(F));
    add_principal_chain_rule(F, C, principal_slopes(law, step, isochoric_log_stretches(C), tangent != nullptr), tangent,
                             first_piola);
}

}  // namespace soft::material
