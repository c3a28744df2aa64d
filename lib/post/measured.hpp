#pragma once
/// Measured data for a case, its columns found by their headers: `postprocess --compare measured.csv`.
///
/// A quantity of the curve (pressure, elongation, volume ...) is the column that --columns names; else the free one whose header
/// says so, in any letter case; else, where neither load nor time or nothing else was found, the only column in a unit of its
/// kind, if the curve has one quantity of that kind as well. Tested by post/compare_test.
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "post/curve.hpp"
#include "table/table.hpp"

namespace soft::post {

/// One entry of --columns.
struct ColumnChoice {
    std::string quantity;
    std::string column;  ///< its number, from 1, or its name
    std::string unit;    ///< empty: that of the header
};

/// "pressure=2:psi,elongation=1" or "pressure=Druck". Error(usage) for what is no such text.
[[nodiscard]] std::vector<ColumnChoice> parse_column_choices(std::string_view text);

/// A measured quantity in the unit of the curve's column.
struct Series {
    std::size_t column = 0;      ///< of the curve
    std::vector<double> values;  ///< one a row of the file
    std::string origin;          ///< "column 2 'Druck (psi)'"
};

struct Measured {
    std::string source;
    std::vector<std::size_t> lines;  ///< of the file, one a row
    std::vector<Series> series;      ///< in the order of the curve's columns

    /// nullptr where that column of the curve was not measured.
    [[nodiscard]] const Series* find(std::size_t column) const noexcept;
};

/// Errors: usage for a choice of a quantity or column that does not exist; bad_input where the load (of a motion the time) or
/// anything to set it against is not found, a unit is missing or of another kind, or a cell is no number.
[[nodiscard]] Measured read_measured(const table::Table& file, const Curve& curve,
                                     std::span<const ColumnChoice> choices);

}  // namespace soft::post
