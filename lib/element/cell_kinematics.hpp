#pragma once
/// What a cell is given and returns, and what all its kernels share: the map of a point, F, and the sums over the points.
/// F = I + grad u in the reference configuration; axisymmetric: F_33 = r/R and dV = 2 pi R dX dR.
/// Element unknowns are numbered component by component: u_x of all nodes, u_y (u_r) of all nodes, (u_z), pressures.
/// For element/solid_kernel.hpp, whose tests hold it.
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

namespace detail {

/// Reference position of a quadrature point.
[[nodiscard]] Vector3 position(const ReferenceCell& cell, const CellInput& in, int q);

/// Fills `gradient` with dN/dX (and N/R), returns the reference volume of the point.
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

/// The fibre frame at quadrature point q: e1 = x, e2 = y or the hoop direction about x. A section of a body of revolution
/// lies in (x, r, hoop), so its hoop is the third axis.
template <bool Axisymmetric>
material::FiberAxes fiber_axes(const ReferenceCell& cell, material::FiberFrame frame, const CellInput& in, int q) {
    if (frame == material::FiberFrame::cartesian) return {};
    if constexpr (Axisymmetric) return {{1, 0, 0}, {0, 0, 1}};
    const int n = cell.nodes;
    const double* N = &cell.N[static_cast<std::size_t>(q) * n];
    double y = 0, z = 0;
    for (int a = 0; a < n; ++a) {
        y += N[a] * in.X[n + a];
        if (cell.dimension == 3) z += N[a] * in.X[2 * n + a];
    }
    const double r = std::hypot(y, z);   // > 0 inside a cell: quadrature points do not lie on the axis
    return {{1, 0, 0}, {0, -z / r, y / r}};
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

/// symmetric: only the blocks on and above the diagonal are computed, mirror_stiffness fills the rest.
enum class TangentKind { symmetric, full };

/// Adds the part of the stiffness that one point gives: first A : grad N for every node and component, then
/// grad N : (that). Columns run over the nodes so that the inner loops vectorise.
template <bool Axisymmetric, TangentKind Kind>
void add_stiffness(const ReferenceCell& cell, const material::PointResponse& point, double volume,
                   double inverse_bulk_modulus, CellOutput& out);

/// Copies the blocks above the diagonal to below it.
void mirror_stiffness(const ReferenceCell& cell, CellOutput& out);

}  // namespace detail
}  // namespace soft::element
