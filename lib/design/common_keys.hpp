#pragma once
/// The keys every design shares, declared once (geometry.* comes from the family, constants from the law).
/// Private to the room.
#include <string>
#include <vector>

#include "design/design.hpp"
#include "design/schema.hpp"

namespace soft::design {

[[nodiscard]] std::vector<Key> head_keys(const FamilyKeys& family);   ///< family, name
[[nodiscard]] std::vector<Key> model_keys(const FamilyKeys& family);  ///< model, mesh.* with the family's own defaults
[[nodiscard]] std::vector<Key> solver_keys();                         ///< solver.*; defaults are model::SolverSettings'

[[nodiscard]] Key law_key();
[[nodiscard]] Key kappa_key();
[[nodiscard]] Key volumetric_key();
[[nodiscard]] Key control_key(std::string fallback);
[[nodiscard]] Key support_key(const std::string& component);
[[nodiscard]] Key load_pressure_key(const std::string& target);
[[nodiscard]] Key load_traction_key(const std::string& face);
[[nodiscard]] Key load_along_key(const std::string& face);
[[nodiscard]] Key load_sealed_key(const std::string& target, std::string fallback);
[[nodiscard]] Key output_face_key(const std::string& output);
[[nodiscard]] Key output_along_key(const std::string& output, std::string fallback);
[[nodiscard]] Key until_key(const std::string& quantity);

[[nodiscard]] const std::vector<std::string>& support_components();  ///< fixed, x, y, z, r
[[nodiscard]] const std::vector<std::string>&
until_quantities();  ///< pressure, volume_ratio, steps; besides the outputs
/// Top-level keys in the order in which a design is written, and a sentence on the groups for templates.
struct SectionNote {
    std::string name, note;
};
[[nodiscard]] const std::vector<SectionNote>& section_notes();

}  // namespace soft::design
