#pragma once
/// The uncertainty of a curve that the errors of fitted constants cause: one standard deviation of every quantity, at given
/// values of another one (the held quantity, which has none). scripts/uncertainty writes it, plots draw it.
///     linear    s^2 = sum_k ((q(c + L_k) - q(c - L_k)) / 2)^2, over pairs of curves (fit/shifted_constants.hpp)
///     sampled   s^2 = sum (q - mean)^2 / (n - 1), over the n samples that reach the value
/// Table: the columns of the curve, one row per crossing of each value, and of each coordinate `pressure_band_kPa` (linear) and
/// `pressure_sampled_band_kPa`, in its unit, and `samples` (n). A cell is empty for the held quantity, where a shifted
/// curve does not reach the value, and where n < 2. Tested by post/band_test.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "post/curve.hpp"
#include "post/request.hpp"
#include "table/table.hpp"

namespace soft::post {

struct Band {
    /// A coordinate of the curve, in its unit; one value per row; NaN: none.
    struct Width {
        std::size_t column = 0;  ///< of the curve
        std::vector<double> values, linear, sampled;

        /// The sampled one if there is one, else the linear one.
        [[nodiscard]] double half(std::size_t row) const noexcept;
    };
    std::vector<Width> widths;
    std::vector<int> samples;  ///< that reach the value, one per row; empty: not sampled

    [[nodiscard]] const Width* find(std::size_t column) const noexcept;  ///< nullptr where the table has no such column
};

/// Collects the curves of the shifted and sampled constants, one at a time.
class BandSum {
public:
    /// Errors: as rows_at for the curve of the fitted constants.
    BandSum(const Curve& fitted, std::span<const Request> requests);

    /// nullptr: a path that was not computed. Error(bad_input) for a curve with other columns.
    void add_pair(const Curve* plus, const Curve* minus);
    void add_sample(const Curve* sample);

    [[nodiscard]] const Curve& rows() const noexcept { return rows_; }  ///< of the fitted constants, at the values
    [[nodiscard]] Band band() const;
    /// What the band leaves out, one sentence per row that lacks a shifted curve or a sample; and where nothing varies.
    [[nodiscard]] std::vector<std::string> notes() const;

private:
    using Rows = std::vector<std::optional<std::vector<double>>>;  ///< one per row of the table
    [[nodiscard]] Rows rows_of(const Curve* curve) const;
    [[nodiscard]] std::string place(std::size_t row) const;

    std::vector<Request> requests_;       ///< one per row
    std::vector<std::size_t> crossings_;  ///< of its value, one per row
    Curve rows_;
    std::vector<std::vector<double>> variance_;  ///< [row][column], of the pairs; empty where a pair is not complete
    std::vector<Rows> samples_;
};

/// The table. `rows`: BandSum::rows().
[[nodiscard]] std::string band_csv(const Curve& rows, const Band& band);

/// Errors (bad_input): a table without bands of this curve, a cell that is no number, a negative width.
[[nodiscard]] Band read_band(const table::Table& table, const Curve& curve);

}  // namespace soft::post
