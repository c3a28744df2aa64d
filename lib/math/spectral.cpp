#include "math/spectral.hpp"

#include <cmath>

namespace soft {
namespace {

constexpr int p_of[3] = {0, 0, 1}, q_of[3] = {1, 2, 2};
/// Jacobi rotations converge quadratically: a 3x3 tensor needs four or five sweeps.
constexpr int max_sweeps = 20;

/// Rotates in the plane (p, q) so that S_pq vanishes.
void rotate(Tensor& S, Tensor& V, int p, int q) {
    const double off = S[3 * p + q];
    if (off == 0.0) return;
    const double ratio = (S[4 * q] - S[4 * p]) / (2.0 * off);
    const double t = (ratio >= 0.0 ? 1.0 : -1.0) / (std::abs(ratio) + std::sqrt(ratio * ratio + 1.0));
    const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
    const auto turn = [c, s](double& a, double& b) {
        const double old = a;
        a = c * old - s * b;
        b = s * old + c * b;
    };
    for (int k = 0; k < 3; ++k) turn(S[3 * k + p], S[3 * k + q]);
    for (int k = 0; k < 3; ++k) turn(S[3 * p + k], S[3 * q + k]);
    for (int k = 0; k < 3; ++k) turn(V[3 * k + p], V[3 * k + q]);
    S[3 * p + q] = S[3 * q + p] = 0.0;
}

}  // namespace

Spectral spectral_form(const Tensor& symmetric) {
    Tensor S = symmetric, V = identity_tensor;
    for (int sweep = 0; sweep < max_sweeps; ++sweep) {
        const double off = std::abs(S[1]) + std::abs(S[2]) + std::abs(S[5]);
        if (off <= 1e-17 * (std::abs(S[0]) + std::abs(S[4]) + std::abs(S[8]))) break;
        for (int k = 0; k < 3; ++k) rotate(S, V, p_of[k], q_of[k]);
    }
    return {{S[0], S[4], S[8]}, V};
}

}  // namespace soft
