#pragma once
/// The description of the test data behind the material constants of a design: material.fit, as written by fit-material.
/// Tested by design/material_library_test.
#include <optional>
#include <string>
#include <string_view>

#include "design/design.hpp"

namespace soft::design {

struct FittedMaterial {
    std::string name;  ///< name in the material library; empty for user-supplied constants
    std::string law;
    std::string range;      ///< "4.46:109.091 %", of engineering strain
    std::string max_error;  ///< "4.2 %" of the stress, at strains of 20 % and more; empty if not stated
    double max_I1 = 3;      ///< of the data

    /// Whether a principal stretch lies within the data. I1 of a stretch l is at least l^2 + 2/l, the value of uniaxial tension.
    [[nodiscard]] bool covers(double stretch) const { return stretch * stretch + 2.0 / stretch <= max_I1; }
};

/// The fit of one section of the design, "material" or "materials.<name>"; nullopt without fit.max_I1.
[[nodiscard]] std::optional<FittedMaterial> fitted_material(std::string_view effective_yaml,
                                                            std::string_view section = "material");

/// A warning for a path whose largest stretch is `stretch`: the stretch exceeds the data of the constants, or a set of the library
/// with a narrower range covers it. nullopt if neither applies.
[[nodiscard]] std::optional<std::string> fit_range_advice(std::string_view effective_yaml, double stretch);

}  // namespace soft::design
