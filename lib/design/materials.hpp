#pragma once
/// The materials of a design: `material` and the named ones below `materials`. The keys are generated from material::laws(); no
/// property of a law is repeated here. Private to the module. Tested by design/material_test and design/formulation_test.
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

/// The key of a parameter of a law; its path is the name.
[[nodiscard]] Key parameter_key(const material::Parameter& parameter);

/// Adds the keys of all materials. Throws Error(bad_input) for an unknown or missing law, for young/poisson together with mu/kappa, and
/// for `volumetric` with a law that defines its own volumetric energy. `default_frame` (cylindrical | cartesian) is the default of
/// the fibre frame.
void add_material_keys(Schema& schema, const Node& root, std::string_view source, Examples& examples,
                       std::string_view default_frame);

/// The material of one section; young and poisson are converted to mu and kappa. Throws Error at the location of the key for
/// inconsistent constants.
[[nodiscard]] model::Material material_of(const Values& values,
                                          const std::string& section = std::string{main_material});

/// The materials below `materials`, by name.
[[nodiscard]] std::map<std::string, model::Material, std::less<>> materials_of(const Values& values);

/// Paths of all material sections: "material", "materials.cap", "materials.paper".
[[nodiscard]] std::vector<std::string> material_sections(const Values& values);

/// Throws Error at the key `needed_by` if any material has no density.
void require_density(const Values& values, std::string_view needed_by);

/// Throws Error at mesh.formulation if the law does not support that formulation.
void check_law_formulation(const Values& values, const model::Material& material);

/// Throws Error(bad_input) for: mixed with first-order cells (no inf-sup stable pair of displacement and pressure); f-bar with
/// second-order cells, simplices or an incompressible material; displacement with an incompressible material. Each error names an
/// alternative.
void check_formulation(const Values& values);

}  // namespace soft::design
