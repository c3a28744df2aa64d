#pragma once
/// What postprocess tells of a result besides the curve.
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/result_file.hpp"
#include "post/curve.hpp"

namespace soft {

/// For --json: rows, columns, stop_reason (null while solve is at work), limit points and bifurcations by the columns' names.
[[nodiscard]] nlohmann::ordered_json postprocess_summary(const io::Result& result, const post::Curve& curve,
                                                         std::size_t rows);

/// The same for people: one line on the path, one a limit point or bifurcation, one on the data behind fitted constants.
[[nodiscard]] std::vector<std::string> summary_lines(const nlohmann::ordered_json& json);

/// The warning where the rubber is stretched beyond the data its constants were fitted to (design::fit_advice).
[[nodiscard]] std::optional<std::string> material_advice(const nlohmann::ordered_json& json);
/// Both, for the report; empty for constants of which nothing is said.
[[nodiscard]] std::vector<std::string> material_notes(const nlohmann::ordered_json& json);

}  // namespace soft
