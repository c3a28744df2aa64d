#pragma once
/// What a cell is given and returns, and what all its kernels share: the map of its points, F, and the sums over the points.
/// F = I + grad u in the reference configuration; axisymmetric: F_33 = r/R and dV = 2 pi R dX dR.
/// Element unknowns are numbered component by component: u_x of all nodes, u_y (u_r) of all nodes, (u_z), pressures.
/// For element/solid_kernel.hpp, whose tests hold it.
#include <span>
#include <vector>

#include "core/tensor.hpp"
#include "element/reference_cell.hpp"
#include "material/point_batch.hpp"
#include "model/case.hpp"

namespace soft::element {

/// What a cell needs. All spans are component-major as the unknowns.
struct CellInput {
    std::span<const double> X;     ///< reference coordinates [m], dimension x nodes
    std::span<const double> u;     ///< displacement [m], dimension x nodes
    std::span<const double> p;     ///< pressure unknowns (p = pressure_scale x unknown x basis)
    double pressure_scale_Pa = 1;  ///< makes displacement and pressure rows alike in size; see assembly/dof_map.hpp
};

/// The quadrature points of a cell, side by side: component c of point q at [c * stride + q] with the stride of `law`, whose F
/// is that of the displacement until an element form puts another in its place.
struct CellPoints {
    explicit CellPoints(const ReferenceCell& cell);

    std::vector<double> values;    ///< [X_i, then u_i][by xi_d, then at the point]
    std::vector<double> inverse;   ///< [3 J + d] dxi_d/dX_J
    std::vector<double> volume;    ///< reference volume [m^3], 2 pi R included; zero beyond the last point
    std::vector<double> jacobian;  ///< det F
    std::vector<double>
        gradient;  ///< [direction][point][node], not padded but with a vector's room behind: dN/dX, then N/R for bodies of revolution
    std::vector<double> basis;  ///< [pressure function], scaled so that p [Pa] = sum basis x unknown
    material::PointBatch law;
};

/// What a cell returns, with the work space it needs; made once a thread and cell type, reused for every cell.
struct CellOutput {
    explicit CellOutput(const ReferenceCell& cell)
        : residual(cell.dofs()), stiffness(static_cast<std::size_t>(cell.dofs()) * cell.dofs()), points(cell) {}

    std::vector<double> residual;   ///< [N] (pressure rows in the scaled unknown)
    std::vector<double> stiffness;  ///< row-major, dofs x dofs
    double min_jacobian = 1;        ///< least det F over the quadrature points
    CellPoints points;
    std::vector<double> product;  ///< work space: A : grad N at all points
};

namespace detail {

/// Fills volume, jacobian, gradient, F, and in mixed form basis and law.p.
template <bool Axisymmetric>
void map_points(const ReferenceCell& cell, const CellInput& in, CellPoints& points);

[[nodiscard]] double min_jacobian(const ReferenceCell& cell, const CellPoints& points);

/// The pressure functions at a node, scaled.
void pressure_functions_at(const ReferenceCell& cell, std::span<const double> X, int node, double scale_Pa,
                           std::span<double> basis);

/// The fibre frames at the points into law.axes: e1 = x, e2 = y or the hoop direction about x. A section of a body of revolution
/// lies in (x, r, hoop), so its hoop is the third axis.
template <bool Axisymmetric>
void find_fiber_axes(const ReferenceCell& cell, material::FiberFrame frame, CellPoints& points);

/// The residual from the law's answers.
template <bool Axisymmetric>
void sum_residual(const ReferenceCell& cell, double inverse_bulk_modulus, CellOutput& out);

/// symmetric: only the blocks on and above the diagonal are computed, then mirrored.
enum class TangentKind { symmetric, full };

/// The stiffness from the law's answers: first A : grad N for every point, node and component, then one product of matrices
/// grad N : (that) a component.
template <bool Axisymmetric, TangentKind Kind>
void sum_stiffness(const ReferenceCell& cell, double inverse_bulk_modulus, CellOutput& out);

}  // namespace detail
}  // namespace soft::element
