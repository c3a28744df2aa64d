#pragma once
/// Residual and tangent stiffness of one cell: finite strain, total Lagrangian, any law, with or without a pressure unknown.
///   R_u = int P(F, p) : grad(du) dV,   R_p = int dp (Theta(J) - p / K) dV,
///   stiffness = derivative of (R_u, R_p) with respect to (u, p); symmetric, except for a law without an energy function.
/// In F-bar form P and F are those of fem/f_bar.hpp. Kinematics and numbering: fem/cell_kinematics.hpp.
/// Tested by fem/solid_kernel_test and fem/matrix_test (every law in every cell and form: Taylor remainders,
/// symmetry, rigid motion, constant gradients), fem/rank_test, fem/f_bar_test.
#include <stdexcept>

#include "fem/cell_kinematics.hpp"
#include "fem/f_bar.hpp"

namespace soft::fem {

/// State of one quadrature point, for output.
struct PointState {
    Tensor F;      ///< of the displacement; gives the reported stretch, and det F <= 0 indicates an inverted cell
    Tensor F_law;  ///< argument of the law for stress and energy: F, in F-bar form F-bar
    material::FiberAxes axes;  ///< fibre frame
    double p_Pa;               ///< value of the pressure unknown (0 if the form has none)
    double weight_m3;          ///< reference volume of the point (includes 2 pi R)
};

namespace detail {

/// Maps the points and evaluates the law; false where det F <= 0: the caller reports the cell, and the energy is undefined.
template <bool Axisymmetric, class L>
[[nodiscard]] bool evaluate_points(const ReferenceCell& cell, const material::Rubber<L>& rubber, const CellInput& in,
                                   material::Wanted wanted, CellOutput& out) {
    map_points<Axisymmetric>(cell, in, out.points);
    out.min_jacobian = min_jacobian(cell, out.points);
    if (!(out.min_jacobian > 0.0)) return false;
    if (rubber.fibers) find_fiber_axes<Axisymmetric>(cell, rubber.fiber_frame, out.points);
    material::evaluate_batch(rubber, cell.form, wanted, out.points.law);
    return true;
}

template <bool Axisymmetric, class L>
void integrate(const ReferenceCell& cell, const material::Rubber<L>& rubber, const CellInput& in,
               material::Wanted wanted, CellOutput& out) {
    constexpr auto kind = material::StressLaw<L> ? TangentKind::full : TangentKind::symmetric;
    if (!evaluate_points<Axisymmetric>(cell, rubber, in, wanted, out)) return;
    sum_residual<Axisymmetric>(cell, rubber.inverse_bulk_modulus, out);
    if (wanted == material::Wanted::stress_and_tangent)
        sum_stiffness<Axisymmetric, kind>(cell, rubber.inverse_bulk_modulus, out);
}

template <bool Axisymmetric, class L>
void integrate_form(const ReferenceCell& cell, const material::Rubber<L>& rubber, const CellInput& in,
                    material::Wanted wanted, CellOutput& out) {
    if (cell.form != Form::f_bar) return integrate<Axisymmetric>(cell, rubber, in, wanted, out);
    if constexpr (FBarLaw<L>)
        integrate_f_bar<Axisymmetric>(cell, rubber, in, wanted, out);
    else
        throw std::logic_error("integrate_cell: the law has no F-bar form");
}

}  // namespace detail

/// Residual (and stiffness) of a cell. If det F <= 0 at a point, out.min_jacobian <= 0 and the other outputs are not computed.
/// An unsupported combination of law and form (material::explain_incompatibility) is a std::logic_error; callers check it before.
template <class L>
void integrate_cell(const ReferenceCell& cell, model::Kinematics kinematics, const material::Rubber<L>& rubber,
                    const CellInput& in, material::Wanted wanted, CellOutput& out) {
    if (kinematics == model::Kinematics::axisymmetric)
        return detail::integrate_form<true>(cell, rubber, in, wanted, out);
    return detail::integrate_form<false>(cell, rubber, in, wanted, out);
}

/// The derivative of psi . R by the positions of the nodes at fixed unknowns, for some psi in the numbering of the unknowns: shape[k] receives that
/// of psis[k], component by component. Moving the nodes by V changes grad to -grad(.) grad(V) and dV by div V:
///   d(psi . R) = int [w div V - (grad(u)^T T + grad(psi)^T P) : grad(V) + b . V] dV,
///   T = grad(psi) : A + psi_p dTheta/dF,  w = P : grad(psi) + psi_p (Theta - p / K),
/// and in an axisymmetric section V_r / r is the hoop component of grad(V). b accounts for the functions of a discontinuous pressure, which are
/// linear in the position; their origin and scale stay. Only for cells that det F > 0 at all points, not for F-bar cells, and
/// without fibre frames that depend on the position (shape_gradient.hpp).
/// Source: Haug, Choi and Komkov, Design Sensitivity Analysis of Structural Systems (1986), ch. 3; this form: derived here.
template <class L>
void find_shape_gradients(const ReferenceCell& cell, model::Kinematics kinematics, const material::Rubber<L>& rubber,
                          const CellInput& in, std::span<const std::vector<double>> psis, CellOutput& out,
                          std::vector<std::vector<double>>& shape) {
    const auto find = [&]<bool Axisymmetric>(std::bool_constant<Axisymmetric>) {
        shape.assign(psis.size(), std::vector<double>(in.X.size(), 0.0));
        if (!detail::evaluate_points<Axisymmetric>(cell, rubber, in, material::Wanted::stress_and_tangent, out)) return;
        const std::vector<double> stress = out.points.law.first_piola;
        for (std::size_t k = 0; k < psis.size(); ++k)
            detail::sum_shape_gradient<Axisymmetric>(cell, rubber.inverse_bulk_modulus, in, psis[k], stress, out,
                                                     shape[k]);
    };
    if (kinematics == model::Kinematics::axisymmetric) return find(std::true_type{});
    return find(std::false_type{});
}

/// Appends the states of a cell's quadrature points to `states`; `frame` is that of the cell's rubber, `points` is work space.
void sample_cell(const ReferenceCell& cell, model::Kinematics kinematics, material::FiberFrame frame,
                 const CellInput& in, CellPoints& points, std::vector<PointState>& states);

/// Energy W per undeformed volume [J/m^3] at a point; in mixed form W(F, p) of material/law.hpp (equal to the energy of the state if
/// p = K Theta holds, which it does weakly). The derivative of the integral over the cell is the residual. 0 for a law without an
/// energy function.
template <class L>
[[nodiscard]] double energy_density(Form form, const material::Rubber<L>& rubber, const PointState& point) {
    const auto parts = material::energy_parts(rubber, point.axes, point.F_law);
    if (!parts) return 0.0;
    const double theta = parts->dilatation, inverse = rubber.inverse_bulk_modulus, p = point.p_Pa;
    return parts->shear + (form == Form::mixed ? p * (theta - 0.5 * p * inverse) : 0.5 * theta * theta / inverse);
}

/// The pressure of one cell at its nodes [Pa], for output; a discontinuous pressure is evaluated from this cell only.
[[nodiscard]] std::vector<double> nodal_pressures(const ReferenceCell& cell, std::span<const double> X,
                                                  std::span<const double> unknowns, double pressure_scale_Pa);

}  // namespace soft::fem
