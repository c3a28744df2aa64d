#include "core/table_lines.hpp"

#include <csv.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"

namespace soft::core {
namespace {

constexpr std::array delimiters{';', '\t', '|', ',', ' '};
constexpr std::size_t sampled_lines = 50;  // enough to determine the delimiter

bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string_view without_quotes(std::string_view cell) {
    cell = core::trimmed(cell);
    return cell.size() > 1 && cell.starts_with('"') && cell.ends_with('"') ? cell.substr(1, cell.size() - 2) : cell;
}

/// Calls take(cell) for each cell; the delimiter ' ' matches a run of blanks.
template <class Take>
void for_each_cell(std::string_view line, char delimiter, const Take& take) {
    line = core::trimmed(line);
    bool quoted = false;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"') quoted = !quoted;
        if (quoted || !(delimiter == ' ' ? is_blank(line[i]) : line[i] == delimiter)) continue;
        take(line.substr(begin, i - begin));
        while (delimiter == ' ' && is_blank(line[i + 1])) ++i;  // in bounds: a trimmed line does not end with a blank
        begin = i + 1;
    }
    take(line.substr(begin));
}

/// Number of lines that are rows of two or more numbers, up to `sampled_lines`.
std::size_t count_rows_of_numbers(const std::vector<std::string_view>& lines, char delimiter, Decimal decimal) {
    std::size_t count = 0;
    for (const std::string_view line : lines) {
        if (is_comment(line)) continue;
        std::vector<std::string> row;
        for_each_cell(line, delimiter, [&](std::string_view cell) { row.emplace_back(without_quotes(cell)); });
        const Content content = count_content(row, decimal);
        if (content.numbers >= 2 && content.words == 0 && ++count == sampled_lines) break;
    }
    return count;
}

/// Whether more than half of the lines have the same number of cells, with at least two cells.
bool has_constant_width(const std::vector<std::string_view>& lines, char delimiter) {
    std::map<std::size_t, std::size_t> lines_of;  // by their number of cells
    std::size_t sampled = 0, max_count = 0;
    for (const std::string_view line : lines) {
        if (core::trimmed(line).empty() || is_comment(line)) continue;
        std::size_t cells = 0;
        for_each_cell(line, delimiter, [&](std::string_view) { ++cells; });
        const std::size_t same = ++lines_of[cells];
        if (cells > 1) max_count = std::max(max_count, same);
        if (++sampled == sampled_lines) break;
    }
    return 2 * max_count > sampled;
}

std::string with_tabs_for_blanks(std::string_view line) {
    std::string text;
    for_each_cell(line, ' ', [&](std::string_view cell) { text.append(text.empty() ? "" : "\t").append(cell); });
    return text;
}

/// RAII wrapper of libcsv's parser that collects the cells of the current row.
class Parser {
public:
    explicit Parser(char delimiter) {
        if (csv_init(&parser_, CSV_STRICT_FINI) != 0)
            throw Error(ExitCode::internal, "csv", "the parser cannot be initialised");
        csv_set_delim(&parser_, static_cast<unsigned char>(delimiter));
    }
    ~Parser() { csv_free(&parser_); }
    Parser(const Parser&) = delete;
    Parser& operator=(const Parser&) = delete;

    /// Parses a line. Returns the row that it completes; nullopt for an empty line and inside a quoted cell.
    [[nodiscard]] std::optional<std::vector<std::string>> take(std::string line) {
        line += '\n';
        complete_ = false;
        const std::size_t taken = csv_parse(&parser_, line.data(), line.size(), on_cell, on_row, this);
        if (taken != line.size()) throw Error(ExitCode::internal, "csv", csv_strerror(csv_error(&parser_)));
        open_ = !complete_ && (open_ || !core::trimmed(line).empty());
        if (!complete_) return std::nullopt;
        return std::exchange(cells_, {});
    }
    /// Whether the parser is inside a quoted cell.
    [[nodiscard]] bool is_open() const noexcept { return open_; }

private:
    static void on_cell(void* text, std::size_t size, void* self) {
        static_cast<Parser*>(self)->cells_.emplace_back(static_cast<const char*>(text), size);
    }
    static void on_row(int, void* self) { static_cast<Parser*>(self)->complete_ = true; }

    csv_parser parser_{};
    std::vector<std::string> cells_;
    bool complete_ = false, open_ = false;
};

}  // namespace

std::vector<std::string_view> split_lines(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = text.find_first_of("\r\n");
        lines.push_back(text.substr(0, end));
        if (end == std::string_view::npos) break;
        text.remove_prefix(end + (text.substr(end).starts_with("\r\n") ? 2 : 1));
    }
    return lines;
}

bool is_comment(std::string_view line) { return core::trimmed(line).starts_with('#'); }

Content count_content(const std::vector<std::string>& row, Decimal decimal) {
    Content content;
    for (const std::string& cell : row)
        if (!core::trimmed(cell).empty()) ++(decimal_text(cell, decimal) ? content.numbers : content.words);
    return content;
}

char find_delimiter(const std::vector<std::string_view>& lines, Decimal decimal) {
    char best = ',';
    std::size_t max_count = 0;
    for (const char delimiter : delimiters)
        if (const std::size_t count = count_rows_of_numbers(lines, delimiter, decimal); count > max_count)
            best = delimiter, max_count = count;
    if (max_count > 0) return best;
    const auto grid =
        std::ranges::find_if(delimiters, [&](char delimiter) { return has_constant_width(lines, delimiter); });
    return grid == delimiters.end() ? ',' : *grid;
}

void read_rows(Table& table, const std::vector<std::string_view>& lines) {
    Parser parser(table.delimiter == ' ' ? '\t' : table.delimiter);
    std::size_t begin = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (!parser.is_open()) begin = i + 1;
        if (!parser.is_open() && is_comment(lines[i])) continue;
        auto row = parser.take(table.delimiter == ' ' ? with_tabs_for_blanks(lines[i]) : std::string{lines[i]});
        if (!row) continue;
        if (std::ranges::all_of(*row, [](const std::string& cell) { return core::trimmed(cell).empty(); })) continue;
        table.rows.push_back(std::move(*row));
        table.lines.push_back(begin);
    }
    if (parser.is_open())
        throw Error(ExitCode::bad_input, table.source + ":" + std::to_string(begin), "the quote is not closed");
}

}  // namespace soft::core
