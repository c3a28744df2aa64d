#include "design/key_list.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "core/text.hpp"
#include "core/unit_names.hpp"
#include "design/common_keys.hpp"
#include "design/dynamics_keys.hpp"
#include "design/load_keys.hpp"
#include "design/markdown.hpp"
#include "design/material_library.hpp"
#include "design/materials.hpp"
#include "design/obstacles.hpp"
#include "design/path.hpp"
#include "design/solver_keys.hpp"
#include "design/time_function_keys.hpp"

namespace soft::design {
namespace {

using Keys = std::vector<Key>;
using Rows = std::vector<std::string>;

void append_keys(Keys& keys, const Keys& more) { keys.insert(keys.end(), more.begin(), more.end()); }

/// One row for each different key.
Rows rows_of(const Keys& keys) {
    Rows rows;
    for (const Key& key : keys) {
        const bool of_output = key.path == "path.until.OUTPUT";  // its dimension is that of the output
        std::string row = table_row({code(key.path), of_output ? "a value of the output" : range_text(key),
                                     key.fallback.empty() ? "-" : key.fallback, key.meaning});
        if (std::ranges::find(rows, row) == rows.end()) rows.push_back(std::move(row));
    }
    return rows;
}

std::string table_of(const Rows& rows) {
    return table_head({"key", "values", "default", "meaning"}) + core::join(rows, "") + "\n";
}

std::string key_section(const std::string& title, const std::string& note, const Rows& rows) {
    return "## " + title + "\n\n" + (note.empty() ? "" : note + "\n\n") + table_of(rows);
}

std::string unit_section() {
    using core::Dimension;
    constexpr std::array dimensions{
        Dimension::length,          Dimension::area,  Dimension::volume,       Dimension::pressure,  Dimension::angle,
        Dimension::density,         Dimension::mass,  Dimension::acceleration, Dimension::time,      Dimension::rate,
        Dimension::flow_resistance, Dimension::force, Dimension::moment,       Dimension::curvature, Dimension::ratio};
    std::string text = "## Units\n\n" + table_head({"quantity", "units", "example"});
    for (const Dimension dimension : dimensions) {
        const std::string units = core::join(core::unit_names(dimension));
        text += table_row({std::string{core::name(dimension)}, dimension == Dimension::ratio ? "none, or %" : units,
                           code(core::example(dimension))});
    }
    return text + "\n";
}

Keys head_section_keys(std::span<const FamilyKeys> families) {
    FamilyKeys any;
    any.name = "the family";
    Keys keys = head_keys(any);
    keys.front().choices.clear();
    for (const FamilyKeys& family : families) keys.front().choices.push_back(family.name);
    return keys;
}

/// The keys of `material` with the given members, for example "law: yeoh".
Keys keys_of_material(const Node& material) {
    Node root;
    put(root, main_material, material);
    Schema schema;
    Examples examples;
    add_material_keys(schema, root, "", examples, "cylindrical in bodies of revolution, else cartesian");
    return schema.keys;
}

/// The keys of `material` except the parameters of the laws. A variant that only a few laws have names them.
Keys material_section_keys() {
    Keys keys = {value_key("material.name", Kind::text, {},
                           "silicone of the material library, in place of a law and its parameters"),
                 value_key("material.range", Kind::ratio, {},
                           "with name: selects the narrowest set of constants that covers this engineering strain")};
    std::vector<std::pair<Key, std::vector<std::string>>> variants;
    const auto add = [&](const Key& key, const material::LawInfo& law) {
        const auto found = std::ranges::find_if(
            variants, [&](const auto& variant) { return rows_of({variant.first}) == rows_of({key}); });
        std::vector<std::string>& laws =
            found == variants.end() ? variants.emplace_back(key, std::vector<std::string>{}).second : found->second;
        laws.emplace_back(law.name);
    };
    for (const material::LawInfo& law : material::laws()) {
        const std::string name{law.name};
        const auto is_parameter = [&](const Key& key) {
            return std::ranges::any_of(law.parameters, [&](const material::Parameter& parameter) {
                return "material." + parameter_key(parameter).path == key.path;
            });
        };
        for (const Key& key : keys_of_material(parse_fragment("{law: " + name + "}", default_location)))
            if (!is_parameter(key)) add(key, law);
        if (!law.takes_young_poisson) continue;
        for (const Key& key : keys_of_material(parse_fragment("{law: " + name + ", young: 1 MPa}", default_location)))
            if (key.path == "material.young" || key.path == "material.poisson") add(key, law);
    }
    constexpr std::size_t few_laws = 4;
    std::ranges::stable_sort(variants, {}, [](const auto& variant) { return variant.first.path; });
    for (auto& [key, laws] : variants) {
        if (laws.size() <= few_laws) key.meaning += " (" + core::join(laws) + ")";
        keys.push_back(std::move(key));
    }
    for (const Key& key : keys_of_material(material_sets(material_files().front()).front().block))
        if (key.path.starts_with("material.fit.")) keys.push_back(key);
    return keys;
}

Keys support_section_keys() {
    Keys keys;
    for (const std::string& component : support_components()) keys.push_back(support_key(component));
    return keys;
}

/// Path of a load in the tables.
std::string load_path(const std::string& section, LoadTarget target) {
    return section + (target == LoadTarget::cavity     ? ".CAVITY"
                      : target == LoadTarget::face     ? ".FACE"
                      : target == LoadTarget::obstacle ? ".OBSTACLE"
                                                       : ".gravity");
}

/// The keys with the magnitude of the loads below `section`.
Keys magnitude_keys(const std::string& section, When when) {
    Keys keys;
    for (const LoadForm& form : load_forms()) {
        if (form.kind == LoadKind::shared_gas && when == When::stage_end) continue;
        keys.push_back(magnitude_key(load_path(section, form.target), form, when));
        if (form.kind == LoadKind::shared_gas) keys.back().choices = {"CAVITY"};
    }
    return keys;
}

Keys load_section_keys() {
    Keys keys = magnitude_keys("loads", When::full_load);
    for (const LoadForm& form : load_forms())
        if (!form.along.path.empty()) keys.push_back(along_key(load_path("loads", form.target), form));
    for (Key& key : pressure_keys("loads.CAVITY", LoadTarget::cavity, true)) {
        if (key.path.ends_with(".acts_on")) key.path = "loads.LOAD.acts_on";  // of a face, too
        keys.push_back(std::move(key));
    }
    Schema schema;
    Examples examples;
    // An unknown kind of time function has the keys of all kinds.
    add_time_function_keys(schema, "loads.LOAD", parse_fragment("{time_function: {kind: any}}", default_location),
                           examples);
    append_keys(keys, schema.keys);
    return keys;
}

Keys path_section_keys() {
    const Node root = parse_fragment(
        "{outputs: {OUTPUT: {}}, path: {until: {pressure: 1, volume_ratio: 1, steps: 1, OUTPUT: 1}, stages: {STAGE: {}}}}",
        default_location);
    const std::vector<LoadEntry> loads{
        {.path = "loads.CAVITY", .location = "", .name = "CAVITY", .form = &load_forms().front()}};
    Schema schema;
    static_cast<void>(add_path_keys(schema, root, loads));
    append_keys(schema.keys, magnitude_keys("path.stages.STAGE.loads", When::stage_end));
    return schema.keys;
}

Keys output_section_keys() {
    return {output_face_key("OUTPUT"),
            output_point_key("OUTPUT"),
            output_obstacle_key("OUTPUT", {"OBSTACLE", std::string{model::self_contact}}),
            output_measure_key("OUTPUT", model::MeasuredObject::face_or_obstacle),
            output_reference_key("OUTPUT"),
            output_along_key("OUTPUT", "axis")};
}

Keys obstacle_section_keys(std::span<const ObstacleKeys> shapes) {
    Keys keys;
    for (const ObstacleKeys& shape : shapes) append_keys(keys, obstacle_keys("OBSTACLE", shape));
    return keys;
}

/// The keys of `geometry`, `mesh`, `model` and `names`.
Keys family_keys(const FamilyKeys& family) {
    Keys keys = family.geometry;
    if (family.faces_of_file) keys.push_back(cavity_faces_key("CAVITY"));
    if (family.has_face_rules)
        for (Key key : face_rule_keys()) {
            key.path.insert(0, "geometry.faces.FACE.");
            keys.push_back(std::move(key));
        }
    append_keys(keys, model_keys(family));
    append_keys(keys, name_keys(family));
    return keys;
}

/// The rows that most families have, of keys that all families have.
Rows common_rows(std::span<const FamilyKeys> families) {
    std::map<std::string, std::size_t> paths, rows;
    for (const FamilyKeys& family : families)
        for (const Key& key : family_keys(family)) {
            ++paths[key.path];
            ++rows[rows_of({key}).front()];
        }
    Rows common;
    for (const FamilyKeys& family : families)
        for (const Key& key : family_keys(family)) {
            const std::string row = rows_of({key}).front();
            const bool most = 3 * rows[row] >= 2 * families.size();
            if (most && paths[key.path] == families.size() && std::ranges::find(common, row) == common.end())
                common.push_back(row);
        }
    return common;
}

std::string defaults_text(const FamilyKeys& family) {
    std::string text = family.defaults;
    if (!family.materials.empty()) text += "materials:\n";
    for (const auto& [name, yaml] : family.materials)
        text.append("  ").append(name).append(": ").append(yaml).append("\n");
    return "```yaml\n" + text + "```\n\n";
}

std::string family_section(const FamilyKeys& family, const Rows& common) {
    Rows rows = rows_of(family_keys(family));
    std::erase_if(rows, [&](const std::string& row) { return std::ranges::find(common, row) != common.end(); });
    std::string text = "### " + family.name + "\n\nThe family `" + family.name + "`: " + family.summary + ".\n\n";
    if (family.faces_of_file)
        text += "The faces are those of the file; supports, loads and outputs have no defaults.\n\n";
    else
        text +=
            "Faces: " + core::join(family.faces) + ". Default supports, loads and outputs:\n\n" + defaults_text(family);
    return text + table_of(rows);
}

}  // namespace

std::string key_list(std::span<const FamilyKeys> families) {
    const Rows common = common_rows(families);
    std::string text = unit_section();
    text += key_section("family and name", "", rows_of(head_section_keys(families)));
    text += key_section("material and materials",
                        "`materials.NAME` has the keys of `material`. Each law has further keys, its parameters.",
                        rows_of(material_section_keys()));
    text += key_section("mesh", "A family may have further keys of `mesh`, or other values of these.", common);
    text += key_section("supports", "", rows_of(support_section_keys()));
    text += key_section("loads",
                        "A cavity has one of the first five keys or `shares`; a face has one of `" +
                            core::join(words_of(LoadTarget::face), "`, `") +
                            "`; an obstacle has `displacement`. `time_function` and `line` need `dynamics.duration`.",
                        rows_of(load_section_keys()));
    if (!families.empty())
        text += key_section("obstacles", "An obstacle has one shape: the keys of one of these groups.",
                            rows_of(obstacle_section_keys(families.front().obstacles)));
    text += key_section("contact", "", rows_of(contact_keys()));
    text += key_section("path", "", rows_of(path_section_keys()));
    text +=
        key_section("outputs", "An output has a `face`, a `point` or an `obstacle`.", rows_of(output_section_keys()));
    text +=
        key_section("dynamics", "A dynamic path needs `duration`, and `material.density`.", rows_of(dynamics_keys()));
    text += key_section("solver", "", rows_of(solver_keys()));
    text += "## Families\n\nThe keys of `geometry`, `mesh`, `model` and `names` of each family.\n\n";
    for (const FamilyKeys& family : families) text += family_section(family, common);
    text.pop_back();
    return text;
}

}  // namespace soft::design
