#include <algorithm>
#include <utility>

#include "core/text.hpp"
#include "design/common_keys.hpp"
#include "design/dynamics_keys.hpp"
#include "design/load_names.hpp"
#include "design/material_library.hpp"
#include "design/materials.hpp"
#include "design/obstacles.hpp"
#include "design/read_parts.hpp"
#include "design/solver_keys.hpp"

namespace soft::design {
namespace {

/// Names of the families, for errors about `family`.
std::vector<std::string> names_of(std::span<const FamilyKeys> families) {
    std::vector<std::string> names;
    for (const FamilyKeys& family : families) names.push_back(family.name);
    return names;
}

void append(std::vector<Key>& keys, std::vector<Key> more) {
    keys.insert(keys.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// Fills missing sections with the defaults of the family, except loads, whose magnitude is always required.
void fill_sections(Node& root, const Node& defaults) {
    for (const char* section : {"supports", "outputs"}) {
        const Node* usual = find(defaults, section);
        if (usual != nullptr && find(root, section) == nullptr) put(root, section, *usual);
    }
}

/// Whether a key selects the material of a part: "geometry.layer.material".
bool is_material_reference(std::string_view path) {
    return path.starts_with("geometry.") && path.ends_with(".material");
}

/// Materials that the geometry refers to, as pairs of key and name ("geometry.layer.material", "paper"), as written or by default.
std::vector<std::pair<std::string, std::string>> materials_named(const Node& root, const FamilyKeys& family) {
    std::vector<std::pair<std::string, std::string>> named;
    for (const Key& key : family.geometry) {
        if (!is_material_reference(key.path)) continue;
        const Node* written = find_path(root, key.path);
        named.emplace_back(key.path, written == nullptr ? key.fallback : written->text);
    }
    return named;
}

/// Fills in the keys that the design omits of built-in materials of the family. A material with a law is taken as complete.
void fill_materials(Node& root, const FamilyKeys& family) {
    const Node* group = find(root, materials_group);
    if (group != nullptr && group->kind != Node::Kind::map && group->kind != Node::Kind::empty)
        return;  // refused later
    for (const auto& [key, name] : materials_named(root, family)) {
        const auto usual = family.materials.find(name);
        if (usual == family.materials.end()) continue;
        const std::string section = std::string{materials_group} + "." + name;
        const Node own = parse_fragment(usual->second, default_location);
        const Node* written = find_path(std::as_const(root), section);
        if (written == nullptr) put(root, section, own);
        if (written == nullptr || written->kind != Node::Kind::map || find(*written, "law") != nullptr) continue;
        for (const Member& member : own.members)
            if (find_path(std::as_const(root), section + "." + member.key) == nullptr)
                put(root, section + "." + member.key, member.value);
    }
}

FaceNames with_cavities(FaceNames names, const FamilyKeys& family) {
    for (const std::string& cavity : family.cavities)
        if (resolve_face(names, cavity) == cavity) names.cavities.push_back(cavity);
    return names;
}

constexpr const char *cavities_path = "geometry.cavities", *face_rules_path = "geometry.faces";

/// Adds the keys of the cavities that a design defines from the faces of its file.
void add_cavity_keys(Schema& schema, const Node& root) {
    for (const Member& cavity : members_of(root, cavities_path)) schema.keys.push_back(cavity_faces_key(cavity.key));
    schema.names[cavities_path];
}

/// Adds the keys of faces that are defined by position, as far as the design contains them.
void add_face_rule_keys(Schema& schema, const Node& root) {
    for (const Member& face : members_of(root, face_rules_path)) {
        const std::string own = std::string{face_rules_path} + "." + face.key;
        for (Key key : face_rule_keys()) {
            const std::string below = std::exchange(key.path, own + "." + key.path);
            const std::size_t dot = below.find('.');
            std::vector<std::string>& known = schema.names[own];
            if (const std::string first = below.substr(0, dot); std::ranges::find(known, first) == known.end())
                known.push_back(first);
            if (dot != std::string::npos)
                schema.names[own + "." + below.substr(0, dot)].push_back(below.substr(dot + 1));
            if (find_path(face.value, below) != nullptr) schema.keys.push_back(std::move(key));
        }
    }
    schema.names[face_rules_path];
}

void add_face_rule_names(FaceNames& names, const Node& root) {
    for (const Member& own : members_of(root, face_rules_path)) {
        const std::string path = std::string{face_rules_path} + "." + own.key;
        if (!is_valid_name(own.key)) refuse(own.location, path, "not a name of a face", valid_name_rule);
        if (!resolve_face(names, own.key).empty())
            refuse(own.location, path, "the file has a face of this name already", "choose another name");
        names.faces.push_back(own.key);
    }
}

/// The names that supports, loads and outputs may refer to. Other checks need the faces, so a missing file is rejected first.
FaceNames face_names(const Node& root, std::string_view source, const FamilyKeys& family, const FileFaces* built) {
    if (!family.faces_of_file) return with_cavities({family.faces, family.aliases}, family);
    if (built != nullptr) return {built->faces, family.aliases, built->cavities};
    const Key& key = family.geometry.front();
    const Node* file = find_path(root, key.path);
    if (file == nullptr || file->kind != Node::Kind::scalar) {
        const Node usual = parse_fragment(family.defaults, default_location);
        const Node* example = find_path(usual, key.path);
        const bool one_line = example != nullptr && example->text.find('\n') == std::string::npos;
        refuse(file == nullptr ? std::string{source} + ":1:1" : file->location, key.path,
               "missing (" + key.meaning + ")",
               example == nullptr ? ""
                                  : "add geometry: {" + key.path.substr(key.path.rfind('.') + 1) + ": " +
                                        (one_line ? example->text : std::string{"FILE"}) + "}");
    }
    FileFaces of_file = family.faces_of_file(file->text, file->location);
    FaceNames names{std::move(of_file.faces), family.aliases, std::move(of_file.cavities)};
    if (family.has_face_rules) add_face_rule_names(names, root);
    const Node* cavity = find_path(root, "geometry.cavity");
    const bool has_cavity = cavity != nullptr && (cavity->kind == Node::Kind::list || cavity->text != no_face);
    if (has_cavity && resolve_face(names, cavity_name).empty()) names.faces.emplace_back(cavity_name);
    names = with_cavities(std::move(names), family);
    for (const Member& own : members_of(root, cavities_path)) {
        const std::string path = std::string{cavities_path} + "." + own.key;
        if (!is_valid_name(own.key)) refuse(own.location, path, "not a name of a cavity", valid_name_rule);
        if (std::ranges::find(names.cavities, own.key) != names.cavities.end())
            refuse(own.location, path, "there is a cavity of this name already", "choose another name");
        if (resolve_face(names, own.key).empty()) names.faces.push_back(own.key);
        names.cavities.push_back(own.key);
    }
    return names;
}

/// The numbers of the design that are neither counts nor settings of the computation; those of a list as "material.mu.1".
std::vector<model::DesignParameter> parameters_of(std::span<const Item> items) {
    std::vector<model::DesignParameter> parameters;
    for (const Item& item : items) {
        const std::string& key = item.key.path;
        const bool is_physical = key.starts_with("geometry.") || key.starts_with("material.") ||
                                 key.starts_with(std::string{materials_group} + ".") || key.starts_with("loads.") ||
                                 key.starts_with("obstacles.") ||
                                 (key.starts_with("path.stages.") && key.find(".loads.") != std::string::npos);
        const auto dimension = dimension_of(item.key.kind);
        if (!is_physical || !dimension || key.find(".fit.") != std::string::npos) continue;
        const auto add = [&](std::string name, const std::string& text, double value) {
            if (value == 0) return;
            const auto [number, unit] = core::quantity_parts(text);
            const double unit_SI = core::quantity_or_throw(std::string{"1 "}.append(unit), *dimension,
                                                           ExitCode::internal, item.entry.location);
            parameters.push_back({std::move(name), unit, unit_SI, value});
        };
        if (item.list.size() < 2) {
            add(key, item.entry.text, item.entry.number);
            continue;
        }
        for (std::size_t i = 0; i < item.list.size(); ++i)
            add(key + "." + std::to_string(i + 1), item.list[i], item.entry.numbers[i]);
    }
    return parameters;
}

void check_material_references(const Values& values, const FamilyKeys& family) {
    std::vector<std::string> known{std::string{main_region}};
    for (const std::string& name : values.names_below(materials_group)) known.push_back(name);
    for (const Key& key : family.geometry) {
        if (!is_material_reference(key.path)) continue;
        const std::string& name = values.text(key.path);
        if (std::ranges::find(known, name) == known.end())
            throw values.refuse(key.path, "no material is called " + core::quoted(name),
                                core::did_you_mean(name, known) + "; or add materials: {" + name +
                                    ": {law: neo-hookean, mu: 0.1644 MPa}}");
    }
}

}  // namespace

void override_tree(Node& root, std::span<const Override> overrides) {
    for (const Override& change : overrides)
        put(root, change.path,
            parse_fragment(change.value, change.location.empty() ? "--set " + change.path : change.location));
}

Node overridden_design(std::string_view text, std::string_view source, std::span<const FamilyKeys> families,
                       std::span<const Override> overrides) {
    Node written = parse_yaml(text, source);
    expand_material_names(written);
    Node root = written;
    override_tree(root, overrides);
    const FamilyKeys& family = family_of(root, source, families);  // an override may set the family
    root = written;
    override_tree(root, in_names_of(written, overrides, {family.faces, family.aliases, {}}));
    resolve_material_names(root);
    return root;
}

const FamilyKeys& family_of(const Node& root, std::string_view source, std::span<const FamilyKeys> families) {
    const std::vector<std::string> names = names_of(families);
    if (root.kind == Node::Kind::empty)
        refuse(source, "", "the design is empty",
               "`mesh-gen --template " + (names.empty() ? "FAMILY" : names.front()) + "` prints one to start from");
    if (root.kind != Node::Kind::map)
        refuse(root.location, "", "a design is a group of keys", "write family: ..., material: ..., loads: ...");
    const Node* family = find(root, "family");
    if (family == nullptr)
        refuse(std::string{source} + ":1:1", "family", "missing (kind of actuator)",
               "add family: " + core::join(names, " | "));
    if (family->kind != Node::Kind::scalar)
        refuse(family->location, "family", "a single value is needed here", "write " + core::join(names, " | "));
    const auto found =
        std::find_if(families.begin(), families.end(), [&](const FamilyKeys& f) { return f.name == family->text; });
    if (found == families.end())
        refuse(family->location, "family", "no family is called " + core::quoted(family->text),
               core::did_you_mean(family->text, names));
    return *found;
}

bool is_of_revolution(const Node& root, const FamilyKeys& family) {
    if (std::ranges::find(family.models, "axisymmetric") == family.models.end()) return false;
    if (family.faces_of_file) {
        const Node* model = find_path(root, "model");
        return model != nullptr && model->text == "axisymmetric";
    }
    if (family.revolution_key.empty()) return true;
    const Node* length = find_path(root, "geometry." + family.revolution_key);
    if (length == nullptr) return false;
    const auto value = core::parse_quantity(length->text, core::Dimension::length);
    return std::holds_alternative<double>(value) && std::get<double>(value) > 0;
}

Checked check_design(Node root, std::string_view source, const FamilyKeys& family, const FileFaces* built) {
    const Node defaults = parse_fragment(family.defaults, default_location);
    if (!family.faces_of_file)
        fill_sections(root, defaults);  // there are no default supports and outputs for the faces of a file
    fill_materials(root, family);
    fill_empty_until(root);
    Checked checked;
    Schema schema;
    schema.faces = face_names(root, source, family, built);
    schema.dynamic = is_dynamic(root);
    Examples examples;
    append(schema.keys, head_keys(family));
    append(schema.keys, family.geometry);
    if (family.faces_of_file) add_cavity_keys(schema, root);
    if (family.has_face_rules) add_face_rule_keys(schema, root);
    add_material_keys(schema, root, source, examples, is_of_revolution(root, family) ? "cylindrical" : "cartesian");
    append(schema.keys, model_keys(family));
    append(schema.keys, name_keys(family));
    add_support_keys(schema, root);
    add_obstacle_keys(schema, root, family.obstacles);
    checked.loads = add_load_keys(schema, root, defaults, source, examples);
    checked.stages = add_path_keys(schema, root, checked.loads);
    add_output_keys(schema, root, defaults);
    append(schema.keys, dynamics_keys());
    append(schema.keys, solver_keys());
    for (const char* section : {"geometry", "supports", "loads", "outputs", "path.until", "dynamics", "solver"})
        schema.names[section];
    checked.items = collect(root, schema, source, examples);
    checked.faces = std::move(schema.faces);
    return checked;
}

Values values_of(std::span<const Item> items) {
    Values values;
    for (const Item& item : items) {
        values.set(item.key.path, item.entry);
        for (std::size_t i = 0; dimension_of(item.key.kind) && item.list.size() > 1 && i < item.list.size(); ++i) {
            const double number = item.entry.numbers[i];
            values.set(item.key.path + "." + std::to_string(i + 1),
                       {number, item.list[i], item.entry.location, item.entry.given, {number}});
        }
    }
    return values;
}

Design design_of(const Checked& checked, const FamilyKeys& family) {
    Design design;
    design.values = values_of(checked.items);
    design.family = family.name;
    design.name = design.values.text("name");
    design.material = material_of(design.values);
    design.supports = supports_of(checked.items, checked.faces, design.values);
    design.materials = materials_of(design.values);
    check_material_references(design.values, family);
    check_formulation(design.values);
    check_law_formulation(design.values, design.material);
    for (const auto& [name, material] : design.materials) check_law_formulation(design.values, material);
    design.contact = contact_of(design.values);
    design.obstacles = obstacles_of(checked.items, family.obstacles, design.values);
    Loads loads = loads_of(checked.loads, design.values);
    const bool has_formulation = design.values.has("mesh.formulation");
    design.dynamics = dynamics_of(
        {checked.loads, checked.items, has_formulation ? std::string_view{design.values.text("mesh.formulation")} : ""},
        design.values);
    design.outputs = outputs_of(checked.items, checked.faces, design.values);
    std::vector<std::string> outputs;
    for (const Design::OutputRequest& output : design.outputs) outputs.push_back(output.name);
    const PathParts parts{checked.stages, checked.loads, loads, outputs};
    design.path = path_of(parts, checked.items, design.values);
    design.loads = std::move(loads.pressures);
    design.dead_loads = std::move(loads.dead_loads);
    design.motions = std::move(loads.motions);
    design.solver = solver_of(design.values);
    design.parameters = parameters_of(checked.items);
    design.effective_yaml = write_yaml(tree_of(checked.items));
    design.warnings = plausibility(design);
    std::ranges::move(unused_values(parts, design.values), std::back_inserter(design.warnings));
    return design;
}

Design read_design(std::string_view text, std::string_view source, std::span<const FamilyKeys> families,
                   std::span<const Override> overrides) {
    Node root = overridden_design(text, source, families, overrides);
    const FamilyKeys& family = family_of(root, source, families);
    return design_of(check_design(std::move(root), source, family), family);
}

}  // namespace soft::design
