#include "material/principal.hpp"

namespace soft::material {
namespace {

/// d / tanh(2 d), 1/2 at d = 0.
double quotient_of_tanh(double d) {
    if (std::abs(d) < 1e-4) return 0.5 + 2.0 * d * d / 3.0;  // the next term is d^4
    return d / std::tanh(2.0 * d);
}

/// A = sum_ab normal_ab D_aa (x) D_bb + sum_pairs shear_ab (D_ab + D_ba) (x) (D_ab + D_ba) + sum_a S_a 1 (x) n_a (x) n_a with the dyads
/// D_ab = m_a (x) n_b: six products of a left and a right factor.
void add_tangent(const Tensor& m, const Tensor& n, const std::array<double, 3>& S,
                 const std::array<std::array<double, 3>, 3>& normal, const std::array<double, 3>& shear,
                 Tangent& tangent) {
    std::array<Tensor, 6> left, right{};
    const auto dyad = [&](int a, int b, int m_component) {
        return m[m_component / 3 * 3 + a] * n[m_component % 3 * 3 + b];
    };
    for (int p = 0; p < 9; ++p) {
        for (int a = 0; a < 3; ++a) left[a][p] = dyad(a, a, p);
        for (int pair = 0; pair < 3; ++pair) {
            const auto [a, b] = principal_pairs[pair];
            left[3 + pair][p] = dyad(a, b, p) + dyad(b, a, p);
            right[3 + pair][p] = shear[pair] * left[3 + pair][p];
        }
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b) right[a][p] += normal[a][b] * left[b][p];
    }
    Tensor geometric{};
    for (int J = 0; J < 3; ++J)
        for (int L = 0; L < 3; ++L)
            for (int a = 0; a < 3; ++a) geometric[3 * J + L] += S[a] * n[3 * J + a] * n[3 * L + a];
    for (int p = 0; p < 9; ++p) {
        double* row = &tangent[9 * p];
        for (int f = 0; f < 6; ++f)
            for (int q = 0; q < 9; ++q) row[q] += left[f][p] * right[f][q];
        for (int L = 0; L < 3; ++L) row[p / 3 * 3 + L] += geometric[p % 3 * 3 + L];
    }
}

}  // namespace

std::array<double, 3> isochoric_log_stretches(const Spectral& C) {
    const std::array<double, 3> e{0.5 * std::log(C.value[0]), 0.5 * std::log(C.value[1]), 0.5 * std::log(C.value[2])};
    const double mean = (e[0] + e[1] + e[2]) / 3.0;
    return {e[0] - mean, e[1] - mean, e[2] - mean};
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
    std::array<std::array<double, 3>, 3> normal;
    std::array<double, 3> shear;
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
            normal[a][b] = (slopes.second[a][b] - (a == b ? 2.0 * slopes.first[a] : 0.0)) / (C.value[a] * C.value[b]);
    for (int pair = 0; pair < 3; ++pair) {
        const auto [a, b] = principal_pairs[pair];
        const double d = 0.25 * std::log(C.value[b] / C.value[a]);
        const double mean = 0.5 * (slopes.first[a] + slopes.first[b]);
        shear[pair] = (slopes.difference[pair] * quotient_of_tanh(d) - mean) / (C.value[a] * C.value[b]);
    }
    add_tangent(m, n, S, normal, shear, *tangent);
}

}  // namespace soft::material
