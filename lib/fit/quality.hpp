#pragma once
/// Quality of a fit: errors of the rows, errors of the constants, and stability. Private to the module. Tested by fit/fit_test.
#include "fit/separable.hpp"

namespace soft::fit {

/// Result of a finished search, from which a Fit is built.
struct Solution {
    Candidate candidate;
    std::vector<double> q;
    Projection projection;
    Signs signs = Signs::free;
    bool at_search_bound = false;
};

[[nodiscard]] Fit describe(const Solution& solution, const std::vector<TestCurve>& tests, const Rows& rows);

}  // namespace soft::fit
