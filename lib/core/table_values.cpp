#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/error.hpp"
#include "core/table.hpp"
#include "core/table_lines.hpp"
#include "core/text.hpp"

namespace soft::core {
namespace {

std::string_view without_brackets(std::string_view text) {
    text = core::trimmed(text);
    if (text.size() > 1 && ((text.front() == '(' && text.back() == ')') || (text.front() == '[' && text.back() == ']')))
        text = core::trimmed(text.substr(1, text.size() - 2));
    return text;
}

std::string cell_location(const Table& table, std::size_t row, std::size_t column) {
    return table.source + ":" + std::to_string(table.lines[row]) + ": " + column_text(table, column);
}

/// "1,400", "12,400": one comma followed by three digits, which is either a decimal comma or a thousands separator.
bool is_ambiguous_comma(std::string_view cell) {
    cell = core::trimmed(cell);
    const std::size_t comma = cell.find(',');
    return comma != std::string_view::npos && cell.size() == comma + 4 && comma >= 1 && comma <= 4 &&
           cell.front() != '0' && cell.find_first_not_of("0123456789", comma + 1) == std::string_view::npos;
}

/// Whether any cell has a decimal point; a comma is then not a decimal comma.
bool has_decimal_points(const Table& table) {
    return std::ranges::any_of(table.rows, [](const auto& row) {
        return std::ranges::any_of(row, [](const std::string& cell) {
            return cell.find('.') != std::string::npos && decimal_text(cell, Decimal::point);
        });
    });
}

/// Reads the cells of one column as decimal text.
class ColumnReader {
public:
    ColumnReader(const Table& table, std::size_t column) : table_(table), column_(column) {}

    [[nodiscard]] std::string number_or_throw(std::size_t row) {
        const std::string& cell = table_.rows[row][column_];
        if (is_ambiguous_comma(cell) && !commas_are_decimal())
            throw Error(ExitCode::bad_input, cell_location(table_, row, column_),
                        core::quoted(cell) + " has a decimal comma or a thousands separator",
                        "write it without the comma");
        if (auto number = decimal_text(cell, table_.decimal)) return *number;
        throw Error(ExitCode::bad_input, cell_location(table_, row, column_),
                    core::trimmed(cell).empty() ? "the cell is empty" : core::quoted(cell) + " is not a number",
                    "put # before lines that are not data");
    }

private:
    [[nodiscard]] bool commas_are_decimal() {
        if (table_.decimal == Decimal::comma) return true;
        if (!decimal_) decimal_ = table_.delimiter != ',' && !has_decimal_points(table_);
        return *decimal_;
    }

    const Table& table_;
    std::size_t column_;
    std::optional<bool> decimal_ = {};  // determined on first use
};

}  // namespace

std::optional<std::string> decimal_text(const std::string& cell, Decimal decimal) {
    std::string text{core::trimmed(cell)};
    if (text.starts_with('+')) text.erase(0, 1);
    const bool has_point = text.find('.') != std::string::npos;
    if (decimal == Decimal::comma && has_point) return std::nullopt;
    if (decimal != Decimal::point && !has_point && std::count(text.begin(), text.end(), ',') == 1)
        std::replace(text.begin(), text.end(), ',', '.');
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return text;
}

Heading parse_heading(std::string_view name) {
    name = core::trimmed(name);
    Heading heading{std::string{name}, std::string{name}, {}};
    if (const std::size_t open = name.find_last_of("(["); open != std::string_view::npos && open > 0) {
        const std::string_view unit = without_brackets(name.substr(open));
        if (unit.size() < name.size() - open) {  // the closing bracket is the last character
            heading.quantity = core::trimmed(name.substr(0, open));
            if (dimension_of(unit)) heading.unit = unit;
            return heading;
        }
    }
    if (constexpr std::string_view per_metre = "_per_m"; name.size() > per_metre.size() && name.ends_with(per_metre))
        return {std::string{name}, std::string{name.substr(0, name.size() - per_metre.size())}, "1/m"};
    for (const std::string_view separator : {"_", "/", " in ", ",", " "}) {
        const std::size_t at = name.rfind(separator);
        if (at == std::string_view::npos || at == 0) continue;
        const std::string_view unit = core::trimmed(name.substr(at + separator.size()));
        if (!dimension_of(unit)) continue;
        heading.quantity = core::trimmed(name.substr(0, at));
        heading.unit = unit;
        return heading;
    }
    return heading;
}

std::string column_text(const Table& table, std::size_t column) {
    const std::string number = "column " + std::to_string(column + 1);
    return table.headings.empty() ? number : number + " " + core::quoted(table.headings[column].name);
}

std::vector<double> numbers(const Table& table, std::size_t column) {
    std::vector<double> values;
    ColumnReader reader(table, column);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const std::string text = reader.number_or_throw(row);
        values.emplace_back();
        std::from_chars(text.data(), text.data() + text.size(), values.back());
    }
    return values;
}

std::vector<double> values_SI(const Table& table, std::size_t column, std::string_view unit,
                              core::Dimension dimension) {
    std::vector<double> values;
    ColumnReader reader(table, column);
    for (std::size_t row = 0; row < table.rows.size(); ++row)
        values.push_back(core::quantity_or_throw(reader.number_or_throw(row) + " " + std::string{unit}, dimension,
                                                 ExitCode::bad_input, cell_location(table, row, column)));
    return values;
}

}  // namespace soft::core
