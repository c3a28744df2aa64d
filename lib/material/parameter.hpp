#pragma once
/// What a law says of itself: the one table that feeds the parser of designs, its errors, `mesh-gen --list-materials` and
/// the README. Every law's header fills one LawInfo.
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
    std::string_view meaning;  ///< one sentence, no full stop
    std::string_view example;  ///< as in a design, with its unit; also what a template shows
    double min = -std::numeric_limits<double>::infinity();  ///< SI, exclusive where min_open
    double max = std::numeric_limits<double>::infinity();
    bool min_open = false;
    std::string_view fallback = {};  ///< as in a design; empty: the parameter is required
    int most = 1;                    ///< 1: a single value; else a list of 1 to `most` values
};

/// How the design states the resistance to a change of volume.
enum class Bulk {
    selectable,  ///< kappa: a modulus, or incompressible
    finite       ///< kappa: a modulus; the law has no incompressible limit
};

struct LawInfo {
    std::string_view name;
    std::string_view energy;    ///< W per undeformed volume, or the stress where there is no energy
    std::string_view validity;  ///< what the law is for, and its limits; one sentence
    std::string_view source;    ///< author, year, place
    std::vector<Parameter> parameters;
    Bulk bulk = Bulk::selectable;
    bool takes_volumetric = true;      ///< the design's `volumetric` chooses Theta(J)
    bool takes_young_poisson = false;  ///< young and poisson may stand in place of mu and kappa
    bool mixed = true;                 ///< has a form with the pressure as an unknown
    bool f_bar = true;                 ///< may be run with F-bar
    bool fibers = false;               ///< looks at the directions of a fibre frame
};

}  // namespace soft::material
