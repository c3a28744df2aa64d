#pragma once
/// Errors of a path against measured points: `postprocess --compare measured.csv`.
///
/// For a static path, the load is compared at equal values of each other measured quantity, and that quantity at equal load. For a
/// motion, each quantity is compared at equal time. Error e_i = calculated - measured of point i, over the points whose value the path
/// reaches (the common range). If the path reaches it several times, the nearest crossing counts. Per point, not per length of the
/// curve:
///   mean = sum e_i / n,   mean absolute = sum |e_i| / n,   RMS = sqrt(sum e_i^2 / n),
///   R2 = 1 - sum e_i^2 / sum (m_i - mean m)^2 over the same points m_i; undefined if all are equal.
/// Tested by post/compare_test.
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "post/curve.hpp"
#include "post/junit.hpp"
#include "post/measured.hpp"

namespace soft::post {

struct ErrorSummary {
    std::size_t of = 0, at = 0;                   ///< columns of the curve: error of `of` at equal values of `at`
    std::size_t points = 0;                       ///< in the common range
    std::size_t left_out = 0;                     ///< points outside the common range
    double mean = 0, mean_absolute = 0, rms = 0;  ///< in the unit of column `of`
    double largest = 0;                           ///< signed error with the largest magnitude
    std::size_t max_row = 0;                      ///< measured row of the largest error
    std::optional<double> r2 = {};
};

/// Throws Error (bad_input) if no measured point lies on the path.
[[nodiscard]] std::vector<ErrorSummary> compare(const Curve& curve, const Measured& measured);

/// CSV with one line per ErrorSummary: quantity, unit, at_equal, points, left_out, mean, mean_absolute, rms, largest, max_line (line of
/// the largest error), measured (value in that line), r2 (empty if undefined).
[[nodiscard]] std::string csv_text(const Curve& curve, const Measured& measured, std::span<const ErrorSummary> errors);

/// Readable summary, one line each: "pressure at equal elongation: mean error 1.4 kPa, ...".
[[nodiscard]] std::vector<std::string> summary_lines(const Curve& curve, const Measured& measured,
                                                     std::span<const ErrorSummary> errors);

/// Checks that the largest error of each quantity with the dimension of `limit` ("5kPa", "2mm") is within the limit, and that no
/// measured point lies beyond the path, where it cannot be checked. Throws Error(usage) if no measured quantity has this dimension.
[[nodiscard]] std::vector<Claim> check_max_error(const Curve& curve, const Measured& measured,
                                                 std::span<const ErrorSummary> errors, std::string_view limit);

}  // namespace soft::post
