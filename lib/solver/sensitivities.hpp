#pragma once
/// Derivatives of the rows of a path by numbers of the design, theta: dimensions, constants of materials, loads, obstacles.
/// A row satisfies R(x, lambda, p; theta) = 0 and e_k(..; theta) = 0 (newton.hpp). Its derivative at a fixed position along the path,
///   M (dx, dlambda, dp) = -(dR/dtheta, de/dtheta, 0),     M the bordered matrix of the row with the constraint t . dx = 0, t = dx/dq,
/// exists at limit points too. In a stage with a time, where the leading load is held (model::holds_load) and where nothing moves, the
/// constraint is lambda instead: the derivative is at a fixed time or at the same progress of the loads, and not at a limit point.
/// dR/dtheta, de/dtheta and the derivatives of the outputs are differences between two systems with theta a little smaller and larger
/// (geometry/variations.hpp), at the same state and at the states moved along the derivative; so they include whatever depends on theta:
/// nodes, constants, loads, contact, definitions of outputs. Each system has internal variables of its own, which follow the moved states
/// along the path, so the derivatives are those of the computed path in its steps. With D the derivative of the leading load or of an
/// output, and T their slopes along the path, the derivative
///   of the load at a fixed output is D_load - T_load D_output / T_output, at a limit point that of the limit load,
///   of the output at a fixed load  D_output - T_output D_load / T_load,
/// and D itself at a fixed time or where the leading load is held.
/// Where the values of a row are fewer than the parameters, their adjoints psi replace the derivatives of the state: with (psi, mu) = M^-T dv/d(x, lambda, p),
///   D_v = dv/dtheta at the state of the row - psi . dR/dtheta - mu . de/dtheta,
/// and the part of the cells in psi . dR/dtheta of a dimension is the shape gradient (fem/shape_gradient.hpp) times the motion of the nodes.
/// Not in contact, nor with an LU factor, inelastic rubber, a value that is a reaction, or where the next stage needs the state.
/// Source: Haug, Choi and Komkov, Design Sensitivity Analysis of Structural Systems (1986); Reitinger, Bletzinger and Ramm, Comput. Syst. Eng. 5
/// (1994) 65, for limit loads. The form by the tangent of the path: derived here.
/// Tested by solver/sensitivities_test, pipeline/sensitivities and pipeline/inelastic_fits.
#include <array>
#include <span>
#include <vector>

#include "fem/shape_gradient.hpp"
#include "solver/corrector.hpp"
#include "solver/path_state.hpp"

namespace soft::solver {

/// Whether the derivatives of a row end with that of stretch_p99, a quantile over the cells.
enum class WithStretch { no, yes };

class Sensitivities {
public:
    /// `base`: the system of the path. `variations`: the cases with the lower and the higher value of each of its parameters. Both must
    /// outlive this.
    Sensitivities(const fem::System& base, std::span<const std::array<model::Case, 2>> variations,
                  WithStretch stretch = WithStretch::no);
    ~Sensitivities();

    /// Fills step.derivatives. Collective. Throws Error (bad_input) where the bordered matrix is singular.
    void evaluate(Corrector& corrector, const PathState& path, const PathPoint& point, model::Step& step);
    /// The point of the last evaluate() is accepted: the next step starts from it. Collective.
    void accept_step();

private:
    struct Side;
    struct Parameter;
    struct End;
    enum class Cells { no, yes };  ///< whether R includes the forces of the cells
    /// `known`: R, where it is.
    [[nodiscard]] End evaluate_at(Side& side, const State& state, Cells cells = Cells::yes, Vec known = nullptr) const;
    struct Adjoint {
        Newton::Adjoint of;
        std::vector<Vector3> by_position;  ///< d(psi . R)/dX of the cells, by node
    };
    /// Of the leading load and the outputs; empty where derivatives of the state are needed or cheaper.
    [[nodiscard]] std::vector<Adjoint> adjoints_at(Newton& newton, const PathState& path, const PathPoint& point);
    /// -psi . dR - mu . de between both systems, over the change; `cells`: those of R.
    [[nodiscard]] static double through_state(const Adjoint& adjoint, const Side& lower, const End& before,
                                              const Side& higher, const End& after, Cells cells);
    /// The derivative of the state from the residuals of both systems at one state. Overwrites before.R.
    [[nodiscard]] static PathTangent direction_between(Newton& newton, const End& before, const End& after,
                                                       double change);
    /// The tangent of softened rubber jumps where loading turns into unloading. Between the states at which both systems are compared
    /// a point may lie on either side, but the moved states lie on the side of the path.
    void correct_at_moved_states(Newton& newton, const State& state, Side& lower, Side& higher,
                                 PathTangent& direction) const;
    /// The point of one of the systems that corresponds to a point of the path, with its values.
    [[nodiscard]] static PathPoint moved_point(const Side& side, const PathPoint& point, const PathTangent& direction);
    /// The slope of a goal's quantity along the path.
    [[nodiscard]] static double slope_at(const Goal& goal, const PathPoint& point, const Side& base);
    /// Changes the derivative of a state to that at a fixed value of a goal's quantity.
    static void move_to_goal(const Goal& goal, const PathPoint& point, const Side& base, const Side& lower,
                             const Side& higher, PathTangent& direction);

    const fem::System& base_;
    WithStretch stretch_;
    bool may_use_adjoints_ = false;
    fem::ShapeGradient shape_gradient_;
    std::vector<Parameter> parameters_;
    std::vector<double> last_;  // derivatives of the last row
};

}  // namespace soft::solver
