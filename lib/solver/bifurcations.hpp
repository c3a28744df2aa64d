#pragma once
/// Bifurcations between two rows: states at which eigenvalues of the tangent, under the constraint of the path, pass through zero.
/// Internal to the module. Tested by solver/branch_test and the verification suite.
#include <vector>

#include "solver/events.hpp"

namespace soft::solver {

/// All of them between the last row and `to`, in the order of the path, each with its mode.
[[nodiscard]] std::vector<Event> bifurcations_before(const PathPoint& to, Corrector& corrector, const PathState& path,
                                                     const Listeners& listeners);

}  // namespace soft::solver
