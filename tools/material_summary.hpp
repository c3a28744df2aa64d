#pragma once
/// The laws a case was solved with, for --json of solve and postprocess. Tested by tests/pipeline/fit.sh.
#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "model/case.hpp"

namespace soft::cli {

/// A list with an entry for each material of the case: its name, section of the design, law, constants (SI; lists as in the
/// design) and, of constants fitted to a test, `fit`: name of the silicone (null for others), range of strain, max_I1 and
/// max_error (null where the design does not state it).
[[nodiscard]] nlohmann::ordered_json materials_json(const model::Case& model, std::string_view effective_yaml);

}  // namespace soft::cli
