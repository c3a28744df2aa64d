#pragma once
/// Summary of a result that postprocess prints in addition to the curve.
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/result_file.hpp"
#include "post/curve.hpp"

namespace soft {

/// For --json: rows, columns, stop_reason (null if solve has not finished), limit points, bifurcations and
/// events keyed by column name.
[[nodiscard]] nlohmann::ordered_json postprocess_summary(const io::Result& result, const post::Curve& curve,
                                                         std::size_t rows);

/// Energies of the complete cycles of a repeated programme; empty if there are none.
[[nodiscard]] nlohmann::ordered_json cycles_json(const io::Result& result);

/// Text of the summary: one line for the path, one per limit point, bifurcation or first contact, one for the test data of
/// fitted constants.
[[nodiscard]] std::vector<std::string> summary_lines(const nlohmann::ordered_json& json);

/// Warning that the rubber is stretched beyond the data to which its constants were fitted (design::fit_range_advice).
[[nodiscard]] std::optional<std::string> material_advice(const nlohmann::ordered_json& json);
/// The line on fitted constants and the warning, for the report; empty if the design has no fit data.
[[nodiscard]] std::vector<std::string> material_notes(const nlohmann::ordered_json& json);

}  // namespace soft
