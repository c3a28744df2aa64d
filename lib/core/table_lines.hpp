#pragma once
/// Splits text into lines and lines into cells, and reads cells. Private to the module. Tested by core/table_read_test.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/table.hpp"

namespace soft::core {

/// Splits at "\n", "\r\n" or "\r"; the line ends are not included.
[[nodiscard]] std::vector<std::string_view> split_lines(std::string_view text);

[[nodiscard]] bool is_comment(std::string_view line);

/// Finds the delimiter among ; tab | , and blanks by the rules in table.hpp.
[[nodiscard]] char find_delimiter(const std::vector<std::string_view>& lines, Decimal decimal);

/// Fills rows and lines of `table`; its source and delimiter must be set. Throws Error (bad_input) for an unclosed quote.
void read_rows(Table& table, const std::vector<std::string_view>& lines);

/// The number of a cell as text for core/units ("1,5" becomes "1.5"); nullopt unless the cell is a finite decimal number.
[[nodiscard]] std::optional<std::string> decimal_text(const std::string& cell, Decimal decimal);

/// Number of numeric and of other non-empty cells of a row.
struct Content {
    int numbers = 0, words = 0;
};
[[nodiscard]] Content count_content(const std::vector<std::string>& row, Decimal decimal);

}  // namespace soft::core
