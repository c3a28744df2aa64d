#pragma once
/// Stages of a load programme: their loads, goals and control, and where the path begins in them. Internal to the module.
/// Tested by solver/programme_test, solver/tiny_load_test.
#include "solver/corrector.hpp"

namespace soft::solver {

/// Sets loads, goals and control of a stage.
void set_stage(int index, StageStart start, Corrector& corrector, PathState& path);

/// Starts the path of the stage at `state`: its direction, and the first step, SolverSettings::first_step of the stage's loads in the
/// linear response. The sense is the one in which the growing loads do work; in a stable state, and where a face is moved, the one
/// in which the load factor grows. Throws Error (bad_input) for an undeformed body without stiffness and for a control that the load
/// does not move.
[[nodiscard]] std::optional<Stop> begin_stage(Corrector& corrector, PathState& path, State state);

/// Sets the stage after the last point, which it returns as the state to begin at.
[[nodiscard]] State next_stage(Corrector& corrector, PathState& path);

/// Row at which the stage ends by the number of its steps.
[[nodiscard]] int last_row_of_stage(const PathState& path, const model::Case& input);

}  // namespace soft::solver
