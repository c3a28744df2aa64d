#include "core/units.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "core/text.hpp"
#include "core/unit_names.hpp"

namespace soft::core {
namespace {

/// 1 unit = factor x 10^power SI. Decimal prefixes use only the power, which is added to the exponent of the text.
struct Unit {
    std::string_view name;
    int power = 0;
    double factor = 1.0;
};
struct DimensionInfo {
    std::string_view name, example;
    std::vector<Unit> units;
};

constexpr double pound_force_N = 4.4482216152605, psi_Pa = 6894.757293168361;  // by definition of pound, g_n and inch
/// Standard gravity, and the pressure of a mercury column per metre (conventional values, ISO 80000-4).
constexpr double g_n = 9.80665, mercury_Pa_m = 13595.1 * g_n;
/// Name, example and units of each dimension, in the order of the enumeration.
const std::vector<DimensionInfo>& dimensions() {
    static const std::vector<DimensionInfo> list = {
        {"ratio", "1.5", {{"%", -2}}},
        {"length",
         "3 mm",
         {{"m"},
          {"cm", -2},
          {"mm", -3},
          {"um", -6},
          {"\u00B5m", -6},
          {"\u03BCm", -6},
          {"in", -4, 254.0},
          {"inch", -4, 254.0},
          {"ft", -4, 3048.0}}},
        {"area", "20 mm^2", {{"m^2"}, {"cm^2", -4}, {"mm^2", -6}, {"in^2", -8, 254.0 * 254.0}}},
        {"volume",
         "10 mL",
         {{"m^3"},
          {"cm^3", -6},
          {"mm^3", -9},
          {"in^3", -12, 254.0 * 254.0 * 254.0},
          {"L", -3},
          {"l", -3},
          {"mL", -6},
          {"ml", -6},
          {"uL", -9}}},
        {"pressure",
         "30 kPa",
         {{"Pa"},
          {"hPa", 2},
          {"kPa", 3},
          {"MPa", 6},
          {"GPa", 9},
          {"N/m^2"},
          {"N/mm^2", 6},
          {"kN/m^2", 3},
          {"mbar", 2},
          {"bar", 5},
          {"atm", 0, 101325.0},
          {"psi", 0, psi_Pa},
          {"ksi", 3, psi_Pa},
          {"mmHg", -3, mercury_Pa_m},
          {"inHg", -4, 254.0 * mercury_Pa_m},
          {"Torr", 0, 101325.0 / 760.0},
          {"kgf/cm^2", 4, g_n},
          {"kgf/mm^2", 6, g_n}}},
        {"angle", "30 deg", {{"rad"}, {"deg", 0, std::numbers::pi / 180.0}, {"\u00B0", 0, std::numbers::pi / 180.0}}},
        {"density", "1080 kg/m^3", {{"kg/m^3"}, {"g/cm^3", 3}, {"g/mL", 3}}},
        {"mass", "50 mg", {{"kg"}, {"g", -3}, {"mg", -6}, {"ug", -9}}},
        {"acceleration", "9.81 m/s^2", {{"m/s^2"}, {"cm/s^2", -2}, {"mm/s^2", -3}}},
        {"time", "0.5 s", {{"s"}, {"ms", -3}, {"us", -6}, {"\u00B5s", -6}, {"\u03BCs", -6}, {"min", 0, 60.0}}},
        {"rate", "10 Hz", {{"1/s"}, {"1/ms", 3}, {"Hz"}, {"kHz", 3}}},
        {"flow resistance",
         "1e8 Pa.s/m^3",
         {{"Pa.s/m^3"},
          {"kPa.s/m^3", 3},
          {"MPa.s/m^3", 6},
          {"Pa.s/L", 3},
          {"kPa.s/L", 6},
          {"Pa.s/mL", 6},
          {"kPa.s/mL", 9},
          {"mbar.s/mL", 8}}},
        {"energy", "5 mJ", {{"J"}, {"mJ", -3}, {"uJ", -6}}},
        {"force", "2 N", {{"N"}, {"mN", -3}, {"kN", 3}, {"lbf", 0, pound_force_N}, {"kgf", 0, g_n}, {"gf", -3, g_n}}},
        {"moment", "5 N.mm", {{"N.m"}, {"Nm"}, {"N.mm", -3}, {"Nmm", -3}, {"mN.m", -3}}},
        {"curvature", "10 1/m", {{"1/m"}, {"1/cm", 2}, {"1/mm", 3}}},
    };
    return list;
}

/// Units for messages, from large to small within a dimension: the first one that gives a number of at least 1 is used.
constexpr auto message_units = std::to_array<std::string_view>(
    {"m",      "mm",       "um", "m^2", "mm^2", "m^3",   "mL", "mm^3", "GPa",  "MPa", "kPa",      "Pa",
     "deg",    "kg/m^3",   "kg", "g",   "mg",   "m/s^2", "s",  "ms",   "us",   "1/s", "kPa.s/mL", "Pa.s/mL",
     "Pa.s/L", "Pa.s/m^3", "J",  "mJ",  "uJ",   "N",     "mN", "N.m",  "N.mm", "1/m"});

constexpr std::size_t max_number_length = 40;  // in a message

/// The parts of "-12.5e3 mm"; `number` is empty if the text does not start with a decimal number.
struct Parts {
    std::string_view number, mantissa, exponent, unit;
};

std::size_t digits_from(std::string_view text, std::size_t at) noexcept {
    while (at < text.size() && text[at] >= '0' && text[at] <= '9') ++at;
    return at;
}

Parts parts_of(std::string_view text) noexcept {
    text = trimmed(text);
    const bool plus = text.starts_with('+');  // from_chars takes no plus sign
    if (plus) text.remove_prefix(1);
    const std::size_t sign = !plus && text.starts_with('-') ? 1 : 0;
    const std::size_t whole = digits_from(text, sign);
    std::size_t end = whole;
    if (end < text.size() && text[end] == '.') end = digits_from(text, end + 1);
    const std::size_t digits = end - sign - (end > whole ? 1 : 0);
    if (digits == 0) return {{}, {}, {}, text};
    Parts parts;
    parts.mantissa = text.substr(0, end);
    if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
        const std::size_t first =
            end + 1 < text.size() && (text[end + 1] == '+' || text[end + 1] == '-') ? end + 2 : end + 1;
        if (const std::size_t last = digits_from(text, first); last > first) {
            parts.exponent = text.substr(end + 1, last - end - 1);
            end = last;
        }
    }
    parts.number = text.substr(0, end);
    parts.unit = trimmed(text.substr(end));
    return parts;
}

/// Value of mantissa x 10^(exponent + power), correctly rounded; nullopt outside the range of a double.
std::optional<double> value_of(const Parts& parts, int power) {
    int exponent = 0;
    std::string_view digits = parts.exponent;
    if (digits.starts_with('+')) digits.remove_prefix(1);
    if (!digits.empty()) {
        if (std::from_chars(digits.data(), digits.data() + digits.size(), exponent).ec != std::errc{})
            return std::nullopt;
    }
    constexpr int beyond_double = 5000;
    if (std::abs(exponent) > beyond_double) return std::nullopt;
    const std::string shifted = std::string{parts.mantissa} + "e" + std::to_string(exponent + power);
    double value = 0;
    const auto result = std::from_chars(shifted.data(), shifted.data() + shifted.size(), value);
    if (result.ec != std::errc{} || result.ptr != shifted.data() + shifted.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::string with_article(std::string_view noun) {
    return (std::string_view{"aeiou"}.find(noun.front()) == std::string_view::npos ? "a " : "an ") + std::string{noun};
}

const DimensionInfo& info_of(Dimension dimension) noexcept { return dimensions()[static_cast<std::size_t>(dimension)]; }

struct FoundUnit {
    const Unit* unit = nullptr;  ///< nullptr: there is no such unit
    Dimension dimension{};
};
FoundUnit find_unit(std::string_view name) noexcept {
    for (std::size_t d = 0; d < dimensions().size(); ++d)
        for (const Unit& unit : dimensions()[d].units)
            if (unit.name == name) return {&unit, static_cast<Dimension>(d)};
    return {};
}

/// "N/mm^2" for "N/mm\u00B2" and for "N/mm2", as testing machines write it.
std::string with_plain_power(std::string_view unit) {
    std::string plain{unit};
    for (const auto& [raised, power] : {std::pair{"\u00B2", "^2"}, std::pair{"\u00B3", "^3"}})
        if (const std::size_t at = plain.find(raised); at != std::string::npos)
            plain.replace(at, std::string_view{raised}.size(), power);
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    if (plain.size() > 1 && (plain.back() == '2' || plain.back() == '3') && is_letter(plain[plain.size() - 2]))
        plain.insert(plain.size() - 1, "^");
    return plain;
}

std::string advice(Dimension dimension) {
    if (dimension == Dimension::ratio) return "write a bare number, for example 1.5";
    return "write for example " + std::string{example(dimension)} + " (units: " + join(unit_names(dimension)) + ")";
}

Refusal not_a_number(std::string_view text, Dimension dimension) {
    const std::string_view value = trimmed(text);
    if (value.empty()) return {"the value is empty", advice(dimension)};
    return {quoted(value) + " is not a number" + (dimension == Dimension::ratio ? "" : " with a unit"),
            advice(dimension)};
}

bool equal_ignoring_case(std::string_view one, std::string_view other) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return std::ranges::equal(one, other, {}, lower, lower);
}

Refusal unknown_unit(const Parts& parts, Dimension dimension) {
    const std::string problem = "unknown unit " + quoted(parts.unit) + " in " + with_article(name(dimension));
    const std::string number = one_line(parts.number, max_number_length);
    if (parts.unit.starts_with(','))
        return {"a comma is not a decimal point", "write " + number + "." + one_line(parts.unit.substr(1))};
    // Only differences in case are suggested: a similar name may be a unit 1000 times as large, such as 'ksi' for 'psi'.
    const auto names = unit_names(dimension);
    const auto same =
        std::ranges::find_if(names, [&](const std::string& name) { return equal_ignoring_case(name, parts.unit); });
    if (same != names.end() && std::ranges::count_if(names, [&](const std::string& name) {
                                   return equal_ignoring_case(name, parts.unit);
                               }) == 1)
        return {problem, "did you mean " + number + " " + *same + "?"};
    return {problem, advice(dimension)};
}

}  // namespace

std::vector<std::string> unit_names(std::optional<Dimension> dimension) {
    std::vector<std::string> names;
    for (std::size_t d = 0; d < dimensions().size(); ++d)
        for (const Unit& unit : dimensions()[d].units) {
            const bool ascii = unit.name.find_first_of("\xC2\xCE") == std::string_view::npos;
            if (ascii && (!dimension || d == static_cast<std::size_t>(*dimension))) names.emplace_back(unit.name);
        }
    return names;
}

std::string_view name(Dimension dimension) noexcept { return info_of(dimension).name; }
std::string_view example(Dimension dimension) noexcept { return info_of(dimension).example; }

std::optional<Dimension> dimension_of(std::string_view unit) {
    const FoundUnit found = find_unit(with_plain_power(trimmed(unit)));
    return found.unit == nullptr ? std::nullopt : std::optional{found.dimension};
}

Parsed<double> parse_quantity(std::string_view text, Dimension dimension) {
    const Parts parts = parts_of(text);
    if (parts.number.empty()) return not_a_number(text, dimension);
    const std::string shown = quoted(trimmed(text));
    if (parts.unit.empty() && dimension != Dimension::ratio) {
        const std::string_view unit = parts_of(example(dimension)).unit;
        return Refusal{shown + " has no unit, " + with_article(name(dimension)) + " is needed",
                       "write for example " + one_line(parts.number, max_number_length) + " " + std::string{unit}};
    }
    const auto [unit, stated] = find_unit(with_plain_power(parts.unit));
    if (!parts.unit.empty() && unit == nullptr) return unknown_unit(parts, dimension);
    if (unit != nullptr && stated != dimension)
        return Refusal{
            shown + " is " + with_article(name(stated)) + " where " + with_article(name(dimension)) + " is needed",
            advice(dimension)};
    const auto decimal = value_of(parts, unit == nullptr ? 0 : unit->power);
    const double value = decimal.value_or(0.0) * (unit == nullptr ? 1.0 : unit->factor);
    if (!decimal || !std::isfinite(value))
        return Refusal{shown + " is out of the range of floating-point numbers", advice(dimension)};
    return value;
}

Parsed<long> parse_count(std::string_view text) {
    const std::string_view digits = trimmed(text);
    long value = 0;
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (digits.empty() || result.ec == std::errc::invalid_argument || result.ptr != digits.data() + digits.size())
        return Refusal{quoted(digits) + " is not a whole number", "write for example 10"};
    if (result.ec != std::errc{}) return Refusal{quoted(digits) + " is out of range", "write for example 10"};
    return value;
}

double quantity_or_throw(std::string_view text, Dimension dimension, ExitCode code, std::string_view location) {
    const Parsed<double> parsed = parse_quantity(text, dimension);
    if (const Refusal* refusal = std::get_if<Refusal>(&parsed))
        throw Error(code, location, refusal->problem, refusal->remedy);
    return std::get<double>(parsed);
}

std::string tidy_quantity(std::string_view text) {
    const Parts parts = parts_of(text);
    if (parts.number.empty()) return std::string{trimmed(text)};
    std::string tidy{parts.number};
    if (!parts.unit.empty()) tidy.append(" ").append(parts.unit);
    return tidy;
}

QuantityParts quantity_parts(std::string_view text) {
    const std::string tidy = tidy_quantity(text);
    const std::size_t blank = std::min(tidy.find(' '), tidy.size());
    return {tidy.substr(0, blank), tidy.substr(std::min(blank + 1, tidy.size()))};
}

std::string quantity_text(double si, Dimension dimension) {
    constexpr int digits = 6;
    if (dimension == Dimension::ratio) return rounded_text(si, digits);
    const Unit* chosen = nullptr;
    double value = 0;
    for (const std::string_view candidate : message_units) {
        const auto [unit, other] = find_unit(candidate);
        if (other != dimension) continue;
        chosen = unit;
        value = si / (unit->factor * std::pow(10.0, unit->power));
        if (std::abs(value) >= 1.0 || (si == 0 && unit->power == 0)) break;
    }
    return rounded_text(value, digits) + " " + std::string{chosen->name};
}

}  // namespace soft::core
