#pragma once
/// Newton's method on the bordered system
///   R(x, lambda, p) = 0,   e_k(V_k(x), p_k, lambda) = 0 for the free supplies (stage_loads.hpp),   c = target,
/// with a line search (line_search.hpp) that also keeps det F > 0. Each iteration has a new K and eliminates blocks:
///   K a = -R,  K b_k = f_k (force of 1 Pa in supply k),  K b_l = -dR/dlambda;   dx = a + sum dp_k b_k + dlambda b_l,
/// where (dp, dlambda) solve the small system of the e_k and c with dx put in. With a direct solver the K of an iteration that has
/// little left to do is not factorised: the factor before it preconditions the solves, which go no further than equilibrium
/// asks for (inexact Newton: Dembo, Eisenstat and Steihaug, SIAM J. Numer. Anal. 19 (1982) 400). NewtonMethod::modified and bfgs keep the K of a
/// correction's first iteration, and its factor, for all of it; right-hand sides and columns are new in each. bfgs learns from
/// the pairs dx, R_new - R_old + sum dp_k f_k - dlambda dR/dlambda, which leaves the loads out (quasi_newton.hpp). Where
/// TangentSource::finite_difference or LinearMethod::jacobian_free is chosen, K or K v are differences of R (differences.hpp).
/// Where backtracking finds no descent in a body with fibres, the correction begins again without a line search.
/// Equilibrium: |R| <= residual_tolerance x scale of the nodal forces, or no more than rounding leaves of it in the undeformed body,
/// where strains below 1e-6 or so drown: a predictor that is exact to that is not corrected.
/// A Krylov solve that reaches its limit gives an inexact correction; the direction of the path may take ten times the limit.
/// Source: Crisfield, Non-linear Finite Element Analysis of Solids and Structures 1 (1991) 9.3; Allgower and Georg,
/// Introduction to Numerical Continuation Methods (2003) 10.4. Tested by solver/solver_test, solver/supply_test,
/// solver/newton_methods_test, solver/linear_methods_test, solver/corner_test, solver/motion_test, solver/tiny_load_test.
#include <functional>
#include <optional>

#include "linalg/linear_solver.hpp"
#include "linalg/small_matrix.hpp"
#include "solver/constraint.hpp"
#include "solver/differences.hpp"
#include "solver/line_search.hpp"
#include "solver/quasi_newton.hpp"

namespace soft::solver {

/// not_definite: CHOLMOD has met a tangent with another than positive pivots. linear_solver: no solution of the linear systems
/// to the wanted tolerance, and without it no equilibrium.
enum class NewtonEnd {
    converged,
    inverted,
    iteration_limit,
    no_descent,
    singular,
    not_definite,
    linear_solver,
    not_finite
};
/// For a sentence about the failure.
[[nodiscard]] std::string_view text_of(NewtonEnd end);

struct NewtonResult {
    NewtonEnd end = NewtonEnd::converged;
    int iterations = 0;
    int halvings = 0;              ///< of the line search (trials beyond the first), over all iterations
    double residual = 0;           ///< |R| over the force scale
    bool within_rounding = false;  ///< converged, of forces so small that rounding is more of them than the tolerance
    mesh::Index worst_cell = -1;   ///< cell with the least det F at the last evaluation
    double min_jacobian = 1;
};

/// Direction of the path at a converged state, per unit of the constraint's value.
struct PathTangent {
    linalg::Vector x;
    double load_factor = 0;
    std::vector<double> pressures;  ///< of the free supplies [Pa]
    /// Directions in which the body gives way at fixed load factor with every supply as prescribed: 0 = stable. From the
    /// negative pivots of K beyond one a pressure unknown, less what volume and gas of the free supplies hold back
    /// (Haynsworth: inertia of the bordered matrix). Where the count changes from one tangent to the next it must agree with
    /// the sign of the determinant (linear_solver.hpp). With an LU factor only the parity is known: 0 or 1; nullopt where the
    /// linear solver knows neither.
    std::optional<int> unstable_modes;
    /// Work of the stage's growing loads along the tangent were every free supply to hold its volume or mass, -dR/dlambda . x:
    /// positive in a stable state, whatever the supplies do meanwhile (a volume that grows against a load lets it do work < 0).
    /// 0 in a stage that moves a face: there -dR/dlambda has entries in the pressure rows of mixed cells, and the product, which
    /// depends on how the motion is continued into the body, may have either sign in a stable state.
    double power = 0;
};

/// Changes the parameter of the path: everything per unit of it is multiplied by `factor`.
void scale(PathTangent& tangent, double factor);

class Newton {
public:
    Newton(assembly::System& system, const model::SolverSettings& settings);

    /// The loads of all that follows; not owned.
    void set_loads(const StageLoads& loads);

    /// Moves `state` to equilibrium with c = target. On failure `state` holds the last admissible iterate.
    [[nodiscard]] NewtonResult correct(const Constraint& constraint, double target, State& state);

    /// Direction of the path at a converged state, its inertia from the factor of the last correction where there was one
    /// (a state that the correction has moved by less than its own square), else from a new one. nullopt where K is
    /// singular or the linear solver fails: tangent_end() says which.
    [[nodiscard]] std::optional<PathTangent> tangent(const Constraint& constraint, const State& state);

    [[nodiscard]] NewtonEnd tangent_end() const noexcept { return tangent_end_; }

    /// x part of M^-1 (b, 0) with the bordered matrix M of the state and constraint of the last tangent().
    [[nodiscard]] std::optional<linalg::Vector> bordered_solve(Vec b);

    /// Negative pivots of K beyond one a pressure unknown at the last tangent(), which the next one is compared to. A path
    /// that is resumed sets it.
    [[nodiscard]] int confirmed_pivots() const noexcept { return confirmed_pivots_; }
    void confirm_pivots(int pivots) noexcept { confirmed_pivots_ = pivots; }

    [[nodiscard]] int factorizations() const noexcept { return solver_.factorizations(); }
    [[nodiscard]] long linear_iterations() const noexcept { return solver_.iterations(); }

private:
    /// A correction on its way.
    struct Correction {
        assembly::Evaluation evaluation;  // the last
        double residual = 0;              // |R| at the state
        double first_force_scale = 0, constraint_tolerance = 0;
        double missing = 0;       // of the constraint
        bool loads_stay = false;  // they are those of the target: the increment is K^-1 (-R) alone, without columns
        double aim = 0;           // of the residual: equilibrium
        model::LineSearch line_search = model::LineSearch::backtracking;
        NewtonResult result;
    };
    /// dx is in correction_; and what the bordered system adds to it.
    struct Increment {
        std::vector<double> loads;  // of the free supplies' pressures and the load factor
        double pending = 0;         // what is still to be done, as a force
    };
    enum class Assemble { tangent, forces };
    using SolveOne = std::function<linalg::LinearSolve(Vec, Vec)>;

    // newton.cpp
    [[nodiscard]] NewtonResult correct_by(model::LineSearch line_search, const Constraint& constraint, double target,
                                          State& state);
    [[nodiscard]] std::optional<NewtonEnd> judge(const State& state, Correction& now);
    [[nodiscard]] bool is_rounding(const State& state, const Correction& now);
    /// What R changes by when the unknowns change in their last digits: R_ is overwritten.
    [[nodiscard]] double change_by_digits(const State& state, const assembly::LoadLevels& levels);
    [[nodiscard]] std::optional<NewtonEnd> solve_blocks(const State& state, const Correction& now);
    /// True where the factor before this iteration has served it.
    [[nodiscard]] bool solve_with_kept_factor(const Correction& now);
    [[nodiscard]] bool solve_all(const Correction& now, const SolveOne& solve);
    [[nodiscard]] std::optional<Increment> increment(const Correction& now);
    [[nodiscard]] Search move(const Increment& step, const State& state, State& trial, Correction& now);
    void learn(double length);
    [[nodiscard]] linalg::LinearSolve solve_updated(Vec b, Vec x);

    // newton_system.cpp
    [[nodiscard]] assembly::Evaluation evaluate_at(const State& state, Assemble what = Assemble::tangent);
    [[nodiscard]] Mat matrix_for(Assemble what);
    /// Whether the columns' forces and K_ are those of this very state.
    [[nodiscard]] bool is_assembled_at(const State& state) const;
    /// Brings K_, or the operator in its place, and its factor to the state last evaluated.
    [[nodiscard]] std::optional<NewtonEnd> linearize(const State& state);
    /// K_ or the operator alone.
    void differentiate(const State& state);
    [[nodiscard]] NewtonEnd factor_failure() const;
    [[nodiscard]] NewtonEnd solve_failure() const;
    /// Values and gradients of e_k and c at the state last evaluated.
    void evaluate_rows(const Constraint& constraint, const State& state);
    /// False at the first column that is not solved.
    [[nodiscard]] bool solve_columns(const SolveOne& solve);
    /// Rows of the small system applied to a direction x.
    [[nodiscard]] std::vector<double> rows_times(Vec x) const;
    void fill_border();

    // newton_tangent.cpp
    /// Columns at the state of the last evaluation, by the last factor or, where that is not good enough, a new one.
    [[nodiscard]] std::optional<NewtonEnd> solve_tangent_columns();
    [[nodiscard]] linalg::LinearSolve solve_well(Vec b, Vec x, linalg::Factor factor);
    [[nodiscard]] std::optional<int> unstable_modes();
    /// PathTangent::power per unit of the load factor; nullopt where held supplies leave the direction open.
    [[nodiscard]] std::optional<double> power_with_supplies_held() const;
    /// Negative pivots of K beyond one a pressure unknown, with LU their parity: those of the last factor, and what they are taken
    /// for.
    [[nodiscard]] std::optional<int> pivots_of_factor() const;
    [[nodiscard]] std::optional<int> excess_pivots();

    assembly::System& system_;
    model::SolverSettings settings_;
    const StageLoads* loads_ = nullptr;
    bool loads_move_ = false;  // a face, with the load factor
    double rounding_N_ =
        0;  // of the residual of the undeformed body: all that is known of equilibrium under tiny loads
    linalg::Matrix K_, spare_;  // the spare is for columns that need a tangent while K_ stays
    linalg::LinearSolver solver_;
    std::optional<ResidualDifferences> differences_;
    linalg::Factorization factor_;
    bool factor_is_recent_ = false;  // made in the last correction
    double residual_at_factor_ = 0;  // |R| where it was made
    bool linear_limit_met_ = false;  // in the last iteration
    NewtonEnd tangent_end_ = NewtonEnd::converged;
    int confirmed_pivots_ = 0;       // excess_pivots() of the tangent before
    linalg::Vector R_, correction_;  // a, then dx
    SecantUpdates updates_;
    linalg::Vector minus_R_before_, load_change_;   // of the secant pair to come: sum of (dp_k, dlambda) f
    std::vector<linalg::Vector> forces_, columns_;  // f_k, -dR/dlambda; b_k, b_l
    std::vector<assembly::LoadColumn> wanted_;
    std::optional<State> assembled_at_;      // of the last evaluation, where it gave K_
    std::vector<linalg::Vector> gradients_;  // of e_k, c by x
    std::vector<SupplyEquation> supply_;
    ConstraintValue constraint_;
    std::vector<double> volume_by_load_factor_;  // of the free supplies, through prescribed motions
    linalg::SmallMatrix border_;
};

}  // namespace soft::solver
