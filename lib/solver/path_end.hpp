#pragma once
/// Ends of a path that does not reach the requested load. Internal to the module. Tested by solver/solver_test, solver/visited_states_test.
#include "solver/corrector.hpp"

namespace soft::solver {

/// The clause for a path that ends because of its linear solver; the caller puts the location before it.
inline constexpr const char* linear_remedy =
    "the linear solver does not converge; use another solver.linear or solver.preconditioner, or increase solver.linear_limit";

/// The error of a path that cannot start: names solver.linear where the linear solver failed, else `problem` of the materials.
[[nodiscard]] Error start_error(NewtonEnd end, const std::string& problem);

/// Before a step: the limit of steps, or steps too short for progress. A path stalls when its last `stalled_rows` steps are together
/// shorter than `stalled_length` of the whole path.
inline constexpr std::size_t stalled_rows = 150;
inline constexpr double stalled_length = 0.01;
[[nodiscard]] std::optional<Stop> stop_before_step(const PathState& path, fem::System& system);

/// Before a point becomes a row: the load factor has changed by more than 1e4 in one step, because the loads of the stage would move the
/// state by less than 1e-8 of itself.
[[nodiscard]] std::optional<Stop> stop_before_row(const PathState& path, const PathPoint& point,
                                                  const fem::System& system);

/// Where rows are refused because walls pass through each other, also with the shortest steps. `state`: of the last row.
[[nodiscard]] Stop unresolved(const ContactEvent& crossing, const std::string& state);

/// At a new row: the path has returned to states it has passed, or its goal is out of reach.
[[nodiscard]] std::optional<Stop> stop_at_row(const PathState& path, fem::System& system);

/// Whether a cell of the last attempt is nearly inverted: the material would have failed, or the cells are too large.
[[nodiscard]] bool is_nearly_inverted(const NewtonResult& attempt);

/// After failed steps, with the location where smaller cells would help.
[[nodiscard]] Stop stop_without_step(const PathState& path, fem::System& system, const NewtonResult& attempt);

}  // namespace soft::solver
