#include "design/markdown.hpp"

namespace soft::design {

std::string code(std::string_view text) { return std::string{"`"}.append(text).append("`"); }

std::string table_row(const std::vector<std::string>& cells) {
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

std::string table_head(const std::vector<std::string>& titles) {
    std::string line = "|";
    for (std::size_t i = 0; i < titles.size(); ++i) line += "---|";
    return table_row(titles) + line + "\n";
}

}  // namespace soft::design
