#pragma once
/// The known law of fit-material --elastic. Tested by pipeline/inelastic_fits.
#include <string>

#include "fit/fit.hpp"

namespace soft::cli {

/// `material`: a file with a `material:` as fit-material writes it, or a silicone of the library. Throws Error.
[[nodiscard]] fit::Fit elastic_law(const std::string& material);

}  // namespace soft::cli
