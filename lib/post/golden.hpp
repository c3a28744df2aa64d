#pragma once
/// Compares a path with a reference table of the same case (golden file): `postprocess --check golden.csv`.
///
/// The golden rows need not be rows of the path: another machine, release or step-size rule may choose other steps on the same curve.
/// Each golden row is therefore compared with the position on the smooth path (post/interpolate) where one coordinate, the leader, has
/// its golden value. The leader is the first of time, outputs, volume, load and the others with the fewest reversals over the golden
/// rows; where it stands still, any other coordinate serves too. Among several crossings, the positions are chosen that together lie
/// nearest to the golden rows in the other coordinates (each divided by its golden range) without moving backwards along the path; where
/// these do not change, in the other quantities.
/// A row agrees in a column if |found - golden| <= atol + rtol max(|golden|, 1e-3 largest |golden| of the column).
/// Between two rows of the path, quantities without slopes from the solver (stretches, energies, error bars) are additionally allowed
/// the difference between smooth and linear interpolation. `stable` and `stage` may have the value of either row (at a row, also those
/// of its neighbours). `step` is not compared. Tested by post/golden_test.
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/table.hpp"
#include "post/curve.hpp"

namespace soft::post {

/// Largest allowed absolute difference; applies to every column, in its own unit, if `quantity` is empty.
struct Allowance {
    std::string quantity;
    double value = 0;  ///< in the unit of the column
};

/// Parses "pressure=5Pa", "min_J=1e-4" or "1e-9". Throws Error (usage) for an unknown column or a value without a matching unit.
[[nodiscard]] Allowance parse_allowance(std::string_view text, const Curve& curve);

struct Tolerance {
    double relative = 1e-3;
    std::vector<Allowance> absolute;
};

/// First difference in a column.
struct Difference {
    std::size_t row = 0;  ///< row of the golden table
    double golden = 0, found = 0;
    double allowed = 0;
    bool reached = true;  ///< false: the path does not reach this row; `found` is its nearest end
};

struct ColumnVerdict {
    std::string name;
    bool present = true;  ///< the path has this column
    std::optional<Difference> first;
    std::size_t differing_rows = 0;
};

struct Verdict {
    std::string leader;  ///< column that locates the rows on the path
    std::vector<ColumnVerdict> columns;
    std::size_t rows = 0, differing_rows = 0;
    double nearest_miss = 0;  ///< largest |found - golden| / allowed
    double covered = 1;       ///< fraction of the path length between the first and the last golden row found on it

    [[nodiscard]] bool agrees() const noexcept;
};

/// Throws Error (bad_input) for a golden table without header, with a cell that is not a number, or without a coordinate of the curve.
[[nodiscard]] Verdict check_golden(const Curve& curve, const core::Table& golden, const Tolerance& tolerance);

/// One line: "golden.csv:14: pressure_kPa is 41.2 where elongation_mm is 80, golden 40.1: 1.1 apart, allowed 0.04; ...".
/// Reports the first column of the first differing row. Empty if all columns agree.
[[nodiscard]] std::string failure_text(const Verdict& verdict, const core::Table& golden);
/// The same for one column; empty if it agrees.
[[nodiscard]] std::string failure_text(const Verdict& verdict, const ColumnVerdict& column, const core::Table& golden);

}  // namespace soft::post
