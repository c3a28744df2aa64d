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
    Dimension dimension;
    int power = 0;
    double factor = 1.0;
};

constexpr double pound_force_N = 4.4482216152605, psi_Pa = 6894.757293168361;  // by definition of pound, g_n and inch
/// Standard gravity, and the pressure of a mercury column per metre (conventional values, ISO 80000-4).
constexpr double g_n = 9.80665, mercury_Pa_m = 13595.1 * g_n;
constexpr std::array units = {
    Unit{"%", Dimension::ratio, -2},
    Unit{"m", Dimension::length},
    Unit{"cm", Dimension::length, -2},
    Unit{"mm", Dimension::length, -3},
    Unit{"um", Dimension::length, -6},
    Unit{"\u00B5m", Dimension::length, -6},
    Unit{"\u03BCm", Dimension::length, -6},
    Unit{"in", Dimension::length, -4, 254.0},
    Unit{"inch", Dimension::length, -4, 254.0},
    Unit{"ft", Dimension::length, -4, 3048.0},
    Unit{"m^2", Dimension::area},
    Unit{"cm^2", Dimension::area, -4},
    Unit{"mm^2", Dimension::area, -6},
    Unit{"in^2", Dimension::area, -8, 254.0 * 254.0},
    Unit{"m^3", Dimension::volume},
    Unit{"cm^3", Dimension::volume, -6},
    Unit{"mm^3", Dimension::volume, -9},
    Unit{"in^3", Dimension::volume, -12, 254.0 * 254.0 * 254.0},
    Unit{"L", Dimension::volume, -3},
    Unit{"l", Dimension::volume, -3},
    Unit{"mL", Dimension::volume, -6},
    Unit{"ml", Dimension::volume, -6},
    Unit{"uL", Dimension::volume, -9},
    Unit{"Pa", Dimension::pressure},
    Unit{"hPa", Dimension::pressure, 2},
    Unit{"kPa", Dimension::pressure, 3},
    Unit{"MPa", Dimension::pressure, 6},
    Unit{"GPa", Dimension::pressure, 9},
    Unit{"N/m^2", Dimension::pressure},
    Unit{"N/mm^2", Dimension::pressure, 6},
    Unit{"kN/m^2", Dimension::pressure, 3},
    Unit{"mbar", Dimension::pressure, 2},
    Unit{"bar", Dimension::pressure, 5},
    Unit{"atm", Dimension::pressure, 0, 101325.0},
    Unit{"psi", Dimension::pressure, 0, psi_Pa},
    Unit{"ksi", Dimension::pressure, 3, psi_Pa},
    Unit{"mmHg", Dimension::pressure, -3, mercury_Pa_m},
    Unit{"inHg", Dimension::pressure, -4, 254.0 * mercury_Pa_m},
    Unit{"Torr", Dimension::pressure, 0, 101325.0 / 760.0},
    Unit{"kgf/cm^2", Dimension::pressure, 4, g_n},
    Unit{"kgf/mm^2", Dimension::pressure, 6, g_n},
    Unit{"rad", Dimension::angle},
    Unit{"deg", Dimension::angle, 0, std::numbers::pi / 180.0},
    Unit{"\u00B0", Dimension::angle, 0, std::numbers::pi / 180.0},
    Unit{"kg/m^3", Dimension::density},
    Unit{"g/cm^3", Dimension::density, 3},
    Unit{"g/mL", Dimension::density, 3},
    Unit{"kg", Dimension::mass},
    Unit{"g", Dimension::mass, -3},
    Unit{"mg", Dimension::mass, -6},
    Unit{"ug", Dimension::mass, -9},
    Unit{"m/s^2", Dimension::acceleration},
    Unit{"cm/s^2", Dimension::acceleration, -2},
    Unit{"mm/s^2", Dimension::acceleration, -3},
    Unit{"s", Dimension::time},
    Unit{"ms", Dimension::time, -3},
    Unit{"us", Dimension::time, -6},
    Unit{"\u00B5s", Dimension::time, -6},
    Unit{"\u03BCs", Dimension::time, -6},
    Unit{"min", Dimension::time, 0, 60.0},
    Unit{"1/s", Dimension::rate},
    Unit{"1/ms", Dimension::rate, 3},
    Unit{"Hz", Dimension::rate},
    Unit{"kHz", Dimension::rate, 3},
    Unit{"Pa.s/m^3", Dimension::flow_resistance},
    Unit{"kPa.s/m^3", Dimension::flow_resistance, 3},
    Unit{"MPa.s/m^3", Dimension::flow_resistance, 6},
    Unit{"Pa.s/L", Dimension::flow_resistance, 3},
    Unit{"kPa.s/L", Dimension::flow_resistance, 6},
    Unit{"Pa.s/mL", Dimension::flow_resistance, 6},
    Unit{"kPa.s/mL", Dimension::flow_resistance, 9},
    Unit{"mbar.s/mL", Dimension::flow_resistance, 8},
    Unit{"J", Dimension::energy},
    Unit{"mJ", Dimension::energy, -3},
    Unit{"uJ", Dimension::energy, -6},
    Unit{"N", Dimension::force},
    Unit{"mN", Dimension::force, -3},
    Unit{"kN", Dimension::force, 3},
    Unit{"lbf", Dimension::force, 0, pound_force_N},
    Unit{"kgf", Dimension::force, 0, g_n},
    Unit{"gf", Dimension::force, -3, g_n},
    Unit{"N.m", Dimension::moment},
    Unit{"Nm", Dimension::moment},
    Unit{"N.mm", Dimension::moment, -3},
    Unit{"Nmm", Dimension::moment, -3},
    Unit{"mN.m", Dimension::moment, -3},
    Unit{"1/m", Dimension::curvature},
    Unit{"1/cm", Dimension::curvature, 2},
    Unit{"1/mm", Dimension::curvature, 3},
};

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

Parts split(std::string_view text) noexcept {
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

const Unit* find_unit(std::string_view name) noexcept {
    const auto unit = std::find_if(units.begin(), units.end(), [&](const Unit& u) { return u.name == name; });
    return unit == units.end() ? nullptr : &*unit;
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
    for (const Unit& unit : units) {
        const bool ascii = unit.name.find_first_of("\xC2\xCE") == std::string_view::npos;
        if (ascii && (!dimension || unit.dimension == *dimension)) names.emplace_back(unit.name);
    }
    return names;
}

std::string_view name(Dimension dimension) noexcept {
    switch (dimension) {
        case Dimension::ratio: return "ratio";
        case Dimension::length: return "length";
        case Dimension::area: return "area";
        case Dimension::volume: return "volume";
        case Dimension::pressure: return "pressure";
        case Dimension::angle: return "angle";
        case Dimension::density: return "density";
        case Dimension::mass: return "mass";
        case Dimension::acceleration: return "acceleration";
        case Dimension::time: return "time";
        case Dimension::rate: return "rate";
        case Dimension::flow_resistance: return "flow resistance";
        case Dimension::energy: return "energy";
        case Dimension::force: return "force";
        case Dimension::moment: return "moment";
        case Dimension::curvature: return "curvature";
    }
    return "quantity";
}

std::string_view example(Dimension dimension) noexcept {
    switch (dimension) {
        case Dimension::ratio: return "1.5";
        case Dimension::length: return "3 mm";
        case Dimension::area: return "20 mm^2";
        case Dimension::volume: return "10 mL";
        case Dimension::pressure: return "30 kPa";
        case Dimension::angle: return "30 deg";
        case Dimension::density: return "1080 kg/m^3";
        case Dimension::mass: return "50 mg";
        case Dimension::acceleration: return "9.81 m/s^2";
        case Dimension::time: return "0.5 s";
        case Dimension::rate: return "10 Hz";
        case Dimension::flow_resistance: return "1e8 Pa.s/m^3";
        case Dimension::energy: return "5 mJ";
        case Dimension::force: return "2 N";
        case Dimension::moment: return "5 N.mm";
        case Dimension::curvature: return "10 1/m";
    }
    return "1";
}

Parsed<double> parse_quantity(std::string_view text, Dimension dimension) {
    const Parts parts = split(text);
    if (parts.number.empty()) return not_a_number(text, dimension);
    const std::string shown = quoted(trimmed(text));
    if (parts.unit.empty() && dimension != Dimension::ratio) {
        const std::string_view unit = split(example(dimension)).unit;
        return Refusal{shown + " has no unit, " + with_article(name(dimension)) + " is needed",
                       "write for example " + one_line(parts.number, max_number_length) + " " + std::string{unit}};
    }
    const Unit* unit = find_unit(with_plain_power(parts.unit));
    if (!parts.unit.empty() && unit == nullptr) return unknown_unit(parts, dimension);
    if (unit != nullptr && unit->dimension != dimension)
        return Refusal{shown + " is " + with_article(name(unit->dimension)) + " where " +
                           with_article(name(dimension)) + " is needed",
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
    const Parts parts = split(text);
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
        const Unit* unit = find_unit(candidate);
        if (unit->dimension != dimension) continue;
        chosen = unit;
        value = si / (unit->factor * std::pow(10.0, unit->power));
        if (std::abs(value) >= 1.0 || (si == 0 && unit->power == 0)) break;
    }
    return rounded_text(value, digits) + " " + std::string{chosen->name};
}

}  // namespace soft::core
