#pragma once
/// Tables as people and instruments write them: CSV with any usual delimiter. Held by table/read_test, table/values_test.
///
/// What is understood: the first of ; tab | , and runs of blanks that gives most lines the same number of cells (two or
/// more); quotes as in RFC 4180; a decimal comma where the delimiter is another; lines that start with # and empty lines are
/// no data; a byte order mark and CR LF; a first line without any number as header, and a line of units below it.
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/units.hpp"

namespace soft::table {

/// A column's name taken apart: "Pressure (psi)", "Pressure [psi]", "pressure_psi", "Pressure / psi", "Pressure in psi" and
/// "Pressure, psi" are the quantity "Pressure" in psi.
struct Heading {
    std::string name;      ///< as it stands
    std::string quantity;  ///< without the unit
    std::string unit;      ///< "kPa"; empty where none is known
};

struct Table {
    std::string source;                          ///< file, for errors
    std::vector<Heading> headings;               ///< one a column; empty where the file has no header
    std::vector<std::vector<std::string>> rows;  ///< all of the same width
    std::vector<std::size_t> lines;              ///< of the file, from 1: where each row begins
    char delimiter = ',';

    [[nodiscard]] std::size_t width() const noexcept { return rows.empty() ? headings.size() : rows.front().size(); }
};

/// Errors (bad_input, with source:line): no data, a line with another number of cells, a quote that stays open.
[[nodiscard]] Table read_table(std::string_view text, std::string_view source);

[[nodiscard]] Heading parse_heading(std::string_view name);

/// What a unit measures; nullopt for no unit that core/units knows.
[[nodiscard]] std::optional<core::Dimension> dimension_of(std::string_view unit);

/// "column 2 'Pressure (psi)'", for messages.
[[nodiscard]] std::string column_text(const Table& table, std::size_t column);

/// Errors (bad_input, with source:line and column) of both: a cell that is empty or no finite number.
[[nodiscard]] std::vector<double> numbers(const Table& table, std::size_t column);
/// Cells in `unit` (of a ratio: empty or %), in SI. Decimal prefixes are exact, as in core/units.
[[nodiscard]] std::vector<double> values_SI(const Table& table, std::size_t column, std::string_view unit,
                                            core::Dimension dimension);

}  // namespace soft::table
