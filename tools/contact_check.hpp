#pragma once
/// Contact check of a case for the solver.
#include "fem/system.hpp"
#include "solver/path.hpp"

namespace soft::cli {

/// Rank 0 searches with contact::ContactFinder and broadcasts the result to all ranks. Empty if the case ignores contact.
/// `system` must outlive the returned function.
[[nodiscard]] solver::ContactCheck contact_check(fem::System& system);

}  // namespace soft::cli
