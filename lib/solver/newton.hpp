#pragma once
/// Newton's method on the bordered system R(x, lambda) = 0, c(x, lambda) = target, with a line search on |R| that also
/// keeps det F > 0. Each iteration solves K a = -R and K b = load with one factor (block elimination):
///   dlambda = (target - c - g.a) / (g_lambda + g.b),   dx = a + dlambda b.
/// Source: Crisfield, Non-linear Finite Element Analysis of Solids and Structures 1 (1991) 9.3; Allgower and Georg,
/// Introduction to Numerical Continuation Methods (2003) 10.4. Held by solver/solver_test.
#include <optional>

#include "linalg/linear_solver.hpp"
#include "solver/constraint.hpp"

namespace soft::solver {

struct State {
    linalg::Vector x;
    double load_factor = 0;
};

enum class NewtonEnd { converged, inverted, iteration_limit, no_descent, singular };

struct NewtonResult {
    NewtonEnd end = NewtonEnd::converged;
    int iterations = 0;
    double residual = 0;                ///< |R| over the force scale
    mesh::Index worst_cell = -1;        ///< cell with the least det F at the last evaluation
    double min_jacobian = 1;
};

/// Direction of the path at a converged state, per unit of the constraint's value.
struct PathTangent {
    linalg::Vector x;
    double load_factor = 0;
    std::optional<int> excess_pivots;   ///< negative pivots beyond one a pressure unknown: 0 = stable at fixed load
};

class Newton {
public:
    Newton(assembly::System& system, const model::SolverSettings& settings);

    /// Moves `state` to equilibrium with c = target. On failure `state` holds the last admissible iterate.
    [[nodiscard]] NewtonResult correct(const Constraint& constraint, double target, State& state);

    /// Direction of the path at a converged state, its inertia from the factor of the last correction where there was one
    /// (a state that the correction has moved by less than its own square), else from a new one. nullopt where K is
    /// singular.
    [[nodiscard]] std::optional<PathTangent> tangent(const Constraint& constraint, const State& state);

    [[nodiscard]] int factorizations() const noexcept { return solver_.factorizations(); }

private:
    [[nodiscard]] bool solve_directions();
    [[nodiscard]] bool solve_along_load();
    [[nodiscard]] assembly::Evaluation evaluate_at(const State& state);

    assembly::System& system_;
    model::SolverSettings settings_;
    linalg::Matrix K_;
    linalg::LinearSolver solver_;
    linalg::Factorization factor_;
    bool factor_is_recent_ = false;                    // made in the last correction
    linalg::Vector R_, load_, gradient_;
    linalg::Vector toward_equilibrium_, along_load_;   // a and b
};

}  // namespace soft::solver
