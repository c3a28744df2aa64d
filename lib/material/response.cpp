#include "material/response.hpp"

namespace soft::material {

namespace {

/// Adds W2 d2I2/dF2 and W1 d2I1/dF2:
/// d2I2 = 2 (2 F_kL F_iJ + I1 d_ik d_JL - d_ik C_JL - F_iL F_kJ - b_ik d_JL), d2I1 = 2 d_ik d_JL.
void add_invariant_curvature(const Tensor& F, const Tensor& C, double W1, double W2, Tangent& A) {
    const Tensor b = left_cauchy_green(F);
    const double I1 = trace(C);
    for (int i = 0; i < 3; ++i)
        for (int J = 0; J < 3; ++J) {
            double* row = &A[9 * (3 * i + J)];
            for (int k = 0; k < 3; ++k)
                for (int L = 0; L < 3; ++L)
                    row[3 * k + L] += 2.0 * W2 * (2.0 * F[3 * k + L] * F[3 * i + J] - F[3 * i + L] * F[3 * k + J]);
            for (int L = 0; L < 3; ++L) row[3 * i + L] -= 2.0 * W2 * C[3 * J + L];
            for (int k = 0; k < 3; ++k) row[3 * k + J] -= 2.0 * W2 * b[3 * i + k];
            row[3 * i + J] += 2.0 * (W1 + W2 * I1);
        }
}

/// Adds WJ d2J/dF2 = WJ eps_ikm eps_JLM F_mM.
void add_volume_curvature(const Tensor& F, double WJ, Tangent& A) {
    for (int i = 0; i < 3; ++i)
        for (int J = 0; J < 3; ++J) {
            const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, J1 = (J + 1) % 3, J2 = (J + 2) % 3;
            double* row = &A[9 * (3 * i + J)];
            row[3 * i1 + J1] += WJ * F[3 * i2 + J2];
            row[3 * i2 + J2] += WJ * F[3 * i1 + J1];
            row[3 * i1 + J2] -= WJ * F[3 * i2 + J1];
            row[3 * i2 + J1] -= WJ * F[3 * i1 + J2];
        }
}

}  // namespace

void chain_rule(const Tensor& F, const Dual<3>& energy, Wanted wanted, PointResponse& out) {
    const Tensor C = right_cauchy_green(F);
    const Tensor FC = multiply(F, C);
    const double I1 = trace(C);
    std::array<Tensor, 3> gradient;   // dI1/dF, dI2/dF, dJ/dF
    for (int m = 0; m < 9; ++m) {
        gradient[0][m] = 2.0 * F[m];
        gradient[1][m] = 2.0 * (I1 * F[m] - FC[m]);
    }
    gradient[2] = cofactor(F);
    out.jacobian = determinant(F);
    for (int m = 0; m < 9; ++m)
        out.first_piola[m] =
            energy.g[0] * gradient[0][m] + energy.g[1] * gradient[1][m] + energy.g[2] * gradient[2][m];
    if (wanted == Wanted::stress) return;

    for (int m = 0; m < 9; ++m) {
        std::array<double, 3> weight;
        for (int a = 0; a < 3; ++a)
            weight[a] = energy.hessian(a, 0) * gradient[0][m] + energy.hessian(a, 1) * gradient[1][m] +
                        energy.hessian(a, 2) * gradient[2][m];
        for (int n = 0; n < 9; ++n)
            out.tangent[9 * m + n] =
                weight[0] * gradient[0][n] + weight[1] * gradient[1][n] + weight[2] * gradient[2][n];
    }
    add_invariant_curvature(F, C, energy.g[0], energy.g[1], out.tangent);
    add_volume_curvature(F, energy.g[2], out.tangent);
}

}  // namespace soft::material
