#pragma once
/// Checks every connected part of the body for rigid motions that the constrained components do not prevent; such a motion
/// makes the stiffness singular. Derived here. Tested by fem/rigid_motion_test.
#include <optional>
#include <string>

#include "model/case.hpp"

namespace soft::fem {

/// The first rigid motion that is not prevented, for a message ("translation along x", "rotation about an axis along y", "... of the
/// part near x = 3 mm"); nullopt if there is none.
[[nodiscard]] std::optional<std::string> free_rigid_motion(const model::Case& input);

}  // namespace soft::fem
