#include "fit/columns.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"

namespace soft::fit {
namespace {

using core::Table;

std::string lower(std::string_view text) {
    std::string small{text};
    for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return small;
}

bool contains(std::string_view title, std::string_view word) { return lower(title).find(word) != std::string::npos; }

bool is_true_measure(std::string_view title) {
    return contains(title, "true") || contains(title, "cauchy") || contains(title, "log") || contains(title, "hencky");
}
bool is_engineering(std::string_view title) {
    return contains(title, "eng") || contains(title, "nominal") || contains(title, "piola");
}
bool is_strain(std::string_view title) { return contains(title, "strain") || contains(title, "stretch"); }
bool is_stress(std::string_view title) { return contains(title, "stress"); }

bool is_no_title(std::string_view) { return false; }
bool is_time(std::string_view title) { return contains(title, "time") || contains(title, "zeit"); }

bool contains_any(std::string_view title, std::initializer_list<std::string_view> words) {
    return std::ranges::any_of(words, [&](std::string_view word) { return contains(title, word); });
}
bool is_displacement(std::string_view title) {
    return !is_strain(title) &&
           contains_any(title, {"disp", "extension", "elongation", "crosshead", "travel", "stroke", "position", "weg"});
}
bool is_force(std::string_view title) { return !is_stress(title) && contains_any(title, {"force", "load", "kraft"}); }

std::string location_of(const Table& table) {
    return table.source + ":" + std::to_string(table.headings.empty() ? table.lines.front() : table.header_line);
}

Error refusal(const Table& table, const std::string& problem, const std::string& remedy) {
    return {ExitCode::bad_input, location_of(table), problem, remedy};
}

std::vector<std::string> quoted_titles(const Table& table) {
    std::vector<std::string> titles;
    for (const core::Heading& heading : table.headings)
        if (!heading.name.empty()) titles.push_back(core::quoted(heading.name));
    return titles;
}

std::string titles_text(const Table& table) {
    constexpr std::size_t max_length = 400;  // a file may have any number of columns
    return core::one_line(core::join(quoted_titles(table)), max_length);
}

struct ColumnQuery {
    std::string_view what;     // "strain"
    std::string_view option;   // "--strain-column"
    std::string_view request;  // the option's argument
    bool (*fits)(std::string_view);
    bool (*fits_machine)(std::string_view);  // titles that testing machines write instead
    std::string_view machine_remedy;
};
constexpr std::string_view gauge_length_remedy = "for a displacement give --gauge-length",
                           area_remedy = "for a force give --area, or --width and --thickness";

/// Finds a column by its number, its exact title or a part of its title.
std::size_t named_column(const Table& table, const ColumnQuery& query) {
    const std::size_t width = table.width();
    std::size_t number = 0;
    const std::string_view text = query.request;
    const auto [stop, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure == std::errc{} && stop == text.data() + text.size()) {
        if (number >= 1 && number <= width) return number - 1;
        throw refusal(table, "there is no column " + std::string{text},
                      "the table has " + std::to_string(width) + " columns, numbered from 1");
    }
    std::vector<std::size_t> hits;
    for (std::size_t i = 0; i < table.headings.size(); ++i) {
        if (lower(table.headings[i].name) == lower(text)) return i;
        if (contains(table.headings[i].name, lower(text))) hits.push_back(i);
    }
    if (hits.size() == 1) return hits.front();
    const std::string titles = titles_text(table);
    throw refusal(
        table, (hits.empty() ? "no column is called " : "more than one column is called ") + core::quoted(text),
        table.headings.empty() ? "the table has no header: name the column by its number" : "columns: " + titles);
}

std::size_t column_by_title(const Table& table, const ColumnQuery& query) {
    std::vector<std::size_t> hits, engineering;
    for (std::size_t i = 0; i < table.headings.size(); ++i)
        if (query.fits(table.headings[i].name)) {
            hits.push_back(i);
            if (is_engineering(table.headings[i].name)) engineering.push_back(i);
        }
    if (hits.size() == 1) return hits.front();
    if (engineering.size() == 1) return engineering.front();
    const std::string what{query.what}, remedy = "name one with " + std::string{query.option} + " TITLE or NUMBER";
    if (table.headings.empty())
        throw refusal(table, "the table has no header to identify the " + what + " column", remedy);
    const bool has_machine_column = std::ranges::any_of(
        table.headings, [&](const core::Heading& heading) { return query.fits_machine(heading.name); });
    throw refusal(table,
                  hits.empty() ? "no title identifies the " + what + " column" : "several columns may be the " + what,
                  remedy + "; columns: " + titles_text(table) +
                      (hits.empty() && has_machine_column ? "; " + std::string{query.machine_remedy} : ""));
}

std::size_t find_column(const Table& table, const ColumnQuery& query) {
    return query.request.empty() ? column_by_title(table, query) : named_column(table, query);
}

/// Measures and units that neither the file nor an option states; reported in one message.
struct MissingMetadata {
    std::vector<std::string> problems, remedies;

    void add(std::string problem, std::string remedy) {
        problems.push_back(std::move(problem));
        remedies.push_back(std::move(remedy));
    }
};

/// The text in brackets at the end of a title: "furlong" of "Stress (furlong)".
std::string_view in_brackets(std::string_view title) {
    const std::string_view text = core::trimmed(title);
    if (text.empty() || (text.back() != ')' && text.back() != ']')) return {};
    const std::size_t open = text.find_last_of("([");
    return open == std::string_view::npos ? std::string_view{} : text.substr(open + 1, text.size() - open - 2);
}

/// A quantity whose unit must be stated.
struct Measured {
    core::Dimension dimension;
    std::string_view what;      // "stress"
    std::string_view option;    // "--stress-unit"
    std::string_view examples;  // "MPa (or Pa, kPa, N/mm^2, psi)"
};
constexpr Measured stress_quantity{core::Dimension::pressure, "stress", "--stress-unit",
                                   "MPa (or Pa, kPa, N/mm^2, psi)"};
constexpr Measured force_quantity{core::Dimension::force, "force", "--stress-unit", "N (or mN, kN, lbf, kgf)"};
constexpr Measured displacement_quantity{core::Dimension::length, "displacement", "--strain-unit", "mm (or m, in)"};

std::string stated_unit(const Measured& measured, const std::string& option_value, const core::Heading& heading,
                        MissingMetadata& missing) {
    const std::string option{measured.option}, what{measured.what}, examples{measured.examples};
    const auto fits = [&](std::string_view unit) { return core::dimension_of(unit) == measured.dimension; };
    if (!option_value.empty() && !fits(option_value))
        throw Error(ExitCode::usage, option, core::quoted(option_value) + " is not a unit of " + what,
                    "use " + examples);
    if (fits(heading.unit)) return heading.unit;
    if (!option_value.empty()) return option_value;
    const std::string_view unknown = in_brackets(heading.name);
    missing.add(unknown.empty() ? "the unit of the " + what + " is not stated"
                                : core::quoted(unknown) + " is not a known unit of " + what,
                option + " " + examples);
    return {};
}

std::string strain_unit(std::string_view in_header, const ReadSettings& settings) {
    if (!settings.strain_unit.empty() && settings.strain_unit != "%" && settings.strain_unit != "1")
        throw Error(ExitCode::usage, "--strain-unit", core::quoted(settings.strain_unit) + " is not a unit of strain",
                    "use 1 or %");
    const std::string_view unit = in_header.empty() ? settings.strain_unit : in_header;
    return unit == "%" ? "%" : "";  // strain is a plain ratio unless stated otherwise
}

StrainMeasure strain_measure(std::string_view title, const ReadSettings& settings, MissingMetadata& missing) {
    if (contains(title, "stretch")) return StrainMeasure::stretch;
    if (is_true_measure(title)) return StrainMeasure::logarithmic;
    if (is_engineering(title)) return StrainMeasure::engineering;
    if (settings.strain_measure) return *settings.strain_measure;
    missing.add("the title does not state whether the strain is engineering, true, or a stretch",
                "--strain engineering, true or stretch");
    return {};
}

StressMeasure stress_measure(std::string_view title, const ReadSettings& settings, MissingMetadata& missing) {
    if (is_true_measure(title)) return StressMeasure::cauchy;
    if (is_engineering(title)) return StressMeasure::engineering;
    if (settings.stress_measure) return *settings.stress_measure;
    missing.add("the title does not state whether the stress is engineering or true", "--stress engineering or true");
    return {};
}

}  // namespace

Columns columns_of(const Table& table, const ReadSettings& settings) {
    Columns columns;
    const bool is_machine_strain = settings.specimen.gauge_length_m.has_value(),
               is_machine_stress = settings.specimen.area_m2.has_value();
    columns.strain =
        find_column(table, {is_machine_strain ? "displacement" : "strain", "--strain-column", settings.strain_column,
                            is_machine_strain ? is_displacement : is_strain, is_displacement, gauge_length_remedy});
    columns.stress =
        find_column(table, {is_machine_stress ? "force" : "stress", "--stress-column", settings.stress_column,
                            is_machine_stress ? is_force : is_stress, is_force, area_remedy});
    if (columns.strain == columns.stress)
        throw refusal(table, "strain and stress are the same column",
                      "name two with --strain-column and --stress-column");
    const auto heading = [&](std::size_t column) {
        return column < table.headings.size() ? table.headings[column] : core::Heading{};
    };
    const core::Heading strain = heading(columns.strain), stress = heading(columns.stress);
    MissingMetadata missing;
    if (!is_machine_strain) columns.strain_measure = strain_measure(strain.name, settings, missing);
    if (!is_machine_stress) columns.stress_measure = stress_measure(stress.name, settings, missing);
    columns.strain_unit = is_machine_strain ? stated_unit(displacement_quantity, settings.strain_unit, strain, missing)
                                            : strain_unit(strain.unit, settings);
    columns.stress_unit =
        stated_unit(is_machine_stress ? force_quantity : stress_quantity, settings.stress_unit, stress, missing);
    if (settings.wants_time) {
        columns.time = find_column(table, {"time", "--time-column", settings.time_column, is_time, is_no_title, {}});
        const std::string in_title = heading(columns.time).unit,
                          stated = in_title.empty() ? settings.time_unit : in_title;
        if (!stated.empty() && core::dimension_of(stated) == core::Dimension::time)
            columns.time_unit = stated;
        else if (!settings.time_unit.empty())
            throw Error(ExitCode::usage, "--time-unit", core::quoted(stated) + " is not a unit of time",
                        "use s, ms or min");
    }
    if (!missing.problems.empty())
        throw refusal(table, core::join(missing.problems), "give " + core::join(missing.remedies, " and "));
    return columns;
}

}  // namespace soft::fit
