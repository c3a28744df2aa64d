#pragma once
/// A text table as machines and spreadsheets write it: any delimiter, quotes, comment lines (#), a byte order mark, lines of
/// description before the header, LF or CRLF. An own reader: the one of the distribution, libcsv (3.0.3 of 2013), hands
/// out fields without the line they stand on, and an error here names its line.
/// The data begin behind the last line before the first line of numbers that holds words in two or more fields and no
/// number: the header. Every line from there on is data, so that a slip of the pen in one is an error, not a description.
/// Held by fit/table_test.
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace soft::fit {

enum class Decimal { point, comma };

struct TableFormat {
    std::optional<char> delimiter =
        {};  ///< nullopt: the first of ; tab | , blank that more than half of the lines hold
    Decimal decimal = Decimal::point;
};

struct Table {
    struct Row {
        std::size_t line = 0;             ///< from 1
        std::vector<std::string> fields;  ///< without blanks around, without quotes
    };
    std::string source;
    std::vector<std::string> header;  ///< empty: the file begins with numbers
    std::size_t header_line = 0;
    std::vector<Row> rows;
};

/// Throws Error (bad_input) "source:line: ..." for a quote that is not closed and a file without two numbers in a line.
[[nodiscard]] Table read_table(std::string_view text, std::string_view source, const TableFormat& format = {});

/// The whole field as a finite number; nullopt otherwise.
[[nodiscard]] std::optional<double> number_of(std::string_view field, Decimal decimal);

}  // namespace soft::fit
