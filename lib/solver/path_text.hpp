#pragma once
/// Text for the states and locations of a path, for messages: kPa, mm and mL, six digits.
#include <string>

#include "solver/history.hpp"

namespace soft::solver {

[[nodiscard]] std::string short_text(double value);

/// "12.3 kPa, elongation 92.5 mm, volume 55.3 mL"
[[nodiscard]] std::string state_text(const PathPoint& point, const model::Case& input);

/// "in cell 12 at x = 3.1 mm, r = 2 mm of the undeformed part"
[[nodiscard]] std::string location_text(mesh::Index cell, const model::Case& input);

}  // namespace soft::solver
