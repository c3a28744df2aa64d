#pragma once
/// A cell as a number. Internal.
#include <optional>
#include <string>

#include "table/table.hpp"

namespace soft::table {

/// Decimal text for core/units ("1,5" becomes "1.5"); nullopt for anything but a finite decimal number.
[[nodiscard]] std::optional<std::string> number_in(const std::string& cell, Decimal decimal);

}  // namespace soft::table
