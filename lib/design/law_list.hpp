#pragma once
/// The table of constitutive laws for `mesh-gen --list-materials` and for the README section that a test compares with it.
/// Tested by cli/material_list_test.
#include <string>

namespace soft::design {

enum class LawListStyle {
    plain,     ///< for a terminal, at most 120 columns
    markdown,  ///< for the README
};

/// Every law of material::laws() with its energy, use, source and parameters (unit, range, meaning).
[[nodiscard]] std::string law_list(LawListStyle style);

}  // namespace soft::design
