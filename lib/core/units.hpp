#pragma once
/// Quantities as people write them ("3 mm", "40kPa", "1080 kg/m^3", "30 deg") to SI and back. Decimal prefixes are
/// applied to the decimal text, so "0.1644 MPa" and "164400 Pa" are the same double. Independent of the locale; nan
/// and inf are refused. Tested by core/units_test.
#include <string>
#include <string_view>
#include <variant>

#include "core/error.hpp"

namespace soft::core {

enum class Dimension {
    ratio,
    length,
    area,
    volume,
    pressure,
    angle,
    density,
    mass,
    acceleration,
    time,
    rate,
    flow_resistance,
    energy,
    force,
    moment,
    curvature
};

/// Why a text was refused and what would be right; the caller knows the place.
struct Refusal {
    std::string problem;
    std::string remedy;
};

template <class T>
using Parsed = std::variant<T, Refusal>;

/// SI value of `text`. A dimensional quantity needs its unit; a ratio is a bare number or a percentage.
[[nodiscard]] Parsed<double> parse_quantity(std::string_view text, Dimension dimension);

/// A whole decimal number without a unit.
[[nodiscard]] Parsed<long> parse_count(std::string_view text);

/// parse_quantity for callers that have a place: throws Error(code, place, problem, remedy).
[[nodiscard]] double quantity_or_throw(std::string_view text, Dimension dimension, ExitCode code,
                                       std::string_view place);

/// The same quantity with one blank between number and unit: "40kPa" -> "40 kPa". Text that holds no number is only
/// trimmed.
[[nodiscard]] std::string tidy_quantity(std::string_view text);

/// The two parts of a quantity as written: "40kPa" -> "40", "kPa"; no unit where there is no blank after tidying.
struct QuantityParts {
    std::string number, unit;
};
[[nodiscard]] QuantityParts quantity_parts(std::string_view text);

/// An SI value in a unit that reads well ("3 mm", "164.4 kPa"), six digits: for messages, not for files.
[[nodiscard]] std::string quantity_text(double si, Dimension dimension);

/// "length", and a value one would write, "3 mm".
[[nodiscard]] std::string_view name(Dimension dimension) noexcept;
[[nodiscard]] std::string_view example(Dimension dimension) noexcept;

}  // namespace soft::core
