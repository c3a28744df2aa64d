#pragma once
/// Newton's method on the bordered system
///   R(x, lambda, p) = 0,   e_k(V_k(x), p_k, lambda) = 0 for the free supplies (stage_loads.hpp),   c = target,
/// with a line search (line_search.hpp) that also keeps det F > 0. Each iteration assembles a new K and eliminates blocks:
///   K a = -R,  K b_k = f_k (force of 1 Pa in supply k),  K b_l = -dR/dlambda;   dx = a + sum dp_k b_k + dlambda b_l,
/// where (dp, dlambda) solve the small system of the e_k and c after inserting dx. With a direct solver, an iteration whose residual
/// is already small does not factorise its K: the previous factor preconditions an iterative solve, to the tolerance that
/// equilibrium requires (inexact Newton: Dembo, Eisenstat and Steihaug, SIAM J. Numer. Anal. 19 (1982) 400).
/// NewtonMethod::modified and bfgs keep the K and the factor of a correction's first iteration for the whole correction;
/// right-hand sides and columns are new in each iteration. bfgs updates it by the pairs dx, R_new - R_old + sum dp_k f_k - dlambda
/// dR/dlambda, which exclude the loads (quasi_newton.hpp). With TangentSource::finite_difference or LinearMethod::jacobian_free,
/// K or K v are differences of R (differences.hpp).
/// Where backtracking finds no descent in a body with fibres or with friction, the correction is repeated without a line search.
/// Equilibrium: |R| <= residual_tolerance x scale of the nodal forces, or |R| no larger than the rounding error of R in the
/// undeformed body. Strains below about 1e-6 vanish in that rounding error; a predictor that is exact to it is not corrected.
/// A Krylov solve that reaches its iteration limit gives an inexact correction; for the path tangent ten times the limit is allowed.
/// Source: Crisfield, Non-linear Finite Element Analysis of Solids and Structures 1 (1991) 9.3; Allgower and Georg,
/// Introduction to Numerical Continuation Methods (2003) 10.4. Tested by solver/solver_test, solver/supply_test,
/// solver/newton_methods_test, solver/linear_methods_test, solver/kink_test, solver/motion_test, solver/tiny_load_test.
#include <optional>
#include <span>

#include "solver/bordered_system.hpp"
#include "solver/line_search.hpp"
#include "solver/quasi_newton.hpp"

namespace soft::solver {

struct NewtonResult {
    NewtonEnd end = NewtonEnd::converged;
    int iterations = 0;
    int halvings = 0;              ///< of the line search (trials beyond the first), over all iterations
    double residual = 0;           ///< |R| over the force scale
    bool within_rounding = false;  ///< converged, with forces so small that their rounding error exceeds the tolerance
    mesh::Index worst_cell = -1;   ///< cell with the smallest det F at the last evaluation
    double min_jacobian = 1;
};

/// Direction of the path at a converged state, per unit of the constraint's value.
struct PathTangent {
    linalg::Vector x;
    double load_factor = 0;
    std::vector<double> pressures;  ///< of the free supplies [Pa]
    /// Number of unstable directions at fixed load factor with every supply as prescribed: 0 = stable. Computed from the
    /// negative pivots of K in excess of one per pressure unknown, less those that the volume and gas of the free supplies stabilise
    /// (Haynsworth: inertia of the bordered matrix). Where the count changes from one tangent to the next it must agree with
    /// the sign of the determinant (linear_solver.hpp). With an LU factor only the parity is known: 0 or 1; nullopt where the
    /// linear solver gives neither.
    std::optional<int> unstable_modes;
    /// Work of the stage's growing loads along the tangent if every free supply kept its volume or mass, -dR/dlambda . x:
    /// positive in a stable state, whatever the supplies do (a volume that grows against a load gives work < 0).
    /// 0 in a stage that moves a face: there -dR/dlambda has entries in the pressure rows of mixed cells, and the product, which
    /// depends on how the motion is extended into the body, may have either sign in a stable state.
    double power = 0;
};

/// That of a state from which the path does not go on, or whose direction is not needed: zero.
[[nodiscard]] PathTangent no_tangent(const State& state);

/// Multiplies everything per unit of the path parameter by `factor`.
void scale(PathTangent& tangent, double factor);
/// to += factor x term, of the unknowns, the load factor and the pressures
void add(PathTangent& to, double factor, const PathTangent& term);

class Newton {
public:
    Newton(fem::System& system, const model::SolverSettings& settings);

    [[nodiscard]] fem::System& system() noexcept { return bordered_.system; }

    /// Sets the loads of all later calls; not owned.
    void set_loads(const StageLoads& loads);

    /// Moves `state` to equilibrium with c = target. On failure `state` holds the last admissible iterate.
    [[nodiscard]] NewtonResult correct(const Constraint& constraint, double target, State& state);
    /// The next correction starts where the last one ended, with its factor. The inertia of the tangent after it may be that of this factor.
    void keep_factor() { keeps_factor_ = true; }

    /// Later corrections of states that are only compared end where all further increments are expected to be shorter than this part of
    /// the unknowns, if they shrink by the factor of the last two (Newton's method: by its square). Not in contact.
    void accept_change(double relative) { accepted_change_ = relative; }

    /// Tangent of the path at a converged state. Its inertia comes from the factor of the last correction if there was one
    /// (that state differs from this one by less than the last correction squared), else from a new factor. nullopt where K is
    /// singular or the linear solver fails: tangent_end() gives the reason.
    [[nodiscard]] std::optional<PathTangent> tangent(const Constraint& constraint, const State& state);

    [[nodiscard]] NewtonEnd tangent_end() const noexcept { return tangent_end_; }

    /// R at the state of the last tangent(); not on a path in time with viscoelastic rubber.
    [[nodiscard]] Vec residual() const noexcept { return bordered_.R; }

    /// M^-1 (b, rows) with the bordered matrix M of the state and constraint of the last tangent() or evaluate_rows(); `rows`: of the
    /// supplies and the constraint, those that are left out are 0.
    [[nodiscard]] std::optional<PathTangent> bordered_solve(Vec b, std::span<const double> rows = {});

    /// The functional (by_x . x + by_loads . (p, lambda)) of M^-1 (b, rows, 0) as psi . b + mu . rows. nullopt where
    /// LinearSolver::solve_transposed fails.
    struct Adjoint {
        linalg::Vector psi;
        std::vector<double> mu;  ///< of the supplies
    };
    [[nodiscard]] std::optional<Adjoint> adjoint_solve(Vec by_x, std::span<const double> by_loads);

    /// Changes the constraint of M, at the state of the last tangent().
    void evaluate_rows(const Constraint& constraint, const State& state);

    /// What a state misses of equilibrium and the constraint, (-R, -e_k, target - c); nullopt where cells are inverted. Keeps K and its
    /// columns; evaluate_rows() restores the rest of M. Prescribes the motions of the state.
    struct Miss {
        linalg::Vector R;
        std::vector<double> rows;
    };
    [[nodiscard]] std::optional<Miss> miss(const Constraint& constraint, double target, const State& state);

    /// Four times the rounding error of R in the undeformed body, as a force.
    [[nodiscard]] double rounding_N() const;
    /// That error in units of the path parameter: relative to the forces of the tangent's loads.
    [[nodiscard]] double rounding_of_loads(const PathTangent& tangent) const;

    /// Negative pivots of K in excess of one per pressure unknown at the last tangent(), to which the next one is compared. A path
    /// that is resumed sets it.
    [[nodiscard]] int confirmed_pivots() const noexcept { return confirmed_pivots_; }
    void confirm_pivots(int pivots) noexcept { confirmed_pivots_ = pivots; }

    /// See BorderedSystem.
    [[nodiscard]] double share_without_crossing(const State& from, const State& to) {
        return bordered_.share_without_crossing(from, to);
    }
    [[nodiscard]] bool passes_through_obstacle(const State& from, const State& to) {
        return bordered_.passes_through_obstacle(from, to);
    }
    void couple_contact(const State& state) { bordered_.couple_contact(state); }
    void forget_assembly() { bordered_.forget_assembly(); }
    void set_drag(double drag, Vec origin) { bordered_.set_drag(drag, origin); }

    [[nodiscard]] int factorizations() const noexcept { return bordered_.linear.factorizations(); }
    [[nodiscard]] long linear_iterations() const noexcept { return bordered_.linear.iterations(); }

private:
    /// State of a correction in progress.
    struct Correction {
        fem::Evaluation evaluation;  // the last
        double residual = 0;         // |R| at the state
        double first_force_scale = 0, constraint_tolerance = 0;
        double missing = 0;                    // of the constraint: target - c
        double change = 0, change_before = 0;  // of the unknowns in the last two iterations, relative to them
        double length = 1;                     // of the last line search
        bool loads_stay = false;  // the loads equal those of the target: the increment is K^-1 (-R), without columns
        double aim = 0;           // |R| that counts as equilibrium
        model::LineSearch line_search = model::LineSearch::backtracking;
        NewtonResult result;
    };
    /// The increment dx is in correction_; these are the increments of the bordered unknowns.
    struct Increment {
        std::vector<double> loads;  // of the free supplies' pressures and the load factor
        double pending = 0;         // the remaining residual and loads, as a force
    };

    // newton.cpp
    [[nodiscard]] NewtonResult correct_by(model::LineSearch line_search, const Constraint& constraint, double target,
                                          State& state);
    [[nodiscard]] std::optional<NewtonEnd> check_convergence(const State& state, Correction& now);
    [[nodiscard]] bool is_rounding(const State& state, const Correction& now);
    [[nodiscard]] bool is_close(const State& state, const Correction& now) const;
    [[nodiscard]] std::optional<NewtonEnd> solve_blocks(const State& state, const Correction& now);
    /// True if the previous factor was good enough for this iteration.
    [[nodiscard]] bool solve_with_kept_factor(const Correction& now);
    [[nodiscard]] std::optional<Increment> increment(const Correction& now);
    [[nodiscard]] Search move(const Increment& step, const State& state, State& trial, Correction& now);
    void add_secant_pair(double length);
    [[nodiscard]] linalg::LinearSolve solve_updated(Vec b, Vec x, double tolerance);

    // newton_tangent.cpp
    /// Solves for the columns at the state of the last evaluation, with the last factor or, if that is not accurate enough, a new one.
    [[nodiscard]] std::optional<NewtonEnd> solve_tangent_columns();
    [[nodiscard]] linalg::LinearSolve solve_accurately(Vec b, Vec x, linalg::SolveSettings how);
    [[nodiscard]] std::optional<PathTangent> eliminate(Vec b, std::span<const double> rows);
    [[nodiscard]] std::optional<Adjoint> eliminate_transposed(Vec by_x, std::vector<double> by_border);
    [[nodiscard]] std::optional<int> unstable_modes();
    /// Negative pivots of K in excess of one per pressure unknown, after the check against the sign of the determinant.
    [[nodiscard]] std::optional<int> excess_pivots();

    BorderedSystem bordered_;
    /// Rounding error of the residual in the undeformed body: the resolution of equilibrium under tiny loads.
    double rounding_N_ = 0;
    double residual_at_factor_ = 0;  // |R| where the factor was computed
    bool keeps_factor_ = false;      // for the next correction
    double accepted_change_ = 0;
    bool linear_limit_met_ = false;  // in the last iteration
    NewtonEnd tangent_end_ = NewtonEnd::converged;
    bool loses_digits_ = false;  // K^-1 at the last tangent
    int confirmed_pivots_ = 0;   // excess_pivots() of the tangent before
    linalg::Vector correction_;  // a, then dx
    SecantUpdates updates_;
    linalg::Vector minus_R_before_, load_change_;  // of the secant pair to come: sum of (dp_k, dlambda) f
};

}  // namespace soft::solver
