#pragma once
/// Flops per cell of the algorithm in fem/cell_kinematics.cpp, material/chain_rule.hpp and fem/cell_sums.cpp. A multiply-add counts
/// as two flops, a division as one. Not counted, although computed: padding lanes beyond the last point, entries that are equal to others
/// by symmetry (BLAS computes whole diagonal blocks), zeros of the hoop and the third direction in sections, and the derivatives of the law
/// by its invariants, which differ between laws. The reported rates are therefore lower bounds.
///
/// n nodes, Q points, d directions, s pressure functions; g_i: number of directions in which component i has a gradient (d; 3 for u_r).
///   map        dX/dxi, du/dxi, and X (u_r) at the points: 2 n Q per component; inverse and F
///   gradients  dN/dX: d Q n (2 d - 1); N/R: Q n
///   law        chain rules of one point, by components as in chain_rule.hpp
///   residual   volume P, then grad N of it: sum g_i Q (1 + 2 n); pressures Q (2 + 3 s)
///   fill       volume A, then A : grad N, for k >= i: g_i Q (g_k + n (2 g_k - 1)); couplings sum g_i Q (1 + s)
///   product    2 g_i Q for every entry on and above the diagonal, couplings included; compliance Q s + Q s (s + 1)
#include "fem/reference_cell.hpp"
#include "model/case.hpp"

namespace soft::benchmarks {

struct CellFlops {
    double residual = 0;   ///< including the map and the stress
    double stiffness = 0;  ///< in addition to the residual
    [[nodiscard]] double total() const { return residual + stiffness; }
};

/// Flops per point: map (inverse, F, determinants) and chain rules.
struct PointFlops {
    double map, stress, tangent;
};

// all: det X 14, cofactor 27, quotients 9, F 54, det F 14, volume 1; C 30, F C 45, dI 9 + 27, cof F 27, I1 and I2 8, P 45;
// b 30, weights 135, 45 entries of 8, and 117 for terms that only some entries have; dTheta/dF (45) belongs to the tangent.
// planar: the same for the 5 components and 15 entries that are non-zero.
inline constexpr PointFlops solid_point{119, 191, 687}, planar_point{32, 83, 275};

[[nodiscard]] inline CellFlops cell_flops(const fem::ReferenceCell& cell, model::Kinematics kinematics) {
    const bool axisymmetric = kinematics == model::Kinematics::axisymmetric;
    const double n = cell.nodes, Q = cell.points, d = cell.dimension, s = cell.pressure_dofs;
    const auto directions = [&](int i) { return axisymmetric && i == 1 ? 3.0 : d; };
    const PointFlops point = cell.dimension == 3 ? solid_point : planar_point;
    const bool needs_positions = axisymmetric || cell.pressure == fem::PressureSpace::discontinuous_linear;
    double all = 0;
    for (int i = 0; i < cell.dimension; ++i) all += directions(i);

    CellFlops flops;
    const double numbers = 2 * d * d + (needs_positions ? d : 0) + (axisymmetric ? 1 : 0);
    flops.residual += 2 * numbers * n * Q + Q * point.map;
    flops.residual += d * Q * n * (2 * d - 1) + (axisymmetric ? Q * n : 0);
    flops.residual += 2 * Q * s + Q * point.stress;
    flops.residual += all * Q * (1 + 2 * n) + (s > 0 ? Q * (2 + 3 * s) : 0);

    flops.stiffness += Q * point.tangent;
    for (int i = 0; i < cell.dimension; ++i)
        for (int k = i; k < cell.dimension; ++k) {
            flops.stiffness += directions(i) * Q * (directions(k) + n * (2 * directions(k) - 1));
            flops.stiffness += 2 * directions(i) * Q * (i == k ? n * (n + 1) / 2 : n * n);
        }
    if (s > 0) flops.stiffness += all * Q * (1 + s) + 2 * all * Q * n * s + Q * s + Q * s * (s + 1);
    return flops;
}

}  // namespace soft::benchmarks
