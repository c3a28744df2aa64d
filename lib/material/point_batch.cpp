#include "material/point_batch.hpp"

namespace soft::material {

namespace {

constexpr int slope_count = 15;

std::size_t numbers(int components, int stride) {
    return static_cast<std::size_t>(components) * static_cast<std::size_t>(stride);
}

template <std::size_t N>
void load_all(const double* from, int stride, std::array<Lanes, N>& to) {
    for (std::size_t c = 0; c < N; ++c) load(from + c * static_cast<std::size_t>(stride), to[c]);
}

template <std::size_t N>
void store_all(const std::array<Lanes, N>& from, int stride, double* to) {
    for (std::size_t c = 0; c < N; ++c) store(from[c], to + c * static_cast<std::size_t>(stride));
}

}  // namespace

PointBatch::PointBatch(int count, Components wanted)
    : points(count),
      components(wanted),
      stride(padded(count)),
      F(numbers(9, stride)),
      p(numbers(1, stride)),
      axes(static_cast<std::size_t>(count)),
      first_piola(numbers(9, stride)),
      tangent(numbers(81, stride)),
      theta(numbers(1, stride)),
      dtheta_dF(numbers(9, stride)),
      invariants(numbers(3, stride)),
      slopes(numbers(slope_count, stride)) {}

Tensor PointBatch::gradient(int q) const {
    Tensor value;
    for (int m = 0; m < 9; ++m) value[m] = F[m * stride + q];
    return value;
}

void PointBatch::set_gradient(int q, const Tensor& value) {
    const int end = q + 1 == points ? stride : q + 1;
    for (int lane = q; lane < end; ++lane)
        for (int m = 0; m < 9; ++m) F[m * stride + lane] = value[m];
}

PointResponse PointBatch::response(int q) const {
    PointResponse point;
    for (int m = 0; m < 9; ++m) {
        point.first_piola[m] = first_piola[m * stride + q];
        point.dtheta_dF[m] = dtheta_dF[m * stride + q];
    }
    for (int m = 0; m < 81; ++m) point.tangent[m] = tangent[m * stride + q];
    point.theta = theta[q];
    point.jacobian = invariants[2 * stride + q];
    return point;
}

void PointBatch::set_response(int q, const PointResponse& value, Wanted wanted) {
    for (int m = 0; m < 9; ++m) {
        first_piola[m * stride + q] = value.first_piola[m];
        dtheta_dF[m * stride + q] = value.dtheta_dF[m];
    }
    theta[q] = value.theta;
    if (wanted == Wanted::stress) return;
    for (int m = 0; m < 81; ++m) tangent[m * stride + q] = value.tangent[m];
}

namespace detail {

SOFT_VECTOR_CLONES
void compute_invariants(PointBatch& batch) {
    for (int q = 0; q < batch.stride; q += lane_count) {
        TensorOf<Lanes> F;
        load_all(&batch.F[q], batch.stride, F);
        const Invariants<Lanes> I = principal_invariants(F);
        store_all(std::array<Lanes, 3>{I.I1, I.I2, determinant(F)}, batch.stride, &batch.invariants[q]);
    }
}

void set_slopes(PointBatch& batch, int q, const LawSlopes& slopes) {
    double* row = &batch.slopes[q];
    const auto put = [&](double value) {
        *row = value;
        row += batch.stride;
    };
    for (const double first : slopes.energy.first) put(first);
    for (const auto& second : slopes.energy.second)
        for (const double value : second) put(value);
    for (const double slope : slopes.theta_slopes) put(slope);
    batch.theta[q] = slopes.theta;
}

void add_overstress(PointBatch& batch, Wanted wanted) {
    const int stride = batch.stride;
    for (int q = 0; q < batch.points; ++q) {
        const Tensor H = full(batch.memory->overstress[static_cast<std::size_t>(q)]), F = batch.gradient(q);
        const Tensor P = multiply(F, H);
        for (int m = 0; m < 9; ++m) batch.first_piola[m * stride + q] += P[m];
        if (wanted == Wanted::stress) continue;
        for (int i = 0; i < 3; ++i)
            for (int J = 0; J < 3; ++J)
                for (int L = 0; L < 3; ++L) batch.tangent[(9 * (3 * i + J) + 3 * i + L) * stride + q] += H[3 * J + L];
    }
}

/// Applies the chain rules at all points, for fixed components and symmetry.
template <Components Which, Symmetry Kind>
inline void apply_to_all(PointBatch& batch, Form form, Wanted wanted) {
    const int stride = batch.stride;
    TensorOf<Lanes> F, P, dtheta_dF;
    std::array<Lanes, slope_count> slopes;
    SlopesOf<Lanes> energy;
    for (int q = 0; q < stride; q += lane_count) {
        load_all(&batch.F[q], stride, F);
        load_all(&batch.slopes[q], stride, slopes);
        for (int a = 0; a < 3; ++a) {
            energy.first[a] = slopes[a];
            for (int b = 0; b < 3; ++b) energy.second[a][b] = slopes[3 + 3 * a + b];
        }
        double* A = &batch.tangent[q];
        chain_rule<Which, Kind>(F, energy, wanted, P,
                                [&](int m, int n, const Lanes& entry) { store(entry, A + (9 * m + n) * stride); });
        store_all(P, stride, &batch.first_piola[q]);
        if (form != Form::mixed) continue;
        chain_rule(F, {slopes[12], slopes[13], slopes[14]}, dtheta_dF);
        store_all(dtheta_dF, stride, &batch.dtheta_dF[q]);
    }
}

SOFT_VECTOR_CLONES
void apply_planar(PointBatch& batch, Form form, Wanted wanted) {
    apply_to_all<Components::planar, Symmetry::energy>(batch, form, wanted);
}
SOFT_VECTOR_CLONES
void apply_spatial(PointBatch& batch, Form form, Wanted wanted) {
    apply_to_all<Components::all, Symmetry::energy>(batch, form, wanted);
}
SOFT_VECTOR_CLONES
void apply_unsymmetric(PointBatch& batch, Form form, Wanted wanted) {
    apply_to_all<Components::all, Symmetry::none>(batch, form, wanted);
}

void apply_chain_rules(PointBatch& batch, Form form, Symmetry symmetry, Wanted wanted) {
    if (symmetry == Symmetry::none) return apply_unsymmetric(batch, form, wanted);
    if (batch.components == Components::planar) return apply_planar(batch, form, wanted);
    apply_spatial(batch, form, wanted);
}

}  // namespace detail
}  // namespace soft::material
