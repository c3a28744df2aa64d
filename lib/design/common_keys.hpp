#pragma once
/// The keys every design shares, declared once (geometry.* comes from the family, constants from the law).
/// Private to the module.
#include <string>
#include <vector>

#include "design/design.hpp"
#include "design/schema.hpp"

namespace soft::design {

[[nodiscard]] std::vector<Key> head_keys(const FamilyKeys& family);   ///< family, name
[[nodiscard]] std::vector<Key> model_keys(const FamilyKeys& family);  ///< model, mesh.* with the family's own defaults

[[nodiscard]] Key law_key();
[[nodiscard]] Key kappa_key();
[[nodiscard]] Key volumetric_key();
[[nodiscard]] Key support_key(const std::string& component);
[[nodiscard]] Key output_point_key(const std::string& output);
[[nodiscard]] Key output_face_key(const std::string& output);
[[nodiscard]] Key output_measure_key(const std::string& output);
[[nodiscard]] Key output_reference_key(const std::string& output);
[[nodiscard]] Key output_along_key(const std::string& output, std::string fallback);
/// An end that is no output; `section` is "path.until" or that of a stage.
[[nodiscard]] Key until_key(const std::string& section, const std::string& quantity);
/// names.<other name>: face; one word, so that solve knows the other names too.
[[nodiscard]] std::vector<Key> name_keys(const FamilyKeys& family);

[[nodiscard]] std::vector<std::string> directions();  ///< axis, x, y, z, r, normal

/// Whether the user may call an output or a stage so.
/// What a face below `geometry.faces` may be named by, without that path; all are optional.
[[nodiscard]] std::vector<Key> face_rule_keys();

[[nodiscard]] bool is_own_name(std::string_view text);
inline constexpr std::string_view own_name_remedy = "letters, digits and _, a letter first, at most 40";

[[nodiscard]] const std::vector<std::string>& support_components();  ///< fixed, x, y, z, r
[[nodiscard]] const std::vector<std::string>&
until_quantities();  ///< pressure, volume_ratio, steps; besides the outputs
/// Top-level keys in the order in which a design is written, and a sentence on the groups for templates.
struct SectionNote {
    std::string name, note;
};
[[nodiscard]] const std::vector<SectionNote>& section_notes();

}  // namespace soft::design
