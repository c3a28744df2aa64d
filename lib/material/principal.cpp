#include "material/principal.hpp"

namespace soft::material {
namespace {

/// d / tanh(2 d), 1/2 at d = 0.
double quotient_of_tanh(double d) {
    if (std::abs(d) < 1e-4) return 0.5 + 2.0 * d * d / 3.0;  // the next term is d^4
    return d / std::tanh(2.0 * d);
}

}  // namespace

std::array<double, 3> log_stretches(const Spectral& C) {
    return {0.5 * std::log(C.value[0]), 0.5 * std::log(C.value[1]), 0.5 * std::log(C.value[2])};
}

IsochoricStretches<double> isochoric_stretches(const Tensor& F) {
    const auto e = log_stretches(spectral_form(right_cauchy_green(F)));
    const double mean = (e[0] + e[1] + e[2]) / 3.0;
    return {std::exp(e[0] - mean), std::exp(e[1] - mean), std::exp(e[2] - mean)};
}

void add_principal_chain_rule(const Tensor& F, const Spectral& C, const PrincipalSlopes& slopes, Tangent* tangent,
                              Tensor& first_piola) {
    // m_a = F n_a; P = sum_a S_a m_a (x) n_a.
    const Tensor m = multiply(F, C.vector);
    std::array<double, 3> S;
    for (int a = 0; a < 3; ++a) S[a] = slopes.first[a] / C.value[a];
    const auto& n = C.vector;
    for (int i = 0; i < 3; ++i)
        for (int J = 0; J < 3; ++J)
            for (int a = 0; a < 3; ++a) first_piola[3 * i + J] += S[a] * m[3 * i + a] * n[3 * J + a];
    if (tangent == nullptr) return;

    // dS/dE in the eigenbasis: normal entries, and one shear entry per pair.
    std::array<std::array<double, 3>, 3> normal, shear{};
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
            normal[a][b] = (slopes.second[a][b] - (a == b ? 2.0 * slopes.first[a] : 0.0)) / (C.value[a] * C.value[b]);
    for (int pair = 0; pair < 3; ++pair) {
        const int a = pair == 2 ? 1 : 0, b = pair == 0 ? 1 : 2;
        const double d = 0.25 * std::log(C.value[b] / C.value[a]);
        const double mean = 0.5 * (slopes.first[a] + slopes.first[b]);
        shear[a][b] = shear[b][a] = (slopes.difference[pair] * quotient_of_tanh(d) - mean) / (C.value[a] * C.value[b]);
    }
    for (int i = 0; i < 3; ++i)
        for (int J = 0; J < 3; ++J)
            for (int k = 0; k < 3; ++k)
                for (int L = 0; L < 3; ++L) {
                    double sum = 0;
                    for (int a = 0; a < 3; ++a) {
                        if (i == k) sum += S[a] * n[3 * J + a] * n[3 * L + a];
                        for (int b = 0; b < 3; ++b)
                            sum += normal[a][b] * m[3 * i + a] * n[3 * J + a] * m[3 * k + b] * n[3 * L + b] +
                                   shear[a][b] * (m[3 * i + a] * n[3 * J + b] * m[3 * k + a] * n[3 * L + b] +
                                                  m[3 * i + a] * n[3 * J + b] * m[3 * k + b] * n[3 * L + a]);
                    }
                    (*tangent)[9 * (3 * i + J) + 3 * k + L] += sum;
                }
}

}  // namespace soft::material
