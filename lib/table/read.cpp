#include <csv.h>

#include <algorithm>
#include <map>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"
#include "table/cell.hpp"
#include "table/table.hpp"

namespace soft::table {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::size_t sampled_lines = 50;  // enough to tell the delimiter

Error bad(std::string_view source, std::size_t line, const std::string& problem, std::string_view remedy = {}) {
    return {ExitCode::bad_input, std::string{source} + ":" + std::to_string(line), problem, remedy};
}

/// Lines with their ends: "\n", "\r\n" or "\r".
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

/// ' ' stands for a run of blanks.
std::size_t count_cells(std::string_view line, char delimiter) {
    std::size_t cells = 1;
    bool quoted = false, after_blank = true;
    for (const char c : core::trimmed(line)) {
        if (c == '"') quoted = !quoted;
        const bool separates = !quoted && (delimiter == ' ' ? c == ' ' || c == '\t' : c == delimiter);
        if (separates && !(delimiter == ' ' && after_blank)) ++cells;
        after_blank = separates;
    }
    return cells;
}

char find_delimiter(const std::vector<std::string_view>& lines) {
    for (const char delimiter : {';', '\t', '|', ',', ' '}) {
        std::map<std::size_t, std::size_t> lines_of;  // by their number of cells
        std::size_t sampled = 0, most = 0;
        for (const std::string_view line : lines) {
            if (core::trimmed(line).empty() || is_comment(line)) continue;
            const std::size_t cells = count_cells(line, delimiter), same = ++lines_of[cells];
            if (cells > 1) most = std::max(most, same);
            if (++sampled == sampled_lines) break;
        }
        if (2 * most > sampled) return delimiter;
    }
    return ',';
}

std::string with_tabs_for_blanks(std::string_view line) {
    std::string text;
    for (const char c : core::trimmed(line)) {
        if (c != ' ' && c != '\t')
            text += c;
        else if (!text.ends_with('\t'))
            text += '\t';
    }
    return text;
}

/// libcsv's parser, and the rows it has found.
class Parser {
public:
    explicit Parser(char delimiter) {
        if (csv_init(&parser_, CSV_STRICT_FINI) != 0)
            throw Error(ExitCode::internal, "csv", "the parser does not start");
        csv_set_delim(&parser_, static_cast<unsigned char>(delimiter));
    }
    ~Parser() { csv_free(&parser_); }
    Parser(const Parser&) = delete;
    Parser& operator=(const Parser&) = delete;

    /// The row that this line completes; nullopt for an empty line and within quotes.
    [[nodiscard]] std::optional<std::vector<std::string>> take(std::string line) {
        line += '\n';
        complete_ = false;
        const std::size_t taken = csv_parse(&parser_, line.data(), line.size(), on_cell, on_row, this);
        if (taken != line.size()) throw Error(ExitCode::internal, "csv", csv_strerror(csv_error(&parser_)));
        open_ = !complete_ && (open_ || !core::trimmed(line).empty());
        if (!complete_) return std::nullopt;
        return std::exchange(cells_, {});
    }
    /// Within a quoted cell.
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

void read_rows(Table& table, const std::vector<std::string_view>& lines) {
    Parser parser(table.delimiter == ' ' ? '\t' : table.delimiter);
    std::size_t begin = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (!parser.is_open()) begin = i + 1;
        if (!parser.is_open() && is_comment(lines[i])) continue;
        auto row = parser.take(table.delimiter == ' ' ? with_tabs_for_blanks(lines[i]) : std::string{lines[i]});
        if (!row) continue;
        table.rows.push_back(std::move(*row));
        table.lines.push_back(begin);
    }
    if (parser.is_open()) throw bad(table.source, begin, "a quote is opened and not closed");
}

void check_widths(Table& table) {
    const std::size_t width = table.rows.front().size();
    for (std::size_t i = 1; i < table.rows.size(); ++i) {
        auto& row = table.rows[i];
        if (row.size() == width + 1 && row.back().empty()) row.pop_back();  // a delimiter at the end of the line
        if (row.size() != width)
            throw bad(table.source, table.lines[i],
                      "has " + std::to_string(row.size()) + " cells, the first line has " + std::to_string(width),
                      "put # before lines that are no data");
    }
}

/// What the first row says of the columns, and the second if it holds their units.
void take_headings(Table& table) {
    const auto take_first = [&] {
        std::vector<std::string> row = std::move(table.rows.front());
        table.rows.erase(table.rows.begin());
        table.lines.erase(table.lines.begin());
        return row;
    };
    if (std::any_of(table.rows.front().begin(), table.rows.front().end(), number_in)) return;
    for (const std::string& name : take_first()) table.headings.push_back(parse_heading(name));
    const auto unit_in = [](const std::string& cell) { return parse_heading("x " + cell).unit; };
    const auto is_unit = [&](const std::string& cell) { return !unit_in(cell).empty(); };
    if (table.rows.empty() || std::any_of(table.rows[0].begin(), table.rows[0].end(), number_in) ||
        std::none_of(table.rows[0].begin(), table.rows[0].end(), is_unit))
        return;
    const std::vector<std::string> units = take_first();
    for (std::size_t i = 0; i < units.size(); ++i)
        if (table.headings[i].unit.empty()) table.headings[i].unit = unit_in(units[i]);
}

}  // namespace

Table read_table(std::string_view text, std::string_view source) {
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        throw Error(ExitCode::bad_input, source, "is UTF-16 text", "save it as CSV in UTF-8");
    const std::vector<std::string_view> lines = split_lines(text);
    Table table;
    table.source = source;
    table.delimiter = find_delimiter(lines);
    read_rows(table, lines);
    if (!table.rows.empty()) {
        check_widths(table);
        take_headings(table);
    }
    if (table.rows.empty()) throw Error(ExitCode::bad_input, source, "holds no row of numbers");
    return table;
}

}  // namespace soft::table
