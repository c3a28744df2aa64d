#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "core/table.hpp"
#include "core/table_lines.hpp"
#include "core/text.hpp"

namespace soft::core {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF", zip_mark = "PK\x03\x04";

Error bad(std::string_view source, std::size_t line, const std::string& problem, std::string_view remedy = {}) {
    return {ExitCode::bad_input, std::string{source} + ":" + std::to_string(line), problem, remedy};
}

void check_is_text(std::string_view text, std::string_view source) {
    constexpr std::string_view remedy = "save it as CSV in UTF-8";
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        throw Error(ExitCode::bad_input, source, "is UTF-16 text", remedy);
    if (text.starts_with(zip_mark))
        throw Error(ExitCode::bad_input, source, "is an archive or a spreadsheet (xlsx, ods), not a text table",
                    remedy);
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos)
        throw bad(source, split_lines(text.substr(0, zero + 1)).size(), "contains a zero byte: the file is not text",
                  remedy);
}

void check_widths(Table& table) {
    const std::size_t width = table.rows.front().size();
    for (std::size_t i = 1; i < table.rows.size(); ++i) {
        auto& row = table.rows[i];
        if (row.size() == width + 1 && row.back().empty()) row.pop_back();  // a delimiter at the end of the line
        if (row.size() != width)
            throw bad(table.source, table.lines[i],
                      "has " + std::to_string(row.size()) + " cells, the first line has " + std::to_string(width),
                      "put # before lines that are not data");
    }
}

/// The unit in a cell of a line of units: "(kPa)", "kPa".
std::string unit_of(const std::string& cell) { return parse_heading("x " + cell).unit; }

/// Whether a row is a line of units: no numbers, and at least one cell that consists of a known unit.
bool is_row_of_units(const std::vector<std::string>& row, Decimal decimal) {
    return count_content(row, decimal).numbers == 0 && std::ranges::any_of(row, [](const std::string& cell) {
               const Heading heading = parse_heading("x " + cell);
               return !heading.unit.empty() && heading.quantity == "x";
           });
}

/// Whether row i may be the header of a row of numbers. With blanks as the delimiter a sentence looks like a header; it is
/// recognised by having more words than there are columns.
bool may_be_header(const Table& table, std::size_t i, std::size_t numbers) {
    const Content content = count_content(table.rows[i], table.decimal);
    const bool is_sentence = table.delimiter == ' ' && table.rows[i].size() > table.rows[numbers].size();
    return content.numbers == 0 && content.words >= 2 && !is_sentence;
}

/// The header row; nullopt without a header. The rows above the header, or above the numbers, are description.
std::optional<std::size_t> find_header(const Table& table, std::size_t first_numbers) {
    const auto is_title = [&](std::size_t i) { return may_be_header(table, i, first_numbers); };
    for (std::size_t i = first_numbers; i-- > 0;)
        if (is_title(i)) return i > 0 && is_row_of_units(table.rows[i], table.decimal) && is_title(i - 1) ? i - 1 : i;
    return std::nullopt;
}

bool is_row_of_numbers(const Table& table, std::size_t i) {
    const Content content = count_content(table.rows[i], table.decimal);
    return content.numbers >= 2 && content.words == 0;
}

/// The first row of numbers of the main table. Testing machines write a table of results, one row per specimen, above the measured
/// data. A later table is therefore chosen if its header has other titles and a line of units and more rows of numbers follow.
std::size_t first_of_main_table(const Table& table, std::size_t first_numbers) {
    const auto header_of_first = find_header(table, first_numbers);
    if (!header_of_first) return first_numbers;
    struct Block {
        std::size_t header, first, count;
    };
    Block best{*header_of_first, first_numbers, 0}, block = best;
    bool is_best = true;  // whether `block` is the best one so far
    for (std::size_t i = first_numbers; i < table.rows.size(); ++i) {
        const bool is_header = i + 2 < table.rows.size() && may_be_header(table, i, first_numbers) &&
                               is_row_of_units(table.rows[i + 1], table.decimal) && is_row_of_numbers(table, i + 2);
        if (is_header) {
            block = {i, i + 2, 0};
            is_best = false;
            ++i;
        } else if (is_row_of_numbers(table, i) && ++block.count > best.count &&
                   (is_best || table.rows[block.header] != table.rows[best.header])) {
            best = block;
            is_best = true;
        }
    }
    return best.first;
}

/// Removes the description, so that the first row is the header or the first row of numbers; pads all rows to equal width.
void remove_description(Table& table, const Format& format) {
    std::size_t first_numbers = 0;
    while (first_numbers < table.rows.size() && !is_row_of_numbers(table, first_numbers)) ++first_numbers;
    if (first_numbers == table.rows.size())
        throw bad(table.source, table.lines.empty() ? 1 : table.lines.back(), "no line consists of two or more numbers",
                  format.delimiter || format.decimal != Decimal::either
                      ? "check the delimiter and the decimal mark that are given"
                      : "write one row per line: numbers with a delimiter between them");
    first_numbers = first_of_main_table(table, first_numbers);
    const auto begin = static_cast<std::ptrdiff_t>(find_header(table, first_numbers).value_or(first_numbers));
    table.rows.erase(table.rows.begin(), table.rows.begin() + begin);
    table.lines.erase(table.lines.begin(), table.lines.begin() + begin);
    std::size_t width = 0;
    for (const auto& row : table.rows) width = std::max(width, row.size());
    for (auto& row : table.rows) row.resize(width);
}

/// Moves the header row, and a line of units below it, into `headings`.
void read_headings(Table& table) {
    const auto take_first = [&] {
        std::vector<std::string> row = std::move(table.rows.front());
        table.rows.erase(table.rows.begin());
        table.lines.erase(table.lines.begin());
        return row;
    };
    if (count_content(table.rows.front(), table.decimal).numbers > 0) return;
    table.header_line = table.lines.front();
    for (const std::string& name : take_first()) table.headings.push_back(parse_heading(name));
    if (table.rows.empty() || !is_row_of_units(table.rows.front(), table.decimal)) return;
    const std::vector<std::string> units = take_first();
    for (std::size_t i = 0; i < units.size(); ++i)
        if (table.headings[i].unit.empty()) table.headings[i].unit = unit_of(units[i]);
}

}  // namespace

Table read_table(std::string_view text, std::string_view source, const Format& format) {
    check_is_text(text, source);
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    const std::vector<std::string_view> lines = split_lines(text);
    Table table;
    table.source = source;
    table.decimal = format.decimal;
    table.delimiter = format.delimiter ? *format.delimiter : find_delimiter(lines, format.decimal);
    read_rows(table, lines);
    if (!table.rows.empty()) {
        format.layout == Layout::described ? remove_description(table, format) : check_widths(table);
        read_headings(table);
    }
    if (table.rows.empty()) throw Error(ExitCode::bad_input, source, "contains no row of numbers");
    return table;
}

}  // namespace soft::core
