#pragma once
/// The constants that the catalogue shows as examples, for tests of every law.
#include <sstream>
#include <string>

#include "core/units.hpp"
#include "material/catalogue.hpp"

namespace soft::material {

/// LawInfo::parameters[].example in SI.
inline Constants example_constants(std::string_view law) {
    Constants constants;
    for (const Parameter& parameter : find_law(law)->parameters) {
        const auto dimension = parameter.quantity == Quantity::pressure ? core::Dimension::pressure
                               : parameter.quantity == Quantity::angle  ? core::Dimension::angle
                                                                        : core::Dimension::ratio;
        std::string text{parameter.example};
        if (text.starts_with('[')) text = text.substr(1, text.size() - 2);
        std::istringstream values{text};
        for (std::string value; std::getline(values, value, ',');)
            constants[std::string{parameter.name}].push_back(
                core::quantity_or_throw(value, dimension, ExitCode::internal, parameter.name));
    }
    return constants;
}

}  // namespace soft::material
