#pragma once
/// The --json of fit-material: one entry per law, constants in SI with errors and covariance. Tested by tests/pipeline/fit.sh.
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "fit/rank.hpp"

namespace soft::cli {

[[nodiscard]] nlohmann::ordered_json fit_summary(const std::vector<fit::RankedFit>& ranked,
                                                 const std::vector<fit::TestCurve>& tests);

}  // namespace soft::cli
