#pragma once
/// Formats positions for messages, in the coordinates of the kinematics. Tested by surface/report_test and post/path_warnings_test.
#include <string>

#include "model/case.hpp"
#include "model/path.hpp"

namespace soft::model {

/// "x = 12.3 mm, r = 4.5 mm" (axisymmetric), "x = .., y = .." (plane strain), "x = .., y = .., z = .." (solid).
[[nodiscard]] std::string location_text(Kinematics kinematics, const mesh::Point& position_m);

/// "the actuator touches the obstacle table at x = 12.3 mm, ... of the undeformed part"
[[nodiscard]] std::string contact_text(const Case& input, const FirstContact& contact);

}  // namespace soft::model
