#pragma once
/// A law whose constants are known, in place of a fit: the start of fit_history. Tested by fit/history_fit_test.
#include "fit/fit.hpp"

namespace soft::fit {

/// The constants have no errors. Throws Error (usage) for a law that cannot be fitted.
[[nodiscard]] Fit given_law(const std::string& law, const material::Constants& constants);

}  // namespace soft::fit
