#pragma once
/// The laws a design can name: their constants with range and meaning, declared once. A new law is a new row here and
/// a new header in lib/material. Private to the room. Held by design/materials_test.
#include <map>
#include <span>
#include <string>
#include <vector>

#include "design/schema.hpp"

namespace soft::design {

using Constants = std::map<std::string, std::vector<double>>;  ///< SI, as in model::Material

struct Constant {
    Key key;              ///< path is the bare name ("mu"); an empty fallback makes it required
    std::string example;  ///< value for a template
};

struct Law {
    std::string name;
    std::string energy;  ///< W per undeformed volume in the isochoric invariants
    std::string source;
    std::vector<Constant> constants;
    double (*initial_shear_modulus_Pa)(const Constants&);
};

[[nodiscard]] std::span<const Law> laws();

/// Names of laws() in order; names the specification reserves for laws that this version lacks.
[[nodiscard]] std::vector<std::string> law_names();
[[nodiscard]] std::span<const std::string> reserved_law_names();

/// nullptr for a name without a row.
[[nodiscard]] const Law* find_law(std::string_view name);

}  // namespace soft::design
