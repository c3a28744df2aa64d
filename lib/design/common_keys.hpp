#pragma once
/// The keys common to all designs (geometry.* comes from the family, material constants from the law).
/// Private to the module.
#include <string>
#include <vector>

#include "design/design.hpp"
#include "design/schema.hpp"

namespace soft::design {

[[nodiscard]] std::vector<Key> head_keys(const FamilyKeys& family);   ///< family, name
[[nodiscard]] std::vector<Key> model_keys(const FamilyKeys& family);  ///< model, mesh.* with the defaults of the family

[[nodiscard]] Key support_key(const std::string& component);
[[nodiscard]] Key output_point_key(const std::string& output);
[[nodiscard]] Key output_face_key(const std::string& output);
[[nodiscard]] Key output_obstacle_key(const std::string& output, std::vector<std::string> obstacles);
/// The measures of a face or of an obstacle, where it has no default, or of both. Its meaning is that of `measure`, or of all these
/// measures if it is nullptr.
[[nodiscard]] Key output_measure_key(const std::string& output, model::MeasuredObject object,
                                     const model::MeasureInfo* measure = nullptr);
[[nodiscard]] Key output_reference_key(const std::string& output);
[[nodiscard]] Key output_along_key(const std::string& output, std::string fallback);
/// Key of an end criterion other than an output; `section` is "path.until" or the `until` of a stage.
[[nodiscard]] Key until_key(const std::string& section, const std::string& quantity);
/// Keys names.<alias> with the face as the only choice. They are stored in the effective design, so that solve knows the aliases.
[[nodiscard]] std::vector<Key> name_keys(const FamilyKeys& family);

[[nodiscard]] std::vector<std::string> directions();           ///< axis, x, y, z, r, normal
[[nodiscard]] std::vector<std::string> obstacle_directions();  ///< axis, x, y, z

/// The key `geometry.cavities.<cavity>` of a family with faces_of_file.
[[nodiscard]] Key cavity_faces_key(const std::string& cavity);

/// Keys of a face rule below `geometry.faces.<name>`, without that prefix; all are optional.
[[nodiscard]] std::vector<Key> face_rule_keys();

/// Whether `text` is a valid name of an output, a stage, a face or a cavity.
[[nodiscard]] bool is_valid_name(std::string_view text);
inline constexpr std::string_view valid_name_rule = "letters, digits and _, a letter first, at most 40";

[[nodiscard]] const std::vector<std::string>& support_components();  ///< fixed, x, y, z, r
[[nodiscard]] const std::vector<std::string>&
until_quantities();  ///< pressure, volume_ratio, steps; outputs are allowed as well
/// Top-level keys in output order, each with a comment for templates.
struct SectionNote {
    std::string name, note;
};
[[nodiscard]] const std::vector<SectionNote>& section_notes();

}  // namespace soft::design
