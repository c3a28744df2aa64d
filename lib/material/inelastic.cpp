#include "material/inelastic.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace soft::material {

namespace {

/// Integral of erf from 0 to x, plus 1/sqrt(pi).
double erf_integral(double x) { return x * std::erf(x) + std::exp(-x * x) * std::numbers::inv_sqrtpi; }

/// (1 - exp(-z))/z
double mean_decay(double z) {
    if (std::isinf(z)) return 0.0;
    return std::abs(z) < 1e-8 ? 1.0 - 0.5 * z : -std::expm1(-z) / z;
}

/// (z/2 - 1 + (1 + z/2) exp(-z))/(1 - exp(-z)), whose series begins with z^2/12.
double error_of_step(double z) {
    constexpr double short_step = 1e-2;
    if (z < short_step) return z * z / 12.0;
    return (0.5 * z - 1.0 + (1.0 + 0.5 * z) * std::exp(-z)) / -std::expm1(-z);
}

}  // namespace

double Softening::energy(double W, double W_max) const {
    const double width = m_Pa + beta * W_max, below = std::max(W_max - W, 0.0);
    return W - width / r * (erf_integral(W_max / width) - erf_integral(below / width));
}

Softening::Slopes Softening::slopes_below(double W, double W_max) const {
    const double width = m_Pa + beta * W_max, x = (W_max - W) / width;
    return {1.0 - std::erf(x) / r, 2.0 * std::numbers::inv_sqrtpi * std::exp(-x * x) / (r * width)};
}

double Softening::dissipated(double W_max) const {
    const double width = m_Pa + beta * W_max;
    return width / r * (erf_integral(W_max / width) - std::numbers::inv_sqrtpi);
}

double Inelastic::scale() const {
    return instantaneous ? 1.0 / std::accumulate(moduli.begin(), moduli.end(), 1.0) : 1.0;
}

StepCoefficients step_coefficients(const Inelastic& inelastic, double dt_s) {
    StepCoefficients step;
    for (std::size_t i = 0; i < inelastic.moduli.size(); ++i) {
        const double g = inelastic.moduli[i], tau = inelastic.times_s[i], z = dt_s / tau;
        step.decay.push_back(std::exp(-z));
        step.share.push_back(g * mean_decay(z));
        step.half_decay.push_back(std::exp(-0.5 * z));
        step.half_share.push_back(g * mean_decay(0.5 * z));
        step.error.push_back(std::isinf(z) ? 0.0 : g * tau * tau * error_of_step(z));
        step.factor += step.share.back();
    }
    step.factor *= inelastic.scale();
    return step;
}

StepCoefficients instantaneous_coefficients(const Inelastic& inelastic) {
    StepCoefficients step = step_coefficients(inelastic, 0.0);
    step.is_elastic = true;
    return step;
}

Tensor full(const SymmetricTensor& s) { return {s[0], s[3], s[4], s[3], s[1], s[5], s[4], s[5], s[2]}; }

SymmetricTensor second_piola(const Tensor& F, const Tensor& first_piola) {
    const Tensor cofactors = cofactor(F);  // J F^-T
    const double J = determinant(F);
    const auto component = [&](int I, int K) {
        double sum = 0;
        for (int i = 0; i < 3; ++i) sum += cofactors[3 * i + I] * first_piola[3 * i + K];
        return sum / J;
    };
    return {component(0, 0), component(1, 1), component(2, 2), component(0, 1), component(0, 2), component(1, 2)};
}

SymmetricTensor green_strain(const Tensor& F) {
    const Tensor C = right_cauchy_green(F);
    return {0.5 * (C[0] - 1.0), 0.5 * (C[4] - 1.0), 0.5 * (C[8] - 1.0), 0.5 * C[1], 0.5 * C[2], 0.5 * C[5]};
}

double contract(const SymmetricTensor& a, const SymmetricTensor& b) {
    double sum = 0;
    for (std::size_t c = 0; c < 6; ++c) sum += (c < 3 ? 1.0 : 2.0) * a[c] * b[c];
    return sum;
}

}  // namespace soft::material
