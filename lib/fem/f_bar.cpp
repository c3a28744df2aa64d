#include "fem/f_bar.hpp"

namespace soft::fem::detail {

namespace {

using material::PointResponse;
using material::Wanted;

double contract(const Tensor& A, const Tensor& B) {
    double sum = 0;
    for (int m = 0; m < 9; ++m) sum += A[m] * B[m];
    return sum;
}

/// The quantities Q, h, t, b of f_bar.hpp at one point.
struct Terms {
    Tensor Q{}, h{};
    double t = 0, b = 0;
};

/// Scales P(Fbar) and A(Fbar) in `point` to P' and A' and computes the terms that depend on them only.
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

/// Converts P' to P* and A' to A*.
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

/// Adds weight T : grad N at point q to `vector` (over the displacement unknowns).
template <bool Axisymmetric>
void add_contraction(const ReferenceCell& cell, const Tensor& T, double weight, const CellPoints& points, int q,
                     std::span<double> vector) {
    const int n = cell.nodes;
    const auto gradient = [&](int J) { return &points.gradient[static_cast<std::size_t>(J * cell.points + q) * n]; };
    for (int i = 0; i < cell.dimension; ++i)
        for (int J = 0; J < cell.dimension; ++J)
            for (int a = 0; a < n; ++a) vector[i * n + a] += weight * T[3 * i + J] * gradient(J)[a];
    if constexpr (Axisymmetric)
        for (int a = 0; a < n; ++a) vector[n + a] += weight * T[8] * gradient(2)[a];
}

}  // namespace

FBarState f_bar_state(const ReferenceCell& cell, const CellPoints& points) {
    FBarState state;
    state.min_jacobian = min_jacobian(cell, points);  // a positive mean may hide an inverted corner
    for (int q = 0; q < cell.points; ++q) {
        state.volume[q] = points.volume[q];
        state.F[q] = points.law.gradient(q);
        state.jacobian[q] = points.jacobian[q];
        state.reference_volume += state.volume[q];
        state.current_volume += state.volume[q] * state.jacobian[q];
    }
    return state;
}

template <bool Axisymmetric>
void assemble_f_bar(const ReferenceCell& cell, const FBarState& state, Wanted wanted, CellOutput& out) {
    CellPoints& points = out.points;
    std::array<Terms, max_f_bar_points> terms;
    std::array<PointResponse, max_f_bar_points> responses;
    double power = 0, c = 0;  // int t dV, int (b/9 - t/3) dV
    for (int q = 0; q < cell.points; ++q) {
        responses[q] = points.law.response(q);
        terms[q] = scaled_terms(state.F[q], state.jacobian[q], state.scale(q), wanted, responses[q]);
        power += state.volume[q] * terms[q].t;
        c += state.volume[q] * (terms[q].b / 9.0 - terms[q].t / 3.0);
    }
    std::array<double, 24> g{}, B{};
    for (int q = 0; q < cell.points; ++q) {
        const double J = state.jacobian[q], volume = state.volume[q];
        make_effective(terms[q], J * power / (3.0 * state.current_volume), wanted, responses[q]);
        points.law.set_response(q, responses[q], wanted);
        if (wanted == Wanted::stress) continue;
        add_contraction<Axisymmetric>(cell, terms[q].Q, volume * J / state.current_volume, points, q, g);
        add_contraction<Axisymmetric>(cell, terms[q].h, volume / 3.0, points, q, B);
        add_contraction<Axisymmetric>(cell, terms[q].Q, -volume * terms[q].b / 9.0, points, q, B);
    }
    sum_residual<Axisymmetric>(cell, 0.0, out);
    if (wanted == Wanted::stress) return;
    sum_stiffness<Axisymmetric, TangentKind::symmetric>(cell, 0.0, out);
    const std::size_t size = out.residual.size();
    for (std::size_t m = 0; m < size; ++m)
        for (std::size_t n = 0; n < size; ++n)
            out.stiffness[m * size + n] += g[m] * B[n] + B[m] * g[n] + c * g[m] * g[n];
}

template void assemble_f_bar<true>(const ReferenceCell&, const FBarState&, Wanted, CellOutput&);
template void assemble_f_bar<false>(const ReferenceCell&, const FBarState&, Wanted, CellOutput&);

}  // namespace soft::fem::detail
