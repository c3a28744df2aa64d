#pragma once
/// Measured data for a case, with columns identified by their headers: `postprocess --compare measured.csv`.
///
/// The column of a quantity of the curve (pressure, elongation, volume ...) is the one named in --columns; else the unassigned one whose
/// header names the quantity, case-insensitive; else, if the load (or time) or all other quantities are still missing, the only column
/// with a unit of its dimension, provided that the curve has only one quantity of that dimension. Tested by post/compare_test.
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/table.hpp"
#include "post/curve.hpp"

namespace soft::post {

/// One entry of --columns.
struct ColumnChoice {
    std::string quantity;
    std::string column;  ///< its number, from 1, or its name
    std::string unit;    ///< empty: as in the header
};

/// Parses "pressure=2:psi,elongation=1" or "pressure=Druck". Throws Error(usage) for any other text.
[[nodiscard]] std::vector<ColumnChoice> parse_column_choices(std::string_view text);

/// A measured quantity in the unit of the curve's column.
struct Series {
    std::size_t column = 0;      ///< of the curve
    std::vector<double> values;  ///< one per row of the file
    std::string origin;          ///< "column 2 'Druck (psi)'"
};

struct Measured {
    std::string source;
    std::vector<std::size_t> lines;  ///< line in the file, one per row
    std::vector<Series> series;      ///< in the order of the curve's columns

    /// nullptr if that column of the curve was not measured.
    [[nodiscard]] const Series* find(std::size_t column) const noexcept;
};

/// Throws Error: usage for a choice of an unknown quantity or column; bad_input if the load (for a motion the time) or any quantity to
/// compare it with is not found, if a unit is missing or has another dimension, or if a cell is not a number.
[[nodiscard]] Measured read_measured(const core::Table& file, const Curve& curve,
                                     std::span<const ColumnChoice> choices);

}  // namespace soft::post
