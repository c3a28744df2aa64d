#pragma once
/// Residual and tangent of one cell, finite strain, total Lagrangian, any law, with or without a pressure unknown.
///   R_u = int P(F, p) : grad(du) dV,   R_p = int dp (Theta(J) - p / kappa) dV,
///   K = derivative of (R_u, R_p) by (u, p); symmetric.
/// F = I + grad u in the reference configuration; axisymmetric: F_33 = r/R and dV = 2 pi R dX dR.
/// Element unknowns are numbered component by component: u_x of all nodes, u_y (u_r) of all nodes, (u_z), pressures.
/// Held by element/solid_kernel_test (patch test, rigid rotation, Taylor remainders, tangent symmetry).
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "core/tensor.hpp"
#include "element/reference_cell.hpp"
#include "material/response.hpp"
#include "model/case.hpp"

namespace soft::element {

/// What a cell needs. All spans are component-major as the unknowns.
struct CellInput {
    std::span<const double> X;           ///< reference coordinates [m], dimension x nodes
    std::span<const double> u;           ///< displacement [m], dimension x nodes
    std::span<const double> p;           ///< pressure unknowns (p = pressure_scale x unknown x basis)
    double pressure_scale_Pa = 1;        ///< makes displacement and pressure rows alike in size; see assembly/dof_map.hpp
};

/// What a cell returns, with the work space it needs; made once a thread and cell type, reused for every cell.
struct CellOutput {
    explicit CellOutput(const ReferenceCell& cell)
        : residual(cell.dofs()), stiffness(static_cast<std::size_t>(cell.dofs()) * cell.dofs()),
          gradient(static_cast<std::size_t>(cell.dimension + 1) * cell.nodes), basis(cell.pressure_dofs),
          product(static_cast<std::size_t>(3) * cell.nodes) {}

    std::vector<double> residual;        ///< [N] (pressure rows in the scaled unknown)
    std::vector<double> stiffness;       ///< row-major, dofs x dofs
    double min_jacobian = 1;             ///< least det F over the quadrature points
    std::vector<double> gradient, basis, product;   ///< work space: dN/dX and N/R; pressure functions; A : grad N
};

/// One quadrature point for reporting.
struct PointState {
    Tensor F;
    double p_Pa;            ///< pressure unknown's value (0 in the displacement formulation)
    double weight_m3;       ///< reference volume of the point (2 pi R included)
};

namespace detail {

/// Fills out.gradient with dN/dX (and N/R), returns the reference volume of the point.
template <bool Axisymmetric>
double map_point(const ReferenceCell& cell, const CellInput& in, int q, std::vector<double>& gradient) {
    const int n = cell.nodes, dim = cell.dimension;
    Tensor dX{};
    dX[8] = 1.0;
    const double* dN = &cell.dN_dxi[static_cast<std::size_t>(q) * dim * n];
    for (int i = 0; i < dim; ++i)
        for (int d = 0; d < dim; ++d) {
            double sum = 0;
            for (int a = 0; a < n; ++a) sum += in.X[i * n + a] * dN[d * n + a];
            dX[3 * i + d] = sum;
        }
    const double det = determinant(dX);
    const Tensor cof = cofactor(dX);   // inverse transpose x det
    for (int J = 0; J < dim; ++J)
        for (int a = 0; a < n; ++a) {
            double sum = 0;
            for (int d = 0; d < dim; ++d) sum += cof[3 * J + d] * dN[d * n + a];
            gradient[J * n + a] = sum / det;
        }
    double volume = det * cell.weight[q];
    if constexpr (Axisymmetric) {
        const double* N = &cell.N[static_cast<std::size_t>(q) * n];
        double R = 0;
        for (int a = 0; a < n; ++a) R += N[a] * in.X[n + a];
        for (int a = 0; a < n; ++a) gradient[2 * n + a] = N[a] / R;
        volume *= 2.0 * std::numbers::pi * R;
    }
    return volume;
}

template <bool Axisymmetric>
Tensor deformation_gradient(const ReferenceCell& cell, const CellInput& in, const std::vector<double>& gradient) {
    const int n = cell.nodes, dim = cell.dimension;
    Tensor F = identity_tensor;
    for (int i = 0; i < dim; ++i)
        for (int J = 0; J < dim; ++J)
            for (int a = 0; a < n; ++a) F[3 * i + J] += in.u[i * n + a] * gradient[J * n + a];
    if constexpr (Axisymmetric)
        for (int a = 0; a < n; ++a) F[8] += in.u[n + a] * gradient[2 * n + a];
    return F;
}

/// Pressure functions at quadrature point q, scaled so that p [Pa] = sum basis x unknown.
void pressure_basis(const ReferenceCell& cell, const CellInput& in, int q, std::span<double> basis);

/// Adds the part of the residual that one point gives.
template <bool Axisymmetric>
void add_residual(const ReferenceCell& cell, const material::PointResponse& point, double volume,
                  double inverse_bulk_modulus, double p, CellOutput& out) {
    const int n = cell.nodes, dim = cell.dimension;
    for (int i = 0; i < dim; ++i) {
        double* R = &out.residual[i * n];
        for (int J = 0; J < dim; ++J) {
            const double stress = volume * point.first_piola[3 * i + J];
            for (int a = 0; a < n; ++a) R[a] += stress * out.gradient[J * n + a];
        }
    }
    if constexpr (Axisymmetric)
        for (int a = 0; a < n; ++a) out.residual[n + a] += volume * point.first_piola[8] * out.gradient[2 * n + a];
    for (int s = 0; s < cell.pressure_dofs; ++s)
        out.residual[dim * n + s] += volume * out.basis[s] * (point.theta - p * inverse_bulk_modulus);
}

/// Adds the part of the stiffness that one point gives, blocks on and above the diagonal: first A : grad N for every
/// node and component, then grad N : (that). Columns run over the nodes so that the inner loops vectorise.
template <bool Axisymmetric>
void add_stiffness(const ReferenceCell& cell, const material::PointResponse& point, double volume,
                   double inverse_bulk_modulus, CellOutput& out);

/// Copies the blocks above the diagonal to below it.
void mirror_stiffness(const ReferenceCell& cell, CellOutput& out);

template <bool Axisymmetric, class L>
void integrate(const ReferenceCell& cell, const material::Rubber<L>& rubber, const CellInput& in,
               material::Wanted wanted, CellOutput& out) {
    out.residual.assign(out.residual.size(), 0.0);
    if (wanted == material::Wanted::stress_and_tangent) out.stiffness.assign(out.stiffness.size(), 0.0);
    out.min_jacobian = 1e300;
    material::PointResponse point;
    for (int q = 0; q < cell.points; ++q) {
        const double volume = map_point<Axisymmetric>(cell, in, q, out.gradient);
        const Tensor F = deformation_gradient<Axisymmetric>(cell, in, out.gradient);
        const double J = determinant(F);
        out.min_jacobian = J < out.min_jacobian ? J : out.min_jacobian;
        if (!(J > 0.0)) return;   // the caller reports the cell; an energy of J <= 0 has no meaning
        double p = 0;
        if (cell.pressure == PressureSpace::none) {
            displacement_response(rubber, F, wanted, point);
        } else {
            pressure_basis(cell, in, q, out.basis);
            for (int s = 0; s < cell.pressure_dofs; ++s) p += out.basis[s] * in.p[s];
            mixed_response(rubber, F, p, wanted, point);
        }
        add_residual<Axisymmetric>(cell, point, volume, rubber.inverse_bulk_modulus, p, out);
        if (wanted == material::Wanted::stress_and_tangent)
            add_stiffness<Axisymmetric>(cell, point, volume, rubber.inverse_bulk_modulus, out);
    }
    if (wanted == material::Wanted::stress_and_tangent) mirror_stiffness(cell, out);
}

}  // namespace detail

/// Residual (and stiffness) of a cell. Where det F <= 0 at a point, out.min_jacobian <= 0 and the rest is unfinished.
template <class L>
void integrate_cell(const ReferenceCell& cell, model::Kinematics kinematics, const material::Rubber<L>& rubber,
                    const CellInput& in, material::Wanted wanted, CellOutput& out) {
    if (kinematics == model::Kinematics::axisymmetric) return detail::integrate<true>(cell, rubber, in, wanted, out);
    return detail::integrate<false>(cell, rubber, in, wanted, out);
}

/// The states of a cell's quadrature points, appended to `states`.
void sample_cell(const ReferenceCell& cell, model::Kinematics kinematics, const CellInput& in,
                 std::vector<PointState>& states);

/// The pressure of one cell at its nodes [Pa], for output; discontinuous pressures are evaluated in the cell alone.
[[nodiscard]] std::vector<double> nodal_pressures(const ReferenceCell& cell, std::span<const double> X,
                                                  std::span<const double> unknowns, double pressure_scale_Pa);

}  // namespace soft::element
