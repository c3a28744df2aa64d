#pragma once
/// What a search found, as text, JSON and a design.
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "optimize/statistics.hpp"

namespace soft {

/// "elongation at pressure 20 kPa: 60.1 mm, wanted 60 mm; ..."; measured curves by the root mean square of their differences.
[[nodiscard]] std::string progress_text(const optimize::Goal& goal, const optimize::Found& found);

/// One line for each variable, condition and measured curve, and what the data do not determine.
[[nodiscard]] std::vector<std::string> report_lines(const optimize::Goal& goal, const optimize::Found& found);

[[nodiscard]] nlohmann::ordered_json report_json(const optimize::Goal& goal, const optimize::Found& found);

}  // namespace soft
