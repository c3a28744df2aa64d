#pragma once
/// The table of the laws for people: `mesh-gen --list-materials` and the section of the README that a test holds to it.
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
