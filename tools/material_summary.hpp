#pragma once
/// Material laws of a case, for --json of solve and postprocess. Tested by tests/pipeline/fit.sh.
#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "model/case.hpp"

namespace soft::cli {

/// One entry per material of the case: name, section of the design, law, constants (SI; lists as in the design). For constants
/// fitted to test data also `fit`: name of the silicone (null for others), strain range, max_I1 and max_error (null if the design
/// does not state it).
[[nodiscard]] nlohmann::ordered_json materials_json(const model::Case& model, std::string_view effective_yaml);

}  // namespace soft::cli
