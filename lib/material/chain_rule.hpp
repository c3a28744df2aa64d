#pragma once
/// Chain rule from derivatives by (I1, I2, J) to derivatives by F, at one point (T = double) or at several points (T = Lanes):
///   P = W1 dI1/dF + W2 dI2/dF + WJ cof F,   A = sum_ab W_ab dIa (x) dIb + sum_a W_a d2Ia/dF2
///   dI1/dF = 2 F, dI2/dF = 2 (I1 F - F C), dJ/dF = cof F; second derivatives in index form in the code.
/// Reference configuration, Pa. Source: derived here. Tested by material/derivative_test and material/law_test against
/// differentiation in the nine components of F, by material/point_batch_test for T = Lanes.
#include <array>
#include <utility>

#include "math/tensor.hpp"

namespace soft::material {

/// W_a and dW_a/dI_b, with I = (I1, I2, J). `second` is symmetric if W_a are derivatives of an energy.
template <class T>
struct SlopesOf {
    std::array<T, 3> first{};
    std::array<std::array<T, 3>, 3> second{};
};
using Slopes = SlopesOf<double>;

enum class Wanted { stress, stress_and_tangent };

/// planar: F does not couple the first two directions with the third, as in sections; the corresponding components of P and A are
/// not computed.
enum class Components { all, planar };

/// energy: A is symmetric, so only half of it is computed.
enum class Symmetry { energy, none };

[[nodiscard]] constexpr bool is_component(Components components, int m) {
    return components == Components::all || m == 8 || (m % 3 < 2 && m / 3 < 2);
}

namespace detail {

/// dI1/dF, dI2/dF, dJ/dF.
template <class T>
void invariant_gradients(const TensorOf<T>& F, const TensorOf<T>& C, std::array<TensorOf<T>, 3>& gradient) {
    const TensorOf<T> FC = multiply(F, C);
    const T I1 = trace(C);
    for (int m = 0; m < 9; ++m) {
        gradient[0][m] = 2.0 * F[m];
        gradient[1][m] = 2.0 * (I1 * F[m] - FC[m]);
    }
    gradient[2] = cofactor(F);
}

/// Intermediate values for the entries of A.
template <class T>
struct TangentParts {
    std::array<TensorOf<T>, 3> gradient;
    std::array<TensorOf<T>, 3> weight;  // [a][n] dW_a/dF_n, and W2 dI1/dF_n in a = 0
    TensorOf<T> F, C, b;
    T twice_W2, WJ, diagonal;  // diagonal: 2 (W1 + W2 I1)
};

/// A_iJkL = sum_a weight_a,kL dIa/dF_iJ + second derivatives:
/// d2I1 = 2 d_ik d_JL, d2I2 = 2 (2 F_kL F_iJ + I1 d_ik d_JL - d_ik C_JL - F_iL F_kJ - b_ik d_JL), d2J = eps_ikm eps_JLM F_mM.
/// The first term of d2I2 is dI1 (x) dI1, which is contained in `weight`.
template <int M, int N, class T>
[[nodiscard]] inline T tangent_entry(const TangentParts<T>& parts) {
    constexpr int i = M / 3, J = M % 3, k = N / 3, L = N % 3;
    T entry = parts.weight[0][N] * parts.gradient[0][M] + parts.weight[1][N] * parts.gradient[1][M] +
              parts.weight[2][N] * parts.gradient[2][M] - parts.twice_W2 * (parts.F[3 * i + L] * parts.F[3 * k + J]);
    if constexpr (i == k) entry -= parts.twice_W2 * parts.C[3 * J + L];
    if constexpr (J == L) entry -= parts.twice_W2 * parts.b[3 * i + k];
    if constexpr (M == N) entry += parts.diagonal;
    if constexpr (i != k && J != L) {
        constexpr int m = 3 - i - k, other = 3 - J - L;
        constexpr bool positive = ((i + 1) % 3 == k) == ((J + 1) % 3 == L);
        if constexpr (positive)
            entry += parts.WJ * parts.F[3 * m + other];
        else
            entry -= parts.WJ * parts.F[3 * m + other];
    }
    return entry;
}

/// Calls sink(m, n, A_mn) for the requested components. Equal entries are computed once.
template <Components Which, Symmetry Kind, class T, class Sink>
inline void tangent_entries(const TangentParts<T>& parts, Sink&& sink) {
    [&]<std::size_t... K>(std::index_sequence<K...>) {
        const auto entry = [&]<int M, int N>(std::integral_constant<int, M>, std::integral_constant<int, N>) {
            if constexpr (!is_component(Which, M) || !is_component(Which, N)) {
            } else if constexpr (Kind == Symmetry::none || M == N) {
                sink(M, N, tangent_entry<M, N>(parts));
            } else if constexpr (M < N) {
                const T value = tangent_entry<M, N>(parts);
                sink(M, N, value);
                sink(N, M, value);
            }
        };
        (entry(std::integral_constant<int, K / 9>{}, std::integral_constant<int, K % 9>{}), ...);
    }
    (std::make_index_sequence<81>{});
}

}  // namespace detail

/// Computes P and, if requested, passes the entries of A to sink(m, n, A_mn).
template <Components Which, Symmetry Kind, class T, class Sink>
inline void chain_rule(const TensorOf<T>& F, const SlopesOf<T>& slopes, Wanted wanted, TensorOf<T>& P, Sink&& sink) {
    detail::TangentParts<T> parts;
    parts.F = F;
    parts.C = right_cauchy_green(F);
    detail::invariant_gradients(F, parts.C, parts.gradient);
    const auto& W = slopes.first;
    for (int m = 0; m < 9; ++m)
        P[m] = W[0] * parts.gradient[0][m] + W[1] * parts.gradient[1][m] + W[2] * parts.gradient[2][m];
    if (wanted == Wanted::stress) return;
    parts.b = left_cauchy_green(F);
    parts.twice_W2 = 2.0 * W[1];
    parts.WJ = W[2];
    parts.diagonal = 2.0 * (W[0] + W[1] * trace(parts.C));
    for (int a = 0; a < 3; ++a)
        for (int n = 0; n < 9; ++n) {
            const T first = a == 0 ? T(slopes.second[0][0] + W[1]) : slopes.second[a][0];
            parts.weight[a][n] = first * parts.gradient[0][n] + slopes.second[a][1] * parts.gradient[1][n] +
                                 slopes.second[a][2] * parts.gradient[2][n];
        }
    detail::tangent_entries<Which, Kind>(parts, sink);
}

/// dTheta/dF from the derivatives of Theta by (I1, I2, J).
template <class T>
void chain_rule(const TensorOf<T>& F, const std::array<T, 3>& theta_slopes, TensorOf<T>& dtheta_dF) {
    std::array<TensorOf<T>, 3> gradient;
    detail::invariant_gradients(F, right_cauchy_green(F), gradient);
    for (int m = 0; m < 9; ++m)
        dtheta_dF[m] =
            theta_slopes[0] * gradient[0][m] + theta_slopes[1] * gradient[1][m] + theta_slopes[2] * gradient[2][m];
}

}  // namespace soft::material
