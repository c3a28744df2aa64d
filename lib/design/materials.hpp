#pragma once
/// The material of a design: its keys come from material::laws(), the one table of the laws; nothing of a law is repeated
/// here. Private to the room. Held by design/material_test.
#include <string>
#include <vector>

#include "design/sections.hpp"
#include "model/rubber.hpp"

namespace soft::design {

/// Names of the laws in the order of material::laws().
[[nodiscard]] std::vector<std::string> law_names();

/// The key of a parameter of a law, "material.<name>".
[[nodiscard]] Key parameter_key(const material::Parameter& parameter);

/// Throws Error(bad_input) for a law that is unknown or missing, keys of two ways to state the
/// moduli, and `volumetric` for a law that has its own. `usual_frame` (cylindrical | cartesian) is that of fibres.
void add_material_keys(Schema& schema, const Node& root, std::string_view source, Examples& examples,
                       std::string_view usual_frame);

/// young and poisson become mu and kappa. Throws Error for constants that do not fit together, at the key's place.
[[nodiscard]] model::Material material_of(const Values& values);

/// Throws Error at mesh.formulation for a law that cannot be run in it.
void check_law_formulation(const Values& values, const model::Material& material);

}  // namespace soft::design
