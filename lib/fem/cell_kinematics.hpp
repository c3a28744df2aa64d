#pragma once
/// Input and output of a cell, and the functions that all kernels share: the map at the quadrature points, F, and the sums over the
/// points. F = I + grad u in the reference configuration; axisymmetric: F_33 = r/R and dV = 2 pi R dX dR.
/// Element unknowns are numbered component by component: u_x of all nodes, u_y (u_r) of all nodes, (u_z), pressures.
/// Used by fem/solid_kernel.hpp. Tested by fem/solid_kernel_test and fem/matrix_test.
#include <span>
#include <vector>

#include "fem/reference_cell.hpp"
#include "material/point_batch.hpp"
#include "math/tensor.hpp"
#include "model/case.hpp"

namespace soft::fem {

/// Input of a cell. All spans are component-major, as the unknowns.
struct CellInput {
    std::span<const double> X;                     ///< reference coordinates [m], dimension x nodes
    std::span<const double> u;                     ///< displacement [m], dimension x nodes
    std::span<const double> p;                     ///< pressure unknowns (p = pressure_scale x unknown x basis)
    double pressure_scale_Pa = 1;                  ///< balances displacement and pressure rows; see fem/dof_map.hpp
    const material::StepMemory* memory = nullptr;  ///< internal variables of its points; nullptr: elastic
};

/// Data at the quadrature points of a cell: component c of point q is at [c * stride + q], with the stride of `law`. law.F is the
/// gradient of the displacement unless an element form (F-bar) replaces it.
struct CellPoints {
    explicit CellPoints(const ReferenceCell& cell);

    std::vector<double> values;    ///< [X_i, then u_i][by xi_d, then at the point]
    std::vector<double> inverse;   ///< [3 J + d] dxi_d/dX_J
    std::vector<double> volume;    ///< reference volume [m^3], 2 pi R included; zero beyond the last point
    std::vector<double> jacobian;  ///< det F
    std::vector<double>
        gradient;  ///< [direction][point][node], not padded, followed by lane_count spare entries: dN/dX, then N/R if axisymmetric
    std::vector<double> basis;  ///< [pressure function], scaled so that p [Pa] = sum basis x unknown
    material::PointBatch law;
};

/// Output of a cell with the work space; created once per thread and cell type and reused for every cell.
struct CellOutput {
    explicit CellOutput(const ReferenceCell& cell)
        : residual(cell.dofs()), stiffness(static_cast<std::size_t>(cell.dofs()) * cell.dofs()), points(cell) {}

    std::vector<double> residual;   ///< [N] (pressure rows in the scaled unknown)
    std::vector<double> stiffness;  ///< row-major, dofs x dofs
    double min_jacobian = 1;        ///< minimum of det F over the quadrature points
    CellPoints points;
    std::vector<double> product;  ///< work space: A : grad N at all points
};

namespace detail {

/// Computes volume, jacobian, gradient, F, and in mixed form basis and law.p; passes the memory on to the law.
template <bool Axisymmetric>
void map_points(const ReferenceCell& cell, const CellInput& in, CellPoints& points);

[[nodiscard]] double min_jacobian(const ReferenceCell& cell, const CellPoints& points);

/// The pressure functions at a node, multiplied by `scale_Pa`.
void pressure_functions_at(const ReferenceCell& cell, std::span<const double> X, int node, double scale_Pa,
                           std::span<double> basis);

/// d(basis)/dX of the linear functions of a discontinuous pressure, multiplied by `scale_Pa`; 0 for other pressures.
[[nodiscard]] double pressure_slope(const ReferenceCell& cell, std::span<const double> X, double scale_Pa);

/// Computes the fibre frames at the points (law.axes): e1 = x, e2 = y or the hoop direction about x. A section of a body of revolution
/// uses the axes (x, r, hoop), so the hoop direction is the third axis.
template <bool Axisymmetric>
void find_fiber_axes(const ReferenceCell& cell, material::FiberFrame frame, CellPoints& points);

/// Computes the residual from the stresses of the law.
template <bool Axisymmetric>
void sum_residual(const ReferenceCell& cell, double inverse_bulk_modulus, CellOutput& out);

/// symmetric: only the blocks on and above the diagonal are computed, then mirrored.
enum class TangentKind { symmetric, full };

/// Computes the stiffness from the tangents A of the law: first A : grad N for every point, node and component, then for each component
/// one matrix product with grad N.
template <bool Axisymmetric, TangentKind Kind>
void sum_stiffness(const ReferenceCell& cell, double inverse_bulk_modulus, CellOutput& out);

/// The derivative of psi . R by the positions of the nodes (solid_kernel.hpp) from the law's response with its tangent; `stress` is its P.
/// Overwrites the P of the points and the residual.
template <bool Axisymmetric>
void sum_shape_gradient(const ReferenceCell& cell, double inverse_bulk_modulus, const CellInput& in,
                        std::span<const double> psi, std::span<const double> stress, CellOutput& out,
                        std::vector<double>& shape);

}  // namespace detail
}  // namespace soft::fem
