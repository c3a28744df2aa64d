#pragma once
/// Uncertainty of a curve due to the errors of fitted constants: one standard deviation of every quantity at given values of another
/// quantity (the prescribed quantity, which has no deviation). scripts/uncertainty writes it, plots draw it.
///     linear    s^2 = sum_k ((q(c + L_k) - q(c - L_k)) / 2)^2, over pairs of curves (fit/shifted_constants.hpp)
///     sampled   s^2 = sum (q - mean)^2 / (n - 1), over the n samples that reach the value
/// Table: the columns of the curve, one row per crossing of each value; for each coordinate `pressure_band_kPa` (linear) and
/// `pressure_sampled_band_kPa`, in its unit; and `samples` (n). A cell is empty for the prescribed quantity, if a shifted curve does
/// not reach the value, and if n < 2. Tested by post/band_test.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/table.hpp"
#include "post/curve.hpp"
#include "post/request.hpp"

namespace soft::post {

struct Band {
    /// A coordinate of the curve, in its unit; one value per row; NaN: no value.
    struct Width {
        std::size_t column = 0;  ///< of the curve
        std::vector<double> values, linear, sampled;

        /// The sampled half width if available, else the linear one.
        [[nodiscard]] double half(std::size_t row) const noexcept;
    };
    std::vector<Width> widths;
    std::string meaning = "±1 standard deviation";  ///< in the legend of a plot
    std::vector<int> samples;  ///< number of samples that reach the value, per row; empty: not sampled

    [[nodiscard]] const Width* find(std::size_t column) const noexcept;  ///< nullptr if the table has no such column
};

/// Collects the curves of the shifted and sampled constants, one at a time.
class BandSum {
public:
    /// Throws as rows_at for the curve of the fitted constants.
    BandSum(const Curve& fitted, std::span<const Request> requests);

    /// nullptr means a path that was not computed. Throws Error(bad_input) for a curve with other columns.
    void add_pair(const Curve* plus, const Curve* minus);
    void add_sample(const Curve* sample);

    [[nodiscard]] const Curve& rows() const noexcept {
        return rows_;
    }  ///< of the fitted constants, at the requested values
    [[nodiscard]] Band band() const;
    /// Warnings, one sentence each: rows that a shifted curve or a sample does not reach, and rows where nothing varies.
    [[nodiscard]] std::vector<std::string> notes() const;

private:
    using Rows = std::vector<std::optional<std::vector<double>>>;  ///< one per row of the table
    [[nodiscard]] Rows rows_of(const Curve* curve) const;
    [[nodiscard]] std::string location(std::size_t row) const;

    std::vector<Request> requests_;       ///< one per row
    std::vector<std::size_t> crossings_;  ///< number of the crossing of its value, one per row
    Curve rows_;
    std::vector<std::vector<double>> variance_;  ///< [row][column], from the pairs; empty if a pair is incomplete
    std::vector<Rows> samples_;
};

/// The table as CSV. `rows` is BandSum::rows().
[[nodiscard]] std::string band_csv(const Curve& rows, const Band& band);

/// Throws Error (bad_input) for a table without bands of this curve, a cell that is not a number, or a negative width.
[[nodiscard]] Band read_band(const core::Table& table, const Curve& curve);

}  // namespace soft::post
