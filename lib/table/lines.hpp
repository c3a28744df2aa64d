#pragma once
/// Text to lines, lines to cells. Internal. Tested by table/read_test.
#include <string_view>
#include <vector>

#include "table/table.hpp"

namespace soft::table {

/// Lines with their ends: "\n", "\r\n" or "\r".
[[nodiscard]] std::vector<std::string_view> split_lines(std::string_view text);

[[nodiscard]] bool is_comment(std::string_view line);

/// Among ; tab | , and blanks; see Table.
[[nodiscard]] char find_delimiter(const std::vector<std::string_view>& lines, Decimal decimal);

/// Fills rows and lines of `table`, which has its source and delimiter. Throws Error (bad_input) for a quote that stays open.
void read_rows(Table& table, const std::vector<std::string_view>& lines);

/// What a row holds, empty cells left out.
struct Content {
    int numbers = 0, words = 0;
};
[[nodiscard]] Content content_of(const std::vector<std::string>& row, Decimal decimal);

}  // namespace soft::table
