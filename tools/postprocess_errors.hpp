#pragma once
/// The errors of fitted constants for a band of the curve.
#include <string>

#include "post/sensitivity.hpp"

namespace soft {

/// Reads standard errors and correlations from the --json file of fit-material (its first fit) or optimize. Throws Error: bad_input for
/// another file, and if the case has other values; usage for a number without sensitivity.
[[nodiscard]] post::Deviations fitted_deviations(const std::string& file, const model::Case& model);

}  // namespace soft
