#pragma once
/// How accurately data determine the variables. With the residuals r_i = (value - measured) / sd_i of all targets and their Jacobian J at the best
/// trial, the covariance of the variables is s^2 (J' J)^-1, s^2 = sum r_i^2 / (n - k): the errors of the rows are taken as independent,
/// and their size from the scatter, so that `within` sets only the relative weights. Variables at the end of their range, and whole numbers, are
/// taken as known. Source: Bjorck, Numerical Methods for Least Squares Problems (1996), 2.8.
/// Tested by optimize/statistics_test (against the scatter of repeated fits) and pipeline/calibration.
#include <optional>
#include <vector>

#include "optimize/search.hpp"

namespace soft::optimize {

struct Statistics {
    std::vector<std::size_t> variables;     ///< those that are determined
    std::vector<std::size_t> undetermined;  ///< those that do not change the data at all
    std::vector<double> standard_errors;    ///< of each, SI
    std::vector<double> correlations;       ///< by rows; 1 on the diagonal
    double scatter = 0;                     ///< s
    std::size_t degrees_of_freedom = 0;     ///< n - k
    /// Of J with columns of length 1; large where a combination of variables hardly changes the data.
    double condition = 1;
    /// That combination: relative changes of the variables, the largest 1, that hardly change the data together, and the standard error of
    /// its amount.
    std::vector<double> weakest;
    double weakest_error = 0;

    /// Above it the data hardly tell the variables apart: correlation 0.99 of two of them.
    static constexpr double max_condition = 14;
};

/// nullopt for a goal without data, unless there are more targets than variables to be determined, and where a bound among the conditions is active.
[[nodiscard]] std::optional<Statistics> statistics_of(const Goal& goal, const Found& found);

/// Whether a bound is active: met with little to spare.
[[nodiscard]] bool is_active(const Condition& condition, double value_SI);

/// Whether a value lies at an end of its range.
[[nodiscard]] bool is_at_end(const Variable& variable, double value_SI);

}  // namespace soft::optimize
