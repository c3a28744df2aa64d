#pragma once
/// Does a connected part of the body move freely? Its rigid motions are tested against the held components; a motion
/// that no support sees makes the stiffness singular. Derived here. Tested by assembly/rigid_motion_test.
#include <optional>
#include <string>

#include "model/case.hpp"

namespace soft::assembly {

/// The first rigid motion left free, for a message ("translation along x", "rotation about an axis along y", "... of the
/// part near x = 3 mm"); nothing where every part is held.
[[nodiscard]] std::optional<std::string> free_rigid_motion(const model::Case& input);

}  // namespace soft::assembly
