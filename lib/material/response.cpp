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

/// dI1/dF, dI2/dF, dJ/dF.
std::array<Tensor, 3> invariant_gradients(const Tensor& F, const Tensor& C) {
    const Tensor FC = multiply(F, C);
    const double I1 = trace(C);
    std::array<Tensor, 3> gradient;
    for (int m = 0; m < 9; ++m) {
        gradient[0][m] = 2.0 * F[m];
        gradient[1][m] = 2.0 * (I1 * F[m] - FC[m]);
    }
    gradient[2] = cofactor(F);
    return gradient;
}

}  // namespace

Slopes slopes_of(const Dual<3>& energy) {
    Slopes slopes;
    for (int a = 0; a < 3; ++a) {
        slopes.first[a] = energy.g[a];
        for (int b = 0; b < 3; ++b) slopes.second[a][b] = energy.hessian(a, b);
    }
    return slopes;
}

Slopes slopes_of(const std::array<Dual<3>, 3>& coefficients) {
    Slopes slopes;
    for (int a = 0; a < 3; ++a) {
        slopes.first[a] = coefficients[a].v;
        for (int b = 0; b < 3; ++b) slopes.second[a][b] = coefficients[a].g[b];
    }
    return slopes;
}

void chain_rule(const Tensor& F, const Slopes& slopes, Wanted wanted, PointResponse& out) {
    const Tensor C = right_cauchy_green(F);
    const auto gradient = invariant_gradients(F, C);
    const auto& W = slopes.first;
    out.jacobian = determinant(F);
    for (int m = 0; m < 9; ++m)
        out.first_piola[m] = W[0] * gradient[0][m] + W[1] * gradient[1][m] + W[2] * gradient[2][m];
    if (wanted == Wanted::stress) return;

    for (int n = 0; n < 9; ++n) {
        std::array<double, 3> weight;   // dW_a/dF_n
        for (int a = 0; a < 3; ++a)
            weight[a] = slopes.second[a][0] * gradient[0][n] + slopes.second[a][1] * gradient[1][n] +
                        slopes.second[a][2] * gradient[2][n];
        for (int m = 0; m < 9; ++m)
            out.tangent[9 * m + n] =
                weight[0] * gradient[0][m] + weight[1] * gradient[1][m] + weight[2] * gradient[2][m];
    }
    add_invariant_curvature(F, C, W[0], W[1], out.tangent);
    add_volume_curvature(F, W[2], out.tangent);
}

void chain_rule_of_dilatation(const Tensor& F, const Dual<3>& dilatation, PointResponse& out) {
    if (dilatation.g[0] == 0.0 && dilatation.g[1] == 0.0) {   // a function of J alone, as in nearly every law
        out.dtheta_dF = cofactor(F);
        for (double& c : out.dtheta_dF) c *= dilatation.g[2];
        return;
    }
    const auto gradient = invariant_gradients(F, right_cauchy_green(F));
    for (int m = 0; m < 9; ++m)
        out.dtheta_dF[m] = dilatation.g[0] * gradient[0][m] + dilatation.g[1] * gradient[1][m] +
                           dilatation.g[2] * gradient[2][m];
}

void add_fiber_response(const Tensor& F, const Vector3& a0, const Dual<1>& energy, Wanted wanted, PointResponse& out) {
    Vector3 a;   // F a0
    for (int i = 0; i < 3; ++i) a[i] = F[3 * i] * a0[0] + F[3 * i + 1] * a0[1] + F[3 * i + 2] * a0[2];
    const double slope = 2.0 * energy.g[0], curvature = 4.0 * energy.hessian(0, 0);
    for (int i = 0; i < 3; ++i)
        for (int J = 0; J < 3; ++J) out.first_piola[3 * i + J] += slope * a[i] * a0[J];
    if (wanted == Wanted::stress) return;
    for (int i = 0; i < 3; ++i)
        for (int J = 0; J < 3; ++J)
            for (int k = 0; k < 3; ++k)
                for (int L = 0; L < 3; ++L)
                    out.tangent[9 * (3 * i + J) + 3 * k + L] +=
                        a0[J] * a0[L] * (curvature * a[i] * a[k] + (i == k ? slope : 0.0));
}

void linear_response(double mu_Pa, const Tensor& F, double p, Wanted wanted, PointResponse& out) {
    const double dilatation = trace(F) - 3.0;
    out.jacobian = determinant(F);
    out.theta = dilatation;
    out.dtheta_dF = identity_tensor;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const double twice_strain = F[3 * i + j] + F[3 * j + i] - (i == j ? 2.0 : 0.0);
            out.first_piola[3 * i + j] =
                mu_Pa * twice_strain + (i == j ? p - 2.0 * mu_Pa * dilatation / 3.0 : 0.0);
        }
    if (wanted == Wanted::stress) return;
    out.tangent.fill(0.0);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            double* row = &out.tangent[9 * (3 * i + j)];
            row[3 * i + j] += mu_Pa;
            row[3 * j + i] += mu_Pa;
            if (i == j)
                for (int k = 0; k < 3; ++k) row[4 * k] -= 2.0 * mu_Pa / 3.0;
        }
}

}  // namespace soft::material
