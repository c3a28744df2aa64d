#pragma once
/// The materials of a design, `material` and those by name below `materials`: their keys come from material::laws(), the one table of the laws; nothing of a law is repeated
/// here. Private to the module. Tested by design/material_test.
#include <map>
#include <string>
#include <vector>

#include "design/sections.hpp"
#include "model/rubber.hpp"

namespace soft::design {

/// Names of the laws in the order of material::laws().
[[nodiscard]] std::vector<std::string> law_names();

/// Sections: the main rubber, and the group of all others ("materials.paper").
inline constexpr std::string_view main_material = "material", materials_group = "materials";

/// The key of a parameter of a law, "material.<name>".
[[nodiscard]] Key parameter_key(const material::Parameter& parameter);

/// Throws Error(bad_input) for a law that is unknown or missing, keys of two ways to state the
/// moduli, and `volumetric` for a law that has its own. `usual_frame` (cylindrical | cartesian) is that of fibres; empty: fibres
/// must state theirs.
void add_material_keys(Schema& schema, const Node& root, std::string_view source, Examples& examples,
                       std::string_view usual_frame);

/// Of one section; young and poisson become mu and kappa. Throws Error for constants that do not fit together, at the key's place.
[[nodiscard]] model::Material material_of(const Values& values,
                                          const std::string& section = std::string{main_material});

/// Those below `materials`, by name.
[[nodiscard]] std::map<std::string, model::Material, std::less<>> materials_of(const Values& values);

/// "material", "materials.cap", "materials.paper".
[[nodiscard]] std::vector<std::string> material_sections(const Values& values);

/// Throws Error at `needed_by` where a material has no density.
void require_density(const Values& values, std::string_view needed_by);

/// Throws Error at mesh.formulation for a law that cannot be run in it.
void check_law_formulation(const Values& values, const model::Material& material);

}  // namespace soft::design
