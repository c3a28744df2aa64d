#pragma once
/// Errors of a path against measured points: `postprocess --compare measured.csv`.
///
/// Of a static path: the load at equal value of each other measured quantity, and that quantity at equal load; of a motion
/// each quantity at equal time. Error e_i = calculated - measured of point i, over the points whose value the path takes (the
/// common range); where the path takes it several times, the nearest place counts. Per point, not per length of the curve:
///   mean = sum e_i / n,   mean absolute = sum |e_i| / n,   RMS = sqrt(sum e_i^2 / n),
///   R2 = 1 - sum e_i^2 / sum (m_i - mean m)^2 over the same points m_i; none where all are equal.
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
    std::size_t of = 0, at = 0;  ///< columns of the curve: error of one at equal values of the other
    std::size_t points = 0;      ///< in the common range
    std::size_t left_out = 0;
    double mean = 0, mean_absolute = 0, rms = 0;  ///< in the unit of column `of`
    double largest = 0;                           ///< with its sign
    std::size_t max_row = 0;                  ///< of the measured rows
    std::optional<double> r2 = {};
};

/// Error (bad_input) where no measured point lies on the path.
[[nodiscard]] std::vector<ErrorSummary> compare(const Curve& curve, const Measured& measured);

/// CSV, one line an ErrorSummary: quantity, unit, at_equal, points, left_out, mean, mean_absolute, rms, largest, max_line,
/// measured (there), r2 (empty where there is none).
[[nodiscard]] std::string csv_text(const Curve& curve, const Measured& measured, std::span<const ErrorSummary> errors);

/// The same for people, one line each: "pressure at equal elongation: mean 1.4 kPa, ...".
[[nodiscard]] std::vector<std::string> summary_lines(const Curve& curve, const Measured& measured,
                                                     std::span<const ErrorSummary> errors);

/// Whether the largest error of each quantity in units of `limit`'s kind ("5kPa", "2mm") is within it, and no measured point
/// beyond the path, where nothing holds it. Error(usage) where nothing is measured in such a unit.
[[nodiscard]] std::vector<Claim> check_largest(const Curve& curve, const Measured& measured,
                                               std::span<const ErrorSummary> errors, std::string_view limit);

}  // namespace soft::post
