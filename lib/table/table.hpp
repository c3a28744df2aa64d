#pragma once
/// Tables as people and instruments write them: CSV with any usual delimiter. Tested by table/read_test, table/values_test.
///
/// What is understood: of ; tab | , and runs of blanks the one that makes the most lines rows of numbers (the first of equals;
/// where none does, the first that gives most lines the same number of cells); quotes as in RFC 4180; a decimal comma where
/// the delimiter is another; lines that start with #, empty lines and lines of delimiters alone are no data; a byte order mark
/// and CR LF; a first line without any number as header, and a line of units below it.
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/units.hpp"

namespace soft::table {

enum class Decimal {
    either,  ///< each cell as it is: "1.5" and "1,5"
    point,
    comma
};

enum class Layout {
    plain,  ///< header or numbers in the first line; every line has as many cells as the first
    described  ///< lines of description may stand above the header: the last line before the first row of two or more numbers
    ///< (and nothing else) that holds words in two or more cells and no number. Every line from there on is data,
    ///< so that a slip of the pen in one is an error, not a description. Short lines have empty cells at their end.
};

struct Format {
    std::optional<char> delimiter = {};  ///< nullopt: found; ' ' stands for runs of blanks
    Decimal decimal = Decimal::either;
    Layout layout = Layout::plain;
};

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
    std::size_t header_line = 0;                 ///< of the file, from 1; 0 where there is no header
    std::vector<std::vector<std::string>> rows;  ///< all of the same width
    std::vector<std::size_t> lines;              ///< of the file, from 1: where each row begins
    char delimiter = ',';
    Decimal decimal = Decimal::either;  ///< how cells are read as numbers

    [[nodiscard]] std::size_t width() const noexcept { return rows.empty() ? headings.size() : rows.front().size(); }
};

/// Errors (bad_input, with source:line): no data, a line with another number of cells (plain), a quote that stays open, a file
/// that is no text (zero bytes, an archive such as xlsx and ods).
[[nodiscard]] Table read_table(std::string_view text, std::string_view source, const Format& format = {});

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
