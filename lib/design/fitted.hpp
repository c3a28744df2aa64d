#pragma once
/// What a design says of the data behind its constants: material.fit, as fit-material writes it. Held by
/// design/material_library_test.
#include <optional>
#include <string>
#include <string_view>

#include "design/design.hpp"

namespace soft::design {

struct FittedMaterial {
    std::string name;  ///< of the library; empty for constants of one's own
    std::string law;
    std::string range;          ///< "4.46:109.091 %", of engineering strain
    std::string max_error;  ///< "4.2 %" of the stress, at 20 % of strain and beyond; empty where it is not stated
    double max_I1 = 3;      ///< of the data

    /// Whether a principal stretch lies within the data: the I1 of a stretch l is at least l^2 + 2/l, that of uniaxial tension.
    [[nodiscard]] bool holds(double stretch) const { return stretch * stretch + 2.0 / stretch <= max_I1; }
};

/// Of one section of the design, "material" or "materials.<name>"; nullopt for one without fit.max_I1.
[[nodiscard]] std::optional<FittedMaterial> fitted_material(std::string_view effective_yaml,
                                                            std::string_view section = "material");

/// What to say of a path whose largest stretch is `stretch`: that it leaves the data of the constants, or that a set of the
/// library over a narrower range covers it. nullopt where there is nothing to say.
[[nodiscard]] std::optional<std::string> fit_advice(std::string_view effective_yaml, double stretch);

}  // namespace soft::design
