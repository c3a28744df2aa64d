#include "fit/table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"

namespace soft::fit {
namespace {

struct Line {
    std::size_t number = 0;
    std::string_view text;
};

[[noreturn]] void refuse(std::string_view source, std::size_t line, std::string_view problem, std::string_view remedy) {
    throw Error(ExitCode::bad_input, std::string{source} + ":" + std::to_string(line), problem, remedy);
}

/// Those that hold something, without comments.
std::vector<Line> lines_of(std::string_view text) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    if (text.starts_with(mark)) text.remove_prefix(mark.size());
    std::vector<Line> lines;
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.ends_with('\r')) line.remove_suffix(1);
        const std::string_view content = core::trimmed(line);
        if (!content.empty() && !content.starts_with('#')) lines.push_back({number, line});
    }
    return lines;
}

char delimiter_of(const std::vector<Line>& lines) {
    constexpr std::array candidates{';', '\t', '|', ',', ' '};
    for (const char candidate : candidates) {
        const auto holding = std::count_if(lines.begin(), lines.end(), [&](const Line& line) {
            return core::trimmed(line.text).find(candidate) != std::string_view::npos;
        });
        if (2 * static_cast<std::size_t>(holding) > lines.size()) return candidate;
    }
    return ',';
}

/// One field from `rest`, which is left at what stands behind its delimiter; `more` says whether one stood there.
std::string next_field(std::string_view& rest, char delimiter, bool& more, std::string_view source, std::size_t line) {
    std::string field;
    while (!rest.empty() && rest.front() == ' ') rest.remove_prefix(1);
    const bool in_quotes = rest.starts_with('"');
    if (in_quotes) {
        rest.remove_prefix(1);
        while (true) {
            const std::size_t quote = rest.find('"');
            if (quote == std::string_view::npos)
                refuse(source, line, "a quote is not closed", "close it in the same line");
            field += rest.substr(0, quote);
            rest.remove_prefix(quote + 1);
            if (!rest.starts_with('"')) break;
            field += '"';
            rest.remove_prefix(1);
        }
    }
    const std::size_t end = rest.find(delimiter);
    more = end != std::string_view::npos;
    field += rest.substr(0, more ? end : rest.size());
    rest.remove_prefix(more ? end + 1 : rest.size());
    return std::string{core::trimmed(field)};
}

Table::Row row_of(const Line& line, char delimiter, std::string_view source) {
    Table::Row row{line.number, {}};
    // Blanks may stand in any number, also around the line.
    std::string_view rest = delimiter == ' ' ? core::trimmed(line.text) : line.text;
    for (bool more = true; more;) row.fields.push_back(next_field(rest, delimiter, more, source, line.number));
    return row;
}

struct Content {
    int numbers = 0, words = 0;
};
Content content_of(const Table::Row& row, Decimal decimal) {
    Content content;
    for (const std::string& field : row.fields)
        if (!field.empty()) ++(number_of(field, decimal) ? content.numbers : content.words);
    return content;
}

}  // namespace

std::optional<double> number_of(std::string_view field, Decimal decimal) {
    std::string text{core::trimmed(field)};
    if (decimal == Decimal::comma) std::replace(text.begin(), text.end(), ',', '.');
    const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const char* end = text.data() + text.size();
    double value = 0;
    const auto [stop, failure] = std::from_chars(begin, end, value);
    if (failure != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

Table read_table(std::string_view text, std::string_view source, const TableFormat& format) {
    const std::vector<Line> lines = lines_of(text);
    const char delimiter = format.delimiter ? *format.delimiter : delimiter_of(lines);
    std::vector<Table::Row> rows;
    for (const Line& line : lines) {
        rows.push_back(row_of(line, delimiter, source));
        const Content content = content_of(rows.back(), format.decimal);
        if (content.numbers + content.words == 0) rows.pop_back();  // delimiters alone
    }
    const auto numeric = std::find_if(rows.begin(), rows.end(), [&](const Table::Row& row) {
        const Content content = content_of(row, format.decimal);
        return content.numbers >= 2 && content.words == 0;
    });
    if (numeric == rows.end())
        refuse(source, rows.empty() ? 1 : rows.back().line, "no line holds two numbers and nothing else",
               "one row a line: strain and stress; --delimiter and --decimal comma say how they are written");
    Table table;
    table.source = source;
    auto first = numeric;
    while (first != rows.begin()) {
        const Content above = content_of(*std::prev(first), format.decimal);
        if (above.numbers == 0 && above.words >= 2) {
            table.header = std::prev(first)->fields;
            table.header_line = std::prev(first)->line;
            break;
        }
        --first;
    }
    if (table.header.empty()) first = numeric;
    table.rows.assign(std::make_move_iterator(first), std::make_move_iterator(rows.end()));
    return table;
}

}  // namespace soft::fit
