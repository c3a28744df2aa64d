#include "element/f_bar.hpp"

namespace soft::element::detail {

namespace {

using material::PointResponse;
using material::Wanted;

double contract(const Tensor& A, const Tensor& B) {
    double sum = 0;
    for (int m = 0; m < 9; ++m) sum += A[m] * B[m];
    return sum;
}

/// The terms of the header at one point.
struct Terms {
    Tensor Q{}, h{};
    double t = 0, b = 0;
};

/// Turns P(Fbar) and A(Fbar) in `point` into P' and A' and finds what depends on them alone.
Terms scaled_terms(const Tensor& F, double J, double s, Wanted wanted, PointResponse& point) {
    Terms terms;
    terms.Q = cofactor(F);
    for (double& c : terms.Q) c /= J;
    for (double& P : point.first_piola) P *= s;
    terms.t = contract(point.first_piola, F);
    if (wanted == Wanted::stress) return terms;
    for (double& A : point.tangent) A *= s * s;
    terms.h = point.first_piola;
    for (int m = 0; m < 9; ++m)
        for (int n = 0; n < 9; ++n) terms.h[n] += F[m] * point.tangent[9 * m + n];
    terms.b = contract(terms.h, F);
    return terms;
}

/// P' to P* and A' to A*.
void make_effective(const Terms& terms, double tau, Wanted wanted, PointResponse& point) {
    const auto& [Q, h, t, b] = terms;
    for (int m = 0; m < 9; ++m) point.first_piola[m] += (tau - t / 3.0) * Q[m];
    if (wanted == Wanted::stress) return;
    for (int m = 0; m < 9; ++m)
        for (int n = 0; n < 9; ++n)
            point.tangent[9 * m + n] += (b / 9.0 + tau) * Q[m] * Q[n] - (Q[m] * h[n] + h[m] * Q[n]) / 3.0;
    for (int i = 0; i < 3; ++i)
        for (int J = 0; J < 3; ++J)
            for (int k = 0; k < 3; ++k)
                for (int L = 0; L < 3; ++L)
                    point.tangent[9 * (3 * i + J) + 3 * k + L] += (t / 3.0 - tau) * Q[3 * i + L] * Q[3 * k + J];
}

/// vector += weight T : grad, over the displacement unknowns.
template <bool Axisymmetric>
void add_contraction(const ReferenceCell& cell, const Tensor& T, double weight, const std::vector<double>& gradient,
                     std::span<double> vector) {
    const int n = cell.nodes;
    for (int i = 0; i < cell.dimension; ++i)
        for (int J = 0; J < cell.dimension; ++J)
            for (int a = 0; a < n; ++a) vector[i * n + a] += weight * T[3 * i + J] * gradient[J * n + a];
    if constexpr (Axisymmetric)
        for (int a = 0; a < n; ++a) vector[n + a] += weight * T[8] * gradient[2 * n + a];
}

}  // namespace

template <bool Axisymmetric>
FBarState f_bar_state(const ReferenceCell& cell, const CellInput& in, std::vector<double>& gradient) {
    FBarState state;
    state.min_jacobian = 1e300;
    for (int q = 0; q < cell.points; ++q) {
        state.volume[q] = map_point<Axisymmetric>(cell, in, q, gradient);
        state.F[q] = deformation_gradient<Axisymmetric>(cell, in, gradient);
        state.jacobian[q] = determinant(state.F[q]);
        state.reference_volume += state.volume[q];
        state.current_volume += state.volume[q] * state.jacobian[q];
        // Told from J itself: a mean that is positive may hide an inverted corner.
        state.min_jacobian = state.jacobian[q] < state.min_jacobian ? state.jacobian[q] : state.min_jacobian;
    }
    return state;
}

template <bool Axisymmetric>
void assemble_f_bar(const ReferenceCell& cell, const CellInput& in, const FBarState& state, Wanted wanted,
                    std::span<PointResponse> points, CellOutput& out) {
    const bool tangent = wanted == Wanted::stress_and_tangent;
    const std::size_t size = out.residual.size();
    std::array<Terms, most_f_bar_points> terms;
    double power = 0, c = 0;   // int t dV, int (b/9 - t/3) dV
    for (int q = 0; q < cell.points; ++q) {
        terms[q] = scaled_terms(state.F[q], state.jacobian[q], state.scale(q), wanted, points[q]);
        power += state.volume[q] * terms[q].t;
        c += state.volume[q] * (terms[q].b / 9.0 - terms[q].t / 3.0);
    }
    out.residual.assign(size, 0.0);
    if (tangent) out.stiffness.assign(out.stiffness.size(), 0.0);
    std::array<double, 24> g{}, B{};
    for (int q = 0; q < cell.points; ++q) {
        map_point<Axisymmetric>(cell, in, q, out.gradient);
        const double J = state.jacobian[q], volume = state.volume[q];
        make_effective(terms[q], J * power / (3.0 * state.current_volume), wanted, points[q]);
        add_residual<Axisymmetric>(cell, points[q], volume, 0.0, 0.0, out);
        if (!tangent) continue;
        add_stiffness<Axisymmetric, TangentKind::symmetric>(cell, points[q], volume, 0.0, out);
        add_contraction<Axisymmetric>(cell, terms[q].Q, volume * J / state.current_volume, out.gradient, g);
        add_contraction<Axisymmetric>(cell, terms[q].h, volume / 3.0, out.gradient, B);
        add_contraction<Axisymmetric>(cell, terms[q].Q, -volume * terms[q].b / 9.0, out.gradient, B);
    }
    if (!tangent) return;
    mirror_stiffness(cell, out);
    for (std::size_t m = 0; m < size; ++m)
        for (std::size_t n = 0; n < size; ++n) out.stiffness[m * size + n] += g[m] * B[n] + B[m] * g[n] + c * g[m] * g[n];
}

template FBarState f_bar_state<true>(const ReferenceCell&, const CellInput&, std::vector<double>&);
template FBarState f_bar_state<false>(const ReferenceCell&, const CellInput&, std::vector<double>&);
template void assemble_f_bar<true>(const ReferenceCell&, const CellInput&, const FBarState&, Wanted,
                                   std::span<PointResponse>, CellOutput&);
template void assemble_f_bar<false>(const ReferenceCell&, const CellInput&, const FBarState&, Wanted,
                                    std::span<PointResponse>, CellOutput&);

}  // namespace soft::element::detail
