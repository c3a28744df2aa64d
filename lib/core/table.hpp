#pragma once
/// Reads tables of numbers: CSV with any common delimiter. Tested by core/table_read_test, core/table_values_test.
///
/// Delimiter: the one among ; tab | , and runs of blanks that turns the most lines into rows of numbers (the first of equals). If
/// none does, the first one that gives more than half of the lines the same number of cells. Quotes follow RFC 4180. A decimal
/// comma is accepted if the delimiter is not a comma. Lines that start with #, empty lines and lines that consist of delimiters
/// are skipped. A byte order mark and CR LF are accepted. A first line without numbers is the header; a line of units may follow.
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/units.hpp"

namespace soft::core {

enum class Decimal {
    either,  ///< decided per cell: "1.5" and "1,5"
    point,
    comma
};

enum class Layout {
    plain,  ///< the first line is the header or a row of numbers; every line has as many cells as the first
    /// Lines of description may precede the header. The header is the last line with words in two or more cells and no number before the
    /// first row of two or more numbers. Every later line is data, so that a typing error in it is an error and not a description. Short
    /// lines are padded with empty cells.
    described
};

struct Format {
    std::optional<char> delimiter = {};  ///< nullopt: detected automatically; ' ' matches runs of blanks
    Decimal decimal = Decimal::either;
    Layout layout = Layout::plain;
};

/// The parts of a column name: "Pressure (psi)", "Pressure [psi]", "pressure_psi", "Pressure / psi", "Pressure in psi" and
/// "Pressure, psi" are the quantity "Pressure" with the unit psi.
struct Heading {
    std::string name;      ///< as written
    std::string quantity;  ///< without the unit
    std::string unit;      ///< "kPa"; empty without a known unit
};

struct Table {
    std::string source;                          ///< file name, for errors
    std::vector<Heading> headings;               ///< one per column; empty without a header
    std::size_t header_line = 0;                 ///< line number in the file, from 1; 0 without a header
    std::vector<std::vector<std::string>> rows;  ///< all of the same width
    std::vector<std::size_t> lines;              ///< line number in the file, from 1, where each row begins
    char delimiter = ',';
    Decimal decimal = Decimal::either;  ///< how cells are read as numbers

    [[nodiscard]] std::size_t width() const noexcept { return rows.empty() ? headings.size() : rows.front().size(); }
};

/// Parses a table. Errors (bad_input, with source:line): no data, a line with a different number of cells (plain), an unclosed
/// quote, a file that is not text (zero bytes; an archive such as xlsx and ods).
[[nodiscard]] Table read_table(std::string_view text, std::string_view source, const Format& format = {});

[[nodiscard]] Heading parse_heading(std::string_view name);

/// "column 2 'Pressure (psi)'", for messages.
[[nodiscard]] std::string column_text(const Table& table, std::size_t column);

/// Values of a column. Errors (bad_input, with source:line and column) of both: a cell that is empty or not a finite number.
[[nodiscard]] std::vector<double> numbers(const Table& table, std::size_t column);
/// SI values of a column whose cells are in `unit` (for a ratio: empty or %). Decimal prefixes are exact, as in core/units.
[[nodiscard]] std::vector<double> values_SI(const Table& table, std::size_t column, std::string_view unit,
                                            core::Dimension dimension);

}  // namespace soft::core
