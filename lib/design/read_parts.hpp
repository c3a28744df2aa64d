#pragma once
/// The steps of reading, shared by read_design, template_yaml and explain_design. Private to the module.
#include <span>
#include <string>
#include <vector>

#include "design/design.hpp"
#include "design/path.hpp"
#include "design/sections.hpp"

namespace soft::design {

/// Puts the overrides into the tree; their places are "--set path" where they have none of their own.
void override_tree(Node& root, std::span<const Override> overrides);

/// The design's tree with the overrides in it, those of loads under any name of the face.
[[nodiscard]] Node overridden_design(std::string_view text, std::string_view source,
                                     std::span<const FamilyKeys> families, std::span<const Override> overrides);

/// The family a design names; Error(bad_input) with the nearest name.
[[nodiscard]] const FamilyKeys& family_of(const Node& root, std::string_view source,
                                          std::span<const FamilyKeys> families);

/// Everything checked, defaults filled in.
struct Checked {
    std::vector<Item> items;
    FaceNames faces;
    std::vector<LoadEntry> loads;
    std::vector<StageEntry> stages;
};
[[nodiscard]] Checked check_design(Node root, std::string_view source, const FamilyKeys& family);

[[nodiscard]] Values values_of(std::span<const Item> items);

/// One line each, for what is allowed but most likely a slip.
[[nodiscard]] std::vector<std::string> plausibility(const Design& design);

/// Required values a family's design needs besides its geometry, as YAML for a template.
[[nodiscard]] std::string example_design(const FamilyKeys& family);

}  // namespace soft::design
