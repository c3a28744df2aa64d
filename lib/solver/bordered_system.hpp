#pragma once
/// The bordered system of newton.hpp at a state: residual R, tangent K with its factor, the columns b_k, b_l, the rows of the supplies
/// and of the constraint, and the small system that remains after the columns are inserted into the rows. Internal to the module.
#include <functional>
#include <optional>
#include <string_view>

#include "linalg/linear_solver.hpp"
#include "linalg/small_matrix.hpp"
#include "solver/constraint.hpp"
#include "solver/differences.hpp"

namespace soft::solver {

/// not_definite: CHOLMOD found a pivot that is not positive. linear_solver: the linear systems are not solved to the required
/// tolerance, and therefore no equilibrium is found. passes_through: the actuator would have passed through an obstacle.
enum class NewtonEnd {
    converged,
    inverted,
    iteration_limit,
    no_descent,
    singular,
    not_definite,
    linear_solver,
    not_finite,
    passes_through
};
/// A clause for messages about the failure.
[[nodiscard]] std::string_view text_of(NewtonEnd end);

[[nodiscard]] linalg::Symmetry symmetry_of(const fem::System& system);

class BorderedSystem {
public:
    enum class Assemble { tangent, forces };
    using SolveOne = std::function<linalg::LinearSolve(Vec, Vec)>;

    BorderedSystem(fem::System& system, const model::SolverSettings& settings);

    /// Sets the loads of all later calls; not owned.
    void set_loads(const StageLoads& loads);

    /// Fills R and the forces of the columns, and K unless only forces are wanted. Prescribes the motions of the state.
    [[nodiscard]] fem::Evaluation evaluate_at(const State& state, Assemble what = Assemble::tangent);
    /// Whether the columns' forces and K were assembled at exactly this state.
    [[nodiscard]] bool is_assembled_at(const State& state) const;
    /// For changes of the system that no state shows.
    void forget_assembly() { assembled_at_.reset(); }
    /// Adds to -dR/dlambda, at the state last evaluated, what the internal variables change in time. Overwrites R.
    void add_time_force(const State& state);
    /// Change of R when the unknowns change in their last digits. Overwrites R.
    [[nodiscard]] double change_by_digits(const State& state, const fem::LoadLevels& levels);

    /// The share of the way between two states before walls pass through each other or an obstacle (contact/potential.hpp).
    [[nodiscard]] double share_without_crossing(const State& from, const State& to);
    /// Whether the actuator passes through an obstacle on the straight way between two states.
    [[nodiscard]] bool passes_through_obstacle(const State& from, const State& to);
    /// Gives K the pattern of the contact at a state of the path: what follows does not depend on the states tried before it.
    void couple_contact(const State& state);

    /// Adds the force drag k (u - u_origin) on the displacements to R, and its derivative to K, in all later evaluations; k is the mean
    /// diagonal entry of the undeformed K. 0 removes it.
    void set_drag(double drag, Vec origin);

    /// Updates K, or the operator in its place, to the state last evaluated, without a factor.
    void differentiate(const State& state);
    /// A new factor of K; the reason where there is none.
    [[nodiscard]] std::optional<NewtonEnd> factorize();
    /// Why a solve with a factor fails.
    [[nodiscard]] NewtonEnd solve_failure() const;

    /// Values and gradients of e_k and c at the state last evaluated.
    void evaluate_rows(const Constraint& target, const State& state);
    /// Rows of the small system applied to a direction x.
    [[nodiscard]] std::vector<double> rows_times(Vec x) const;
    /// by_x -= sum of the gradients of the rows times these factors.
    void subtract_rows(const std::vector<double>& factors, Vec by_x) const;
    /// False if a column is not solved.
    [[nodiscard]] bool solve_columns(const SolveOne& solve);
    void fill_border();

    [[nodiscard]] const StageLoads& loads() const { return *loads_; }
    [[nodiscard]] bool loads_move() const { return loads_move_; }  ///< a face moves with the load factor
    [[nodiscard]] bool uses_differences() const { return differences_.has_value(); }

    fem::System& system;
    model::SolverSettings settings;
    linalg::Matrix K;
    linalg::LinearSolver linear;
    linalg::Factorization factor;
    bool factor_is_recent = false;    ///< made in the last correction, or kept from the one before
    bool columns_are_recent = false;  ///< solved in the last correction: a start for those at its end
    linalg::Vector R;
    std::vector<fem::LoadColumn> forces;  ///< f_k, -dR/dlambda
    std::vector<linalg::Vector> columns;  ///< b_k, b_l
    std::vector<SupplyEquation> supply;
    ConstraintValue constraint;
    linalg::SmallMatrix by_loads;  ///< D: derivatives of the rows by the bordered unknowns
    linalg::SmallMatrix border;    ///< D + rows C

private:
    [[nodiscard]] Mat matrix_for(Assemble what);
    void pattern_changed();
    void add_drag(const State& state, Mat matrix);

    double drag_ = 0;
    linalg::Vector drag_weights_, drag_origin_;  // 0 at pressure unknowns
    linalg::Vector R_of_forces_;                 // on a path in time, R where the forces were evaluated last
    bool has_time_force_ = false;                // of those forces
    const StageLoads* loads_ = nullptr;
    bool loads_move_ = false;
    linalg::Matrix spare_;                          // for columns that need a tangent while K is kept
    std::vector<std::vector<PetscInt>> couplings_;  // by contact, in the pattern of K
    std::optional<ResidualDifferences> differences_;
    std::optional<State> assembled_at_;                      // of the last evaluation, where it gave K
    std::vector<linalg::Vector> force_vectors_, gradients_;  // gradients of e_k, c by x
    std::vector<double> volume_by_load_factor_;              // of the free supplies, through prescribed motions
};

}  // namespace soft::solver
