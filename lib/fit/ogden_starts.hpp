#pragma once
/// Initial guesses for the exponents of Ogden's law: for every pattern of signs the best set from a dense, log-spaced list. The
/// moduli are linear for given exponents, so each set costs one small linear solve with precomputed inner products. The list is
/// coarser for more terms. Private to the module. Tested by fit/fit_test.
#include "fit/separable.hpp"

namespace soft::fit {

[[nodiscard]] std::vector<std::vector<double>> ogden_starts(const Candidate& candidate, const Rows& rows, Signs signs);

}  // namespace soft::fit
