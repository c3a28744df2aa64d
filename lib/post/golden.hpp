#pragma once
/// A path against a table of the same case that is known to be right: `postprocess --check golden.csv`.
///
/// The golden rows need not be the rows of the path: another machine, release or step rule may put its steps elsewhere on the
/// same curve. So each golden row is compared with the place on the smooth path (post/interpolate) where one coordinate has
/// its golden value: the first of time, outputs, volume, load and the others that goes one way through all golden rows, else
/// the one that turns back least. Of several such places those are taken that together lie nearest to the golden rows in the
/// other coordinates (each over its golden range) without going back along the path.
/// A row agrees in a column where |found - golden| <= atol + rtol max(|golden|, 1e-3 largest |golden| of the column).
/// Between two rows of the path, values that the solver does not follow (stretches, energies, error bars) are granted the
/// difference between smooth and straight interpolation besides. `stable` and `stage` may be those of either row (at a row,
/// also those of its neighbours). `step` is not compared. Tested by post/golden_test.
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "post/curve.hpp"
#include "table/table.hpp"

namespace soft::post {

/// Largest allowed absolute difference; of every column, in its own unit, where `quantity` is empty.
struct Allowance {
    std::string quantity;
    double value = 0;  ///< in the unit of the column
};

/// "pressure=5Pa", "min_J=1e-4" or "1e-9". Errors (usage): no such column, no value with a unit of its kind.
[[nodiscard]] Allowance parse_allowance(std::string_view text, const Curve& curve);

struct Tolerance {
    double relative = 1e-3;
    std::vector<Allowance> absolute;
};

/// Where a column first differs.
struct Difference {
    std::size_t row = 0;  ///< of the golden table
    double golden = 0, found = 0;
    double allowed = 0;
    bool reached = true;  ///< false: the path does not reach this row; `found` is its nearest end
};

struct ColumnVerdict {
    std::string name;
    bool present = true;  ///< in the path
    std::optional<Difference> first;
    std::size_t differing_rows = 0;
};

struct Verdict {
    std::string leader;  ///< column by which the rows were found
    std::vector<ColumnVerdict> columns;
    std::size_t rows = 0, differing_rows = 0;
    double nearest_miss = 0;  ///< largest |found - golden| / allowed
    double covered = 1;  ///< share of the path's length between the first and the last golden row that is found on it

    [[nodiscard]] bool agrees() const noexcept;
};

/// Errors (bad_input): a golden table without header or with a cell that is no number, or without any coordinate of the curve.
[[nodiscard]] Verdict check_golden(const Curve& curve, const table::Table& golden, const Tolerance& tolerance);

/// One line: "golden.csv:14: pressure_kPa is 41.2 where elongation_mm is 80, golden 40.1: 1.1 apart, allowed 0.04; ...".
/// For the first column in the first row that differs; only where the verdict does not agree.
[[nodiscard]] std::string failure_text(const Verdict& verdict, const table::Table& golden);
/// The same of one column; empty where it agrees.
[[nodiscard]] std::string failure_text(const Verdict& verdict, const ColumnVerdict& column, const table::Table& golden);

}  // namespace soft::post
