#include "fit/columns.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>

#include "core/text.hpp"
#include "core/units.hpp"

namespace soft::fit {
namespace {

std::string lower(std::string_view text) {
    std::string small{text};
    for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return small;
}

bool holds(std::string_view title, std::string_view word) { return lower(title).find(word) != std::string::npos; }

bool is_true_measure(std::string_view title) {
    return holds(title, "true") || holds(title, "cauchy") || holds(title, "log") || holds(title, "hencky");
}
bool is_engineering(std::string_view title) {
    return holds(title, "eng") || holds(title, "nominal") || holds(title, "piola");
}
bool is_strain(std::string_view title) { return holds(title, "strain") || holds(title, "stretch"); }
bool is_stress(std::string_view title) { return holds(title, "stress"); }

std::string place_of(const Table& table) {
    return table.source + ":" + std::to_string(table.header.empty() ? table.rows.front().line : table.header_line);
}

Error refusal(const Table& table, const std::string& problem, const std::string& remedy) {
    return {ExitCode::bad_input, place_of(table), problem, remedy};
}

std::vector<std::string> quoted_titles(const Table& table) {
    std::vector<std::string> titles;
    for (const std::string& title : table.header)
        if (!title.empty()) titles.push_back(core::quoted(title));
    return titles;
}

struct Wanted {
    std::string_view what;     // "strain"
    std::string_view option;   // "--strain-column"
    std::string_view request;  // what the user said
    bool (*fits)(std::string_view);
};

/// By number, exact title, part of a title.
std::size_t named_column(const Table& table, const Wanted& wanted) {
    const std::size_t width = std::max(table.header.size(), table.rows.front().fields.size());
    std::size_t number = 0;
    const std::string_view text = wanted.request;
    const auto [stop, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure == std::errc{} && stop == text.data() + text.size()) {
        if (number >= 1 && number <= width) return number - 1;
        throw refusal(table, "there is no column " + std::string{text},
                      "the table has " + std::to_string(width) + " columns, numbered from 1");
    }
    std::vector<std::size_t> hits;
    for (std::size_t i = 0; i < table.header.size(); ++i) {
        if (lower(table.header[i]) == lower(text)) return i;
        if (holds(table.header[i], lower(text))) hits.push_back(i);
    }
    if (hits.size() == 1) return hits.front();
    const std::string titles = core::join(quoted_titles(table));
    throw refusal(
        table, (hits.empty() ? "no column is called " : "more than one column is called ") + core::quoted(text),
        table.header.empty() ? "the table has no header: name the column by its number" : "columns: " + titles);
}

std::size_t column_by_title(const Table& table, const Wanted& wanted) {
    std::vector<std::size_t> hits, engineering;
    for (std::size_t i = 0; i < table.header.size(); ++i)
        if (wanted.fits(table.header[i])) {
            hits.push_back(i);
            if (is_engineering(table.header[i])) engineering.push_back(i);
        }
    if (hits.size() == 1) return hits.front();
    if (engineering.size() == 1) return engineering.front();
    const std::string what{wanted.what}, remedy = "name one with " + std::string{wanted.option} + " TITLE or NUMBER";
    if (table.header.empty())
        throw refusal(table, "the table has no header that says which column is the " + what, remedy);
    throw refusal(table,
                  hits.empty() ? "no title says which column is the " + what : "several columns may be the " + what,
                  remedy + "; columns: " + core::join(quoted_titles(table)));
}

std::size_t find_column(const Table& table, const Wanted& wanted) {
    return wanted.request.empty() ? column_by_title(table, wanted) : named_column(table, wanted);
}

/// What stands in brackets at the end of a title, or behind its last _ or /; empty where there is no such thing.
std::string unit_in(std::string_view title) {
    const std::string_view text = core::trimmed(title);
    for (const auto& [open, close] : {std::pair{'(', ')'}, {'[', ']'}}) {
        const auto begin = text.rfind(open);
        if (begin != std::string_view::npos && text.ends_with(close))
            return std::string{core::trimmed(text.substr(begin + 1, text.size() - begin - 2))};
    }
    const auto mark = text.find_last_of("_/");
    return mark == std::string_view::npos ? std::string{} : std::string{core::trimmed(text.substr(mark + 1))};
}

std::optional<double> pressure_of(std::string_view unit) {
    const auto parsed = core::parse_quantity("1 " + std::string{unit}, core::Dimension::pressure);
    const double* value = std::get_if<double>(&parsed);
    return value == nullptr || unit.empty() ? std::nullopt : std::optional{*value};
}

double stress_unit(const Table& table, std::string_view title, const ReadSettings& settings) {
    const std::string unit = settings.stress_unit.empty() ? unit_in(title) : settings.stress_unit;
    if (const auto value = pressure_of(unit)) return *value;
    if (!settings.stress_unit.empty())
        throw Error(ExitCode::usage, "--stress-unit", core::quoted(unit) + " is no unit of stress",
                    "Pa, kPa, MPa, N/mm^2, psi, ...");
    throw refusal(table, "the unit of the stress is nowhere stated",
                  "give --stress-unit MPa (or Pa, kPa, N/mm^2, psi)");
}

double strain_unit(std::string_view title, const ReadSettings& settings) {
    const std::string unit = settings.strain_unit.empty() ? unit_in(title) : settings.strain_unit;
    if (unit == "%") return 0.01;
    if (settings.strain_unit.empty() || unit == "1") return 1.0;  // strain is a plain ratio unless it says otherwise
    throw Error(ExitCode::usage, "--strain-unit", core::quoted(unit) + " is no unit of strain", "1 or %");
}

StrainMeasure strain_measure(const Table& table, std::string_view title, const ReadSettings& settings) {
    if (settings.strain_measure) return *settings.strain_measure;
    if (holds(title, "stretch")) return StrainMeasure::stretch;
    if (is_true_measure(title)) return StrainMeasure::logarithmic;
    if (is_engineering(title)) return StrainMeasure::engineering;
    throw refusal(table, "the title does not say whether the strain is engineering, true, or a stretch",
                  "give --strain engineering, true or stretch");
}

StressMeasure stress_measure(const Table& table, std::string_view title, const ReadSettings& settings) {
    if (settings.stress_measure) return *settings.stress_measure;
    if (is_true_measure(title)) return StressMeasure::cauchy;
    if (is_engineering(title)) return StressMeasure::engineering;
    throw refusal(table, "the title does not say whether the stress is engineering or true",
                  "give --stress engineering or true");
}

}  // namespace

Columns columns_of(const Table& table, const ReadSettings& settings) {
    Columns columns;
    columns.strain = find_column(table, {"strain", "--strain-column", settings.strain_column, is_strain});
    columns.stress = find_column(table, {"stress", "--stress-column", settings.stress_column, is_stress});
    if (columns.strain == columns.stress)
        throw refusal(table, "strain and stress are the same column",
                      "name two with --strain-column and --stress-column");
    const auto title = [&](std::size_t column) {
        return column < table.header.size() ? std::string_view{table.header[column]} : std::string_view{};
    };
    columns.strain_measure = strain_measure(table, title(columns.strain), settings);
    columns.stress_measure = stress_measure(table, title(columns.stress), settings);
    columns.strain_factor = strain_unit(title(columns.strain), settings);
    columns.stress_Pa = stress_unit(table, title(columns.stress), settings);
    return columns;
}

}  // namespace soft::fit
