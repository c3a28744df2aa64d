#pragma once
/// Markdown tables of the reference pages. Private to the module. Tested by design/key_list_test.
#include <string>
#include <string_view>
#include <vector>

namespace soft::design {

/// "`text`"
[[nodiscard]] inline std::string code(std::string_view text) { return std::string{"`"}.append(text).append("`"); }

/// "| a | b |" and a line break; bars within a cell are escaped.
[[nodiscard]] inline std::string table_row(const std::vector<std::string>& cells) {
    std::string row = "|";
    for (const std::string& cell : cells) {
        row += ' ';
        for (const char c : cell) {
            if (c == '|') row += '\\';
            row += c;
        }
        row += " |";
    }
    return row + "\n";
}

/// The row of column titles and the line below it.
[[nodiscard]] inline std::string table_head(const std::vector<std::string>& titles) {
    std::string line = "|";
    for (std::size_t i = 0; i < titles.size(); ++i) line += "---|";
    return table_row(titles) + line + "\n";
}

}  // namespace soft::design
