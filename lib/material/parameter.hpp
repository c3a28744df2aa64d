#pragma once
/// Description of a law: a table that is used by the design parser, its error messages, `mesh-gen --list-materials` and the
/// documentation. The header of every law defines one LawInfo.
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace soft::material {

/// Constants of a law in SI by the names of its parameters; scalars have one entry.
using Constants = std::map<std::string, std::vector<double>, std::less<>>;

enum class Quantity { pressure, ratio, angle, count };

struct Parameter {
    std::string_view name;
    Quantity quantity = Quantity::pressure;
    std::string_view meaning;                               ///< one sentence, no full stop
    std::string_view example;                               ///< as in a design, with its unit; also shown in templates
    double min = -std::numeric_limits<double>::infinity();  ///< SI, exclusive where min_open
    double max = std::numeric_limits<double>::infinity();
    bool min_open = false;
    std::string_view fallback = {};  ///< as in a design; empty: the parameter is required
    int max_count = 1;               ///< 1: a single value; else a list of 1 to `max_count` values
};

/// A required constant above zero.
[[nodiscard]] constexpr Parameter positive(std::string_view name, std::string_view meaning, std::string_view example,
                                           Quantity quantity = Quantity::pressure) {
    return {.name = name, .quantity = quantity, .meaning = meaning, .example = example, .min = 0, .min_open = true};
}

/// A modulus of either sign that is zero unless given.
[[nodiscard]] constexpr Parameter optional_modulus(std::string_view name, std::string_view meaning,
                                                   std::string_view example) {
    return {.name = name, .meaning = meaning, .example = example, .fallback = "0 Pa"};
}

/// Supported values of the bulk modulus kappa.
enum class Bulk {
    selectable,  ///< kappa: a modulus, or incompressible
    finite       ///< kappa: a modulus; the law has no incompressible limit
};

struct LawInfo {
    std::string_view name;
    std::string_view energy;    ///< W per undeformed volume, or the stress where there is no energy
    std::string_view validity;  ///< use of the law and its limits; one sentence
    std::string_view source;    ///< author, journal, year
    std::vector<Parameter> parameters;
    Bulk bulk = Bulk::selectable;
    bool takes_volumetric = true;      ///< the design's `volumetric` chooses Theta(J)
    bool takes_young_poisson = false;  ///< young and poisson may be given instead of mu and kappa
    bool mixed = true;                 ///< has a form with the pressure as an unknown
    bool f_bar = true;                 ///< supports the F-bar formulation
    bool fibers = false;               ///< uses the directions of a fibre frame
};

}  // namespace soft::material
