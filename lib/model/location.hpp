#pragma once
/// Places of the body for messages, in the letters of its kinematics. Tested by surface/report_test and fields/reached_test.
#include <string>

#include "model/case.hpp"

namespace soft::model {

/// "x = 12.3 mm, r = 4.5 mm" of a section of revolution, "x = .., y = .." of plane strain, "x = .., y = .., z = .." of a solid.
[[nodiscard]] std::string location_text(Kinematics kinematics, const mesh::Point& place);

}  // namespace soft::model
