#pragma once
/// The keys of `solver`. Private to the module. Tested by design/solver_test.
#include <vector>

#include "design/design.hpp"
#include "design/schema.hpp"

namespace soft::design {

/// Defaults are those of model::SolverSettings.
[[nodiscard]] std::vector<Key> solver_keys();

/// The solver settings. Rejects a preconditioner other than the default for a method that does not use one.
[[nodiscard]] model::SolverSettings solver_of(const Values& values);

}  // namespace soft::design
