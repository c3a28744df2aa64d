#include <algorithm>

#include "core/text.hpp"
#include "design/common_keys.hpp"
#include "design/load_names.hpp"
#include "design/materials.hpp"
#include "design/read_parts.hpp"

namespace soft::design {
namespace {

constexpr std::size_t note_column = 36;

/// Canonical YAML with a comment on every key and every section.
std::string annotated(std::span<const Item> items, auto&& note_of) {
    Node root = tree_of(items);
    for (const Item& item : items) find_path(root, item.key.path)->note = note_of(item);
    for (const SectionNote& section : section_notes())
        if (Node* group = find_path(root, section.name); group != nullptr && !section.note.empty())
            group->note = section.note;
    if (Node* stages = find_path(root, "path.stages"))
        stages->note = "in the order written; a load is 0 until a stage names it and then keeps its value";
    std::vector<std::string> ends = until_quantities();
    for (const Item& item : items)
        if (item.key.path.starts_with("outputs.") && item.key.path.ends_with(".measure"))
            ends.insert(ends.begin(), item.key.path.substr(8, item.key.path.size() - 8 - 8));
    find_path(root, "path.until")->note =
        "the path, or each of its stages, also ends at the first of these: " + core::join(ends);
    return write_yaml(root, note_column);
}

std::string face_list(const FamilyKeys& family) {
    std::string text = core::join(family.faces);
    for (const auto& [alias, face] : family.aliases) text += ", " + alias + " (= " + face + ")";
    return text;
}

/// The default as shown in a template. Supports and outputs have no default of the key but one of the family.
std::string default_text(const Item& item) {
    if (!item.key.fallback.empty()) return "default " + item.key.fallback;
    return item.entry.given ? "required" : "the family's default";
}

}  // namespace

std::string example_design(const FamilyKeys& family) {
    const material::LawInfo& law = *material::find_law("neo-hookean");  // the law with the fewest parameters
    const Node defaults = parse_fragment(family.defaults, default_location);
    Node root;
    put(root, "family", scalar_node(family.name, default_location));
    if (family.faces_of_file)
        for (const char* section : {"geometry", "mesh", "supports", "outputs"})
            if (const Node* usual = find(defaults, section)) put(root, section, *usual);
    put(root, "material.law", scalar_node(std::string{law.name}, default_location));
    for (const material::Parameter& parameter : law.parameters)
        put(root, "material." + parameter_key(parameter).path,
            scalar_node(std::string{parameter.example}, default_location));
    if (const Node* loads = find(defaults, "loads"); loads != nullptr && !loads->members.empty()) {
        put(root, "loads", *loads);
        return write_yaml(root);
    }
    const bool cavity = std::find(family.faces.begin(), family.faces.end(), cavity_name) != family.faces.end();
    const std::string target = cavity || family.faces.empty() ? std::string{cavity_name} : family.faces.back();
    put(root, "loads." + target + ".pressure", scalar_node("30 kPa", default_location));
    return write_yaml(root);
}

std::string template_yaml(const FamilyKeys& family) {
    const std::string source = "template of " + family.name;
    FamilyKeys known = family;  // a template is printed without reading the file it names
    if (known.faces_of_file)
        known.faces_of_file = [&](const std::string&, std::string_view) { return FileFaces{family.faces}; };
    const Checked checked = check_design(parse_yaml(example_design(family), source), source, known);
    std::string text = "# " + family.name + ": " + family.summary + "\n";
    text += "# Run:   mesh-gen FILE | solve | postprocess > curve.csv      Check: mesh-gen --check FILE\n";
    text += "# Quantities carry units (3 mm, 40 kPa). A key at its default may be left out.\n";
    text += "# Faces: " + face_list(family) + "\n";
    return text + annotated(checked.items, [](const Item& item) {
               return item.key.meaning + "; " + range_text(item.key) + "; " + default_text(item);
           });
}

std::string explain_design(std::string_view text, std::string_view source, std::span<const FamilyKeys> families,
                           std::span<const Override> overrides) {
    static_cast<void>(read_design(text, source, families, overrides));  // for the checks across keys
    Node root = overridden_design(text, source, families, overrides);
    const FamilyKeys& family = family_of(root, source, families);
    const Checked checked = check_design(std::move(root), source, family);
    return annotated(checked.items, [](const Item& item) {
        return (item.entry.given ? "given at " + item.entry.location : std::string{"default"}) + "; " +
               item.key.meaning;
    });
}

}  // namespace soft::design
