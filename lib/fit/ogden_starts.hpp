#pragma once
/// Starts for the exponents of Ogden's law: for every pattern of signs the best set of a dense, log-spaced list. For given
/// exponents the moduli are linear, so each set costs the solution of a system of its size on products computed once.
/// The more terms, the coarser the list. Private to the module. Tested by fit/fit_test.
#include "fit/separable.hpp"

namespace soft::fit {

[[nodiscard]] std::vector<std::vector<double>> ogden_starts(const Candidate& candidate, const Rows& rows, Signs signs);

}  // namespace soft::fit
