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

/// Fills the errors of all tests and rows, R2 and AICc; the predicted stress is `predicted_Pa` where it is filled, else that of the
/// constants.
struct WeightedSquares {
    double sum = 0;
    std::size_t unknowns = 1;  ///< with the variance
};
void add_row_errors(const std::vector<TestCurve>& tests, const WeightedSquares& squares, Fit& fit);
/// Fills the limits of stability, `stable` and their flags; `signs_suffice`: stable at every stretch.
void add_stability(bool signs_suffice, Fit& fit);

/// Covariance s^2 T (J'J)^-1 T' of the constants. s^2 is the sum of squares over the degrees of freedom. J is the Jacobian in the fit
/// variables (linear constants, shapes q, offsets). T maps these to the constants of a design. Variables at a bound have zero
/// covariance. Computed from the singular values of J with columns scaled to length 1. Source: Bjorck, Numerical
/// Methods for Least Squares Problems (1996), 2.8. Tested by fit/fit_test (against the scatter of repeated tests), fit/treloar_test.
/// Fills covariance, condition and the standard errors of fit.list.
void add_covariance(const Solution& solution, const Rows& rows, Fit& fit);

}  // namespace soft::fit
