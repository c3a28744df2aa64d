#pragma once
/// The accepted units, for messages and the reference of the keys. Tested by core/units_test.
#include <optional>
#include <string>
#include <vector>

#include "core/units.hpp"

namespace soft::core {

/// The units of a dimension, or of all dimensions, as ASCII text; "um" with a micro sign is accepted as well.
[[nodiscard]] std::vector<std::string> unit_names(std::optional<Dimension> dimension);

}  // namespace soft::core
