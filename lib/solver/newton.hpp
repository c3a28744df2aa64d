#pragma once
/// Newton's method on the bordered system
///   R(x, lambda, p) = 0,   e_k(V_k(x), p_k, lambda) = 0 for the free supplies (stage_loads.hpp),   c = target,
/// with a line search on |R| that also keeps det F > 0. Each iteration factorises K once and eliminates blocks:
///   K a = -R,  K b_k = f_k (force of 1 Pa in supply k),  K b_l = -dR/dlambda;   dx = a + sum dp_k b_k + dlambda b_l,
/// where (dp, dlambda) solve the small system of the e_k and c with dx put in.
/// Source: Crisfield, Non-linear Finite Element Analysis of Solids and Structures 1 (1991) 9.3; Allgower and Georg,
/// Introduction to Numerical Continuation Methods (2003) 10.4. Held by solver/solver_test, solver/supply_test.
#include <optional>

#include "linalg/linear_solver.hpp"
#include "solver/constraint.hpp"
#include "linalg/small_matrix.hpp"

namespace soft::solver {

enum class NewtonEnd { converged, inverted, iteration_limit, no_descent, singular, not_finite };

struct NewtonResult {
    NewtonEnd end = NewtonEnd::converged;
    int iterations = 0;
    int halvings = 0;                   ///< of the line search, over all iterations
    double residual = 0;                ///< |R| over the force scale
    mesh::Index worst_cell = -1;        ///< cell with the least det F at the last evaluation
    double min_jacobian = 1;
};

/// Direction of the path at a converged state, per unit of the constraint's value.
struct PathTangent {
    linalg::Vector x;
    double load_factor = 0;
    std::vector<double> pressures;      ///< of the free supplies [Pa]
    /// Directions in which the body gives way at fixed load factor with every supply as prescribed: 0 = stable. From the
    /// negative pivots of K beyond one a pressure unknown, less what volume and gas of the free supplies hold back
    /// (Haynsworth: inertia of the bordered matrix). Where the count changes from one tangent to the next it must agree with
    /// the sign of the determinant (linear_solver.hpp). With an LU factor only the parity is known: 0 or 1.
    std::optional<int> unstable_modes;
    /// Work of the stage's growing loads along the tangent, -dR/dlambda . x.
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
    /// singular.
    [[nodiscard]] std::optional<PathTangent> tangent(const Constraint& constraint, const State& state);

    /// x part of M^-1 (b, 0) with the bordered matrix M of the state and constraint of the last tangent().
    [[nodiscard]] std::optional<linalg::Vector> bordered_solve(Vec b);

    /// Negative pivots of K beyond one a pressure unknown at the last tangent(), which the next one is compared to. A path
    /// that is resumed sets it.
    [[nodiscard]] int confirmed_pivots() const noexcept { return confirmed_pivots_; }
    void confirm_pivots(int pivots) noexcept { confirmed_pivots_ = pivots; }

    [[nodiscard]] int factorizations() const noexcept { return solver_.factorizations(); }

private:
    [[nodiscard]] assembly::Evaluation evaluate_at(const State& state);
    /// Values and gradients of e_k and c at the state last evaluated.
    void evaluate_rows(const Constraint& constraint, const State& state);
    [[nodiscard]] bool solve_columns(linalg::Factor factor);
    /// Rows of the small system applied to a direction x.
    [[nodiscard]] std::vector<double> rows_times(Vec x) const;
    void fill_border();
    [[nodiscard]] std::optional<int> unstable_modes();
    /// Negative pivots of K beyond one a pressure unknown; with LU their parity.
    [[nodiscard]] std::optional<int> excess_pivots();

    assembly::System& system_;
    model::SolverSettings settings_;
    const StageLoads* loads_ = nullptr;
    linalg::Matrix K_;
    linalg::LinearSolver solver_;
    linalg::Factorization factor_;
    bool factor_is_recent_ = false;             // made in the last correction
    int confirmed_pivots_ = 0;                  // excess_pivots() of the tangent before
    linalg::Vector R_, toward_equilibrium_;     // a
    std::vector<linalg::Vector> forces_, columns_;   // f_k, -dR/dlambda; b_k, b_l
    std::vector<assembly::LoadColumn> wanted_;
    std::vector<linalg::Vector> gradients_;     // of e_k, c by x
    std::vector<SupplyEquation> supply_;
    ConstraintValue constraint_;
    std::vector<double> volume_by_load_factor_; // of the free supplies, through prescribed motions
    linalg::SmallMatrix border_;
};

}  // namespace soft::solver
