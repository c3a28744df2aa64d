#pragma once
/// Work of the loads from row to row, checked against the change of the stored energy; of the modelled part. Internal to the module.
/// Tested by solver/work_test, solver/kink_test.
#include "solver/corrector.hpp"

namespace soft::solver {

/// Work of the loads between two points [J]. To the accuracy of the path (step_accuracy) where the law has an energy, through as many
/// intermediate states as necessary. Leaves the memory of the corrector unchanged.
[[nodiscard]] double work_of_step(Corrector& corrector, const PathState& path, PathPoint& from, PathPoint& to);

/// True if the loads have done other work than the rubber has stored: `to` lies on another equilibrium path than the last row.
[[nodiscard]] bool breaks_energy_balance(Corrector& corrector, PathState& path, PathPoint& to);

}  // namespace soft::solver
