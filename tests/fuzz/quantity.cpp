/// Fuzz target: numbers with units, parsed as every dimension.
#include <cmath>

#include "core/units.hpp"
#include "target.hpp"

void soft::fuzz::read(std::span<const std::byte> bytes) {
    const std::string_view text = text_of(bytes);
    static_cast<void>(core::parse_count(text));
    const std::string tidy = core::tidy_quantity(text);
    for (int d = 0; d <= static_cast<int>(core::Dimension::curvature); ++d) {
        const auto dimension = static_cast<core::Dimension>(d);
        const auto parsed = core::parse_quantity(text, dimension);
        const auto* value = std::get_if<double>(&parsed);
        if (value == nullptr) continue;
        require(std::isfinite(*value), "a quantity is finite");
        const auto again = core::parse_quantity(tidy, dimension);
        require(std::holds_alternative<double>(again) && std::get<double>(again) == *value,
                "a tidied quantity parses to the same value");
        static_cast<void>(core::quantity_text(*value, dimension));
    }
    static_cast<void>(core::quantity_or_throw(text, core::Dimension::pressure, ExitCode::bad_input, "--set key"));
}
