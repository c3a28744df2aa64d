#pragma once
/// The steps of reading, shared by read_design, template_yaml and explain_design. Private to the module.
#include <span>
#include <string>
#include <vector>

#include "design/design.hpp"
#include "design/path.hpp"
#include "design/sections.hpp"

namespace soft::design {

/// Applies the overrides to the tree; the location of an override without one is "--set path".
void override_tree(Node& root, std::span<const Override> overrides);

/// The tree of the design with the overrides applied; overrides of loads may use any alias of a face.
[[nodiscard]] Node overridden_design(std::string_view text, std::string_view source,
                                     std::span<const FamilyKeys> families, std::span<const Override> overrides);

/// The family of a design. Error(bad_input) with the nearest name for an unknown family.
[[nodiscard]] const FamilyKeys& family_of(const Node& root, std::string_view source,
                                          std::span<const FamilyKeys> families);

/// A checked design with all defaults filled in.
struct Checked {
    std::vector<Item> items;
    FaceNames faces;
    std::vector<LoadEntry> loads;
    std::vector<StageEntry> stages;
};
/// `built`: faces of the mesh, instead of those in the file of the shape.
[[nodiscard]] Checked check_design(Node root, std::string_view source, const FamilyKeys& family,
                                   const FileFaces* built = nullptr);
/// The design of checked values.
[[nodiscard]] Design design_of(const Checked& checked, const FamilyKeys& family);

[[nodiscard]] Values values_of(std::span<const Item> items);

/// Warnings, one line each, about valid input that is probably a mistake.
[[nodiscard]] std::vector<std::string> plausibility(const Design& design);

/// The required values of a design of the family, as YAML for a template.
[[nodiscard]] std::string example_design(const FamilyKeys& family);

}  // namespace soft::design
