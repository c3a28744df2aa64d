#include "material/response.hpp"

namespace soft::material {

namespace {

/// Adds the stress and tangent of fibres along the unit vector a0.
void add_fiber_response(const Tensor& F, const Vector3& a0, const Dual<1>& energy, Wanted wanted, PointResponse& out) {
    Vector3 a;  // F a0
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

void apply_chain_rule(const Tensor& F, const Slopes& slopes, Wanted wanted, PointResponse& out) {
    chain_rule<Components::all, Symmetry::none>(F, slopes, wanted, out.first_piola,
                                                [&](int m, int n, double entry) { out.tangent[9 * m + n] = entry; });
}

void add_fibers_response(const Fibers& fibers, const FiberAxes& axes, const Tensor& F, Wanted wanted,
                         PointResponse& out) {
    for (int family = 0; family < fibers.families; ++family) {
        const Vector3 a0 = fiber_direction(fibers, axes, family);
        const auto energy = fiber_energy(fibers, Dual<1>::variable(squared_fiber_stretch(F, a0), 0));
        add_fiber_response(F, a0, energy, wanted, out);
    }
}

void linear_response(double mu_Pa, const Tensor& F, double p, Wanted wanted, PointResponse& out) {
    const double dilatation = trace(F) - 3.0;
    out.jacobian = determinant(F);
    out.theta = dilatation;
    out.dtheta_dF = identity_tensor;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const double twice_strain = F[3 * i + j] + F[3 * j + i] - (i == j ? 2.0 : 0.0);
            out.first_piola[3 * i + j] = mu_Pa * twice_strain + (i == j ? p - 2.0 * mu_Pa * dilatation / 3.0 : 0.0);
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
