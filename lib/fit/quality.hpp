#pragma once
/// What a fit is worth: errors of the rows, of the constants, and stability. Private to the module. Tested by fit/fit_test.
#include "fit/separable.hpp"

namespace soft::fit {

/// A finished search: what `fit` holds is made of it.
struct Solution {
    Candidate candidate;
    std::vector<double> q;
    Projection projection;
    Signs signs = Signs::free;
    bool at_search_bound = false;
};

[[nodiscard]] Fit describe(const Solution& solution, const std::vector<TestCurve>& tests, const Rows& rows);

}  // namespace soft::fit
