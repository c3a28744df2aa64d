#pragma once
/// Checks every connected part of the body for rigid motions that the constrained components do not prevent; such a motion
/// makes the stiffness singular. Derived here. Tested by fem/rigid_motion_test.
#include <optional>
#include <string>
#include <vector>

#include "math/vector.hpp"
#include "model/case.hpp"

namespace soft::fem {

/// A rigid motion of the kinematics: a unit translation or a unit rotation.
struct RigidMode {
    const char* name;
    Vector3 translation, rotation;

    /// Velocity of a point at `r` from the axis of rotation.
    [[nodiscard]] Vector3 velocity(const Vector3& r) const { return along(translation, 1.0, cross(rotation, r)); }
};
/// solid: 3 translations, 3 rotations; plane strain: 2 and 1; axisymmetric: the translation along the axis.
[[nodiscard]] std::vector<RigidMode> rigid_modes(model::Kinematics kinematics);

/// The first rigid motion that is not prevented, for a message ("translation along x", "rotation about an axis along y", "... of the
/// part near x = 3 mm"); nullopt if there is none.
[[nodiscard]] std::optional<std::string> free_rigid_motion(const model::Case& input);

}  // namespace soft::fem
