#pragma once
/// Second-order 3x3 tensors as plain row-major arrays: F[3 i + J] = F_iJ. Templated on the number type so that the same code
/// runs on double and on dual numbers (the reference in tests). Tested by math/tensor_test.
#include <array>
#include <cmath>

#include <cstddef>
#include "math/vector.hpp"

namespace soft {

template <class T>
using TensorOf = std::array<T, 9>;
using Tensor = TensorOf<double>;

/// A_iJkL = dP_iJ/dF_kL as A[9 (3 i + J) + 3 k + L].
using Tangent = std::array<double, 81>;

inline constexpr Tensor identity_tensor{1, 0, 0, 0, 1, 0, 0, 0, 1};

template <class T>
[[nodiscard]] T determinant(const TensorOf<T>& F) {
    return F[0] * (F[4] * F[8] - F[5] * F[7]) - F[1] * (F[3] * F[8] - F[5] * F[6]) + F[2] * (F[3] * F[7] - F[4] * F[6]);
}

/// cof F = J F^-T = dJ/dF.
template <class T>
[[nodiscard]] TensorOf<T> cofactor(const TensorOf<T>& F) {
    return {F[4] * F[8] - F[5] * F[7], F[5] * F[6] - F[3] * F[8], F[3] * F[7] - F[4] * F[6],
            F[2] * F[7] - F[1] * F[8], F[0] * F[8] - F[2] * F[6], F[1] * F[6] - F[0] * F[7],
            F[1] * F[5] - F[2] * F[4], F[2] * F[3] - F[0] * F[5], F[0] * F[4] - F[1] * F[3]};
}

/// C = F^T F.
template <class T>
[[nodiscard]] TensorOf<T> right_cauchy_green(const TensorOf<T>& F) {
    TensorOf<T> C{};
    for (int I = 0; I < 3; ++I)
        for (int J = 0; J < 3; ++J) C[3 * I + J] = F[I] * F[J] + F[3 + I] * F[3 + J] + F[6 + I] * F[6 + J];
    return C;
}

/// b = F F^T.
template <class T>
[[nodiscard]] TensorOf<T> left_cauchy_green(const TensorOf<T>& F) {
    TensorOf<T> b{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            b[3 * i + j] = F[3 * i] * F[3 * j] + F[3 * i + 1] * F[3 * j + 1] + F[3 * i + 2] * F[3 * j + 2];
    return b;
}

template <class T>
[[nodiscard]] TensorOf<T> multiply(const TensorOf<T>& A, const TensorOf<T>& B) {
    TensorOf<T> C{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) C[3 * i + j] = A[3 * i] * B[j] + A[3 * i + 1] * B[3 + j] + A[3 * i + 2] * B[6 + j];
    return C;
}

template <class T>
[[nodiscard]] T trace(const TensorOf<T>& A) {
    return A[0] + A[4] + A[8];
}

/// Eigenvalues of a symmetric tensor, descending. Trigonometric solution of the characteristic cubic (O. K. Smith,
/// Comm. ACM 4 (1961) 168), accurate to about 1e-8 of the largest eigenvalue if two coincide, which is enough for output.
[[nodiscard]] inline Vector3 symmetric_eigenvalues(const Tensor& S) {
    const double mean = trace(S) / 3.0;
    Tensor D = S;
    for (int i = 0; i < 3; ++i) D[4 * i] -= mean;
    double norm2 = 0;
    for (const double d : D) norm2 += d * d;
    const double radius = std::sqrt(norm2 / 6.0);
    if (radius == 0.0) return {mean, mean, mean};
    for (double& d : D) d /= radius;  // scale before the determinant: the cube of a small radius underflows
    double half_det = determinant(D) / 2.0;
    half_det = half_det < -1.0 ? -1.0 : (half_det > 1.0 ? 1.0 : half_det);
    const double angle = std::acos(half_det) / 3.0;
    constexpr double third_turn = 2.0943951023931954923;  // 2 pi / 3
    const double largest = mean + 2.0 * radius * std::cos(angle);
    const double smallest = mean + 2.0 * radius * std::cos(angle + third_turn);
    return {largest, 3.0 * mean - largest - smallest, smallest};
}

}  // namespace soft
