#pragma once
/// Where walls of the body touch, for the solver.
#include "assembly/system.hpp"
#include "solver/path.hpp"

namespace soft::cli {

/// Rank 0 looks (surface::ContactFinder), all ranks get the answer. Empty where the case lets walls pass through each
/// other. `system` must outlive it.
[[nodiscard]] solver::ContactCheck contact_check(assembly::System& system);

}  // namespace soft::cli
