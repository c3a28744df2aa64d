#pragma once
/// The constitutive laws and the silicones of the material library, for `mesh-gen --list-materials` and docs/reference/materials.md.
/// Tested by cli/material_list_test and tests/docs.
#include <string>

namespace soft::design {

enum class LawListStyle {
    plain,     ///< for a terminal, at most 120 columns
    markdown,  ///< sections from level two, for the reference page
};

/// Every law of material::laws() with its energy, use, source and parameters (unit, range, meaning), and the silicones by name; their
/// constants in Markdown only.
[[nodiscard]] std::string law_list(LawListStyle style);

}  // namespace soft::design
