#include <algorithm>

#include "core/text.hpp"
#include "design/common_keys.hpp"
#include "design/read_parts.hpp"

namespace soft::design {
namespace {

/// Names of the choices at every "known: ..." of the top level come from the schema; only family is needed before it.
std::vector<std::string> names_of(std::span<const FamilyKeys> families) {
    std::vector<std::string> names;
    for (const FamilyKeys& family : families) names.push_back(family.name);
    return names;
}

void append(std::vector<Key>& keys, std::vector<Key> more) {
    keys.insert(keys.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// Sections in which the design is silent come from the family; a load always states its own pressure.
void fill_sections(Node& root, const Node& defaults) {
    for (const char* section : {"supports", "outputs"}) {
        const Node* usual = find(defaults, section);
        if (usual != nullptr && find(root, section) == nullptr) put(root, section, *usual);
    }
}

}  // namespace

void override_tree(Node& root, std::span<const Override> overrides) {
    for (const Override& change : overrides)
        put(root, change.path, parse_fragment(change.value, "--set " + change.path));
}

const FamilyKeys& family_of(const Node& root, std::string_view source, std::span<const FamilyKeys> families) {
    const std::vector<std::string> names = names_of(families);
    if (root.kind == Node::Kind::empty)
        refuse(source, "", "the design is empty",
               "`mesh-gen --template " + (names.empty() ? "FAMILY" : names.front()) + "` prints one to start from");
    if (root.kind != Node::Kind::map)
        refuse(root.place, "", "a design is a group of keys", "write family: ..., material: ..., loads: ...");
    const Node* family = find(root, "family");
    if (family == nullptr)
        refuse(std::string{source} + ":1:1", "family", "missing (kind of actuator)",
               "add family: " + core::join(names, " | "));
    if (family->kind != Node::Kind::scalar)
        refuse(family->place, "family", "a single value is needed here", "write " + core::join(names, " | "));
    const auto found =
        std::find_if(families.begin(), families.end(), [&](const FamilyKeys& f) { return f.name == family->text; });
    if (found == families.end())
        refuse(family->place, "family", "no family is called " + core::quoted(family->text),
               core::did_you_mean(family->text, names));
    return *found;
}

Checked check_design(Node root, std::string_view source, const FamilyKeys& family) {
    const Node defaults = parse_fragment(family.defaults, place_default);
    fill_sections(root, defaults);
    Schema schema;
    schema.faces = {family.faces, family.aliases};
    Examples examples;
    append(schema.keys, head_keys(family));
    append(schema.keys, family.geometry);
    add_material_keys(schema, root, source, examples);
    append(schema.keys, model_keys(family));
    add_support_keys(schema, root);
    add_load_keys(schema, root, defaults, source, examples);
    add_path_keys(schema, root);
    add_output_keys(schema, root, defaults);
    append(schema.keys, solver_keys());
    for (const char* section : {"geometry", "supports", "loads", "outputs", "path.until", "solver"})
        schema.names[section];
    std::vector<Item> items = collect(root, schema, source, examples);
    return {std::move(items), std::move(schema.faces)};
}

Values values_of(std::span<const Item> items) {
    Values values;
    for (const Item& item : items) values.set(item.key.path, item.entry);
    return values;
}

Design read_design(std::string_view text, std::string_view source, std::span<const FamilyKeys> families,
                   std::span<const Override> overrides) {
    Node root = parse_yaml(text, source);
    override_tree(root, overrides);
    const FamilyKeys& family = family_of(root, source, families);
    const Checked checked = check_design(std::move(root), source, family);
    Design design;
    design.values = values_of(checked.items);
    design.family = family.name;
    design.name = design.values.text("name");
    design.material = material_of(design.values);
    design.supports = supports_of(checked.items, checked.faces, design.values);
    design.loads = loads_of(checked.items, checked.faces, design.values);
    design.path = path_of(checked.items, design.values);
    design.outputs = outputs_of(checked.items, checked.faces, design.values);
    design.solver = solver_of(design.values);
    design.effective_yaml = write_yaml(tree_of(checked.items));
    design.warnings = plausibility(design);
    return design;
}

}  // namespace soft::design
