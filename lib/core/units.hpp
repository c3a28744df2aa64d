#pragma once
/// Conversion of quantities with units ("3 mm", "40kPa", "1080 kg/m^3", "30 deg") to SI and back. Decimal prefixes are applied to
/// the decimal text, so "0.1644 MPa" and "164400 Pa" give the same double. Independent of the locale; nan and inf are rejected.
/// Tested by core/units_test.
#include <optional>
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

/// Why a text was rejected, and the remedy; the caller adds the location.
struct Refusal {
    std::string problem;
    std::string remedy;
};

template <class T>
using Parsed = std::variant<T, Refusal>;

/// SI value of `text`. A dimensional quantity needs a unit; a ratio is a bare number or a percentage.
[[nodiscard]] Parsed<double> parse_quantity(std::string_view text, Dimension dimension);

/// Parses a whole decimal number without a unit.
[[nodiscard]] Parsed<long> parse_count(std::string_view text);

/// parse_quantity that throws Error(code, location, problem, remedy).
[[nodiscard]] double quantity_or_throw(std::string_view text, Dimension dimension, ExitCode code,
                                       std::string_view location);

/// The same quantity with one blank between number and unit: "40kPa" -> "40 kPa". Text without a number is only trimmed.
[[nodiscard]] std::string tidy_quantity(std::string_view text);

/// Number and unit of a quantity as written: "40kPa" -> "40", "kPa"; the unit is empty for a bare number.
struct QuantityParts {
    std::string number, unit;
};
[[nodiscard]] QuantityParts quantity_parts(std::string_view text);

/// An SI value in a suitable unit ("3 mm", "164.4 kPa") with six digits: for messages, not for files.
[[nodiscard]] std::string quantity_text(double si, Dimension dimension);

/// The dimension of a unit; nullopt for an unknown unit.
[[nodiscard]] std::optional<Dimension> dimension_of(std::string_view unit);

/// Name of a dimension ("length"), and an example value ("3 mm").
[[nodiscard]] std::string_view name(Dimension dimension) noexcept;
[[nodiscard]] std::string_view example(Dimension dimension) noexcept;

}  // namespace soft::core
