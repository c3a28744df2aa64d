#pragma once
/// Number in a cell. Private to the module.
#include <optional>
#include <string>

#include "core/table.hpp"

namespace soft::core {

/// The number of a cell as text for core/units ("1,5" becomes "1.5"); nullopt unless the cell is a finite decimal number.
[[nodiscard]] std::optional<std::string> decimal_text(const std::string& cell, Decimal decimal);

}  // namespace soft::core
