#pragma once
/// F-bar for first-order quadrilaterals and hexahedra: the law is evaluated at Fbar = (Jm/J)^(1/3) F, whose dilatation is the mean of the
/// cell. A nearly incompressible cell therefore has one volume constraint and does not lock.
///   Jm = v/V,  v = int J dV,  V = int dV,   W_cell = int W(Fbar) dV,  residual and stiffness its derivatives.
/// For laws split into an isochoric and a volumetric part this is the mean-dilatation element Q1/P0. The element of de Souza Neto et
/// al., IJSS 33 (1996) 3277, differs: it uses J at the centroid instead of Jm and omits the variation of Fbar in the residual, which
/// gives a non-symmetric tangent. In plane strain and axisymmetry J is that of the three-dimensional F and all three
/// diagonal components are scaled, so Fbar_33 = (Jm/J)^(1/3) also in plane strain: a quad4 is then exactly a slice of hex8 between
/// rigid walls, and the isochoric part of a law remains the three-dimensional one.
///
/// With Q = F^-T, s = (Jm/J)^(1/3), P' = s P(Fbar), A' = s^2 A(Fbar), t = P' : F, tau = J/(3v) int t dV,
/// h = F : A' + P', b = h : F, and g = d ln Jm = (1/v) int J Q : grad dV (a vector over the unknowns):
///   residual  = int P* : grad dV,   P* = P' - (t/3) Q + tau Q
///   stiffness = int grad : A* : grad dV + (g B + B g) + c g g
///   A*_iJkL = A' - (Q h + h Q)/3 + (b/9 + tau) Q_iJ Q_kL + (t/3 - tau) Q_iL Q_kJ
///   B = int (h/3 - (b/9) Q) : grad dV,   c = int (b/9 - t/3) dV.
/// Sources: Simo, Taylor, Pister, CMAME 51 (1985) 177; Elguedj et al., CMAME 197 (2008) 2732; the second variation in
/// this form is derived here. Tested by fem/f_bar_test and fem/matrix_test.
#include <array>
#include <cmath>

#include "fem/cell_kinematics.hpp"

namespace soft::fem::detail {

inline constexpr int max_f_bar_points = 8;  // hex8

/// A law that can be used with F-bar (LawInfo::f_bar): its energy is a function of the finite F.
template <class L>
concept FBarLaw = !material::StressLaw<L> && !std::same_as<L, material::LinearElastic>;

/// Kinematics at the points of a cell.
struct FBarState {
    std::array<double, max_f_bar_points> volume{};  ///< reference volume
    std::array<double, max_f_bar_points> jacobian{};
    std::array<Tensor, max_f_bar_points> F{};
    double reference_volume = 0, current_volume = 0;  ///< V, v
    double min_jacobian = 1;

    /// s = (Jm/J)^(1/3) at point q.
    [[nodiscard]] double scale(int q) const {
        return std::cbrt(current_volume / (reference_volume * jacobian[static_cast<std::size_t>(q)]));
    }
    /// Fbar at point q.
    [[nodiscard]] Tensor law_gradient(int q) const {
        Tensor F_law = F[static_cast<std::size_t>(q)];
        for (double& f : F_law) f *= scale(q);
        return F_law;
    }
};

/// Requires points filled by map_points.
[[nodiscard]] FBarState f_bar_state(const ReferenceCell& cell, const CellPoints& points);

/// Computes residual and stiffness from P(Fbar) and A(Fbar) in out.points.law, which are overwritten by P* and A*.
template <bool Axisymmetric>
void assemble_f_bar(const ReferenceCell& cell, const FBarState& state, material::Wanted wanted, CellOutput& out);

template <bool Axisymmetric, class L>
void integrate_f_bar(const ReferenceCell& cell, const material::Rubber<L>& rubber, const CellInput& in,
                     material::Wanted wanted, CellOutput& out) {
    map_points<Axisymmetric>(cell, in, out.points);
    const FBarState state = f_bar_state(cell, out.points);
    out.min_jacobian = state.min_jacobian;
    if (!(state.min_jacobian > 0.0)) return;
    if (rubber.fibers) find_fiber_axes<Axisymmetric>(cell, rubber.fiber_frame, out.points);
    for (int q = 0; q < cell.points; ++q) out.points.law.set_gradient(q, state.law_gradient(q));
    material::evaluate_batch(rubber, cell.form, wanted, out.points.law);
    assemble_f_bar<Axisymmetric>(cell, state, wanted, out);
}

}  // namespace soft::fem::detail
