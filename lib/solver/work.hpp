#pragma once
/// Work of the loads from row to row, checked against the change of the stored energy; of the modelled part. Internal to the module.
/// Tested by solver/work_test, solver/kink_test.
#include "solver/corrector.hpp"

namespace soft::solver {

/// Fills the work of the loads from the last row to a point, and the energy that it sets free. The work is computed to the accuracy of the
/// path (step_accuracy) where the law has an energy, through as many intermediate states as necessary. A step in contact that has jumped
/// over a snap leaves more work than the body stores, however many states are computed: this energy is set free. Leaves the memory of the
/// corrector unchanged.
void find_work_of_step(Corrector& corrector, PathState& path, PathPoint& to);

/// The same for a jump between two stable states; the work is that of the mean of the loads at both. False if the body has stored and
/// friction has dissipated more than that: no jump can do so.
[[nodiscard]] bool find_work_of_jump(Corrector& corrector, PathPoint& from, PathPoint& to);

/// True if the loads have done other work than the rubber has stored: `to` lies on another equilibrium path than the last row.
[[nodiscard]] bool breaks_energy_balance(Corrector& corrector, PathState& path, PathPoint& to);

}  // namespace soft::solver
