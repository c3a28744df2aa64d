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
    std::string range;      ///< "4.46:109.091 %", of engineering strain
    double largest_I1 = 3;  ///< of the data

    /// Whether a principal stretch lies within the data: the I1 of a stretch l is at least l^2 + 2/l, that of uniaxial tension.
    [[nodiscard]] bool holds(double stretch) const { return stretch * stretch + 2.0 / stretch <= largest_I1; }
};

/// nullopt for a design without material.fit.largest_I1.
[[nodiscard]] std::optional<FittedMaterial> fitted_material(std::string_view effective_yaml);

/// What to say of a path whose largest stretch is `stretch`: that it leaves the data of the constants, or that a set of the
/// library over a narrower range covers it. nullopt where there is nothing to say.
[[nodiscard]] std::optional<std::string> fit_advice(std::string_view effective_yaml, double stretch);

/// Another set of the library, which fits the stretch of a path better than the one it was solved with.
struct FittingSet {
    Override change;   ///< to the effective design
    std::string text;  ///< "dragon-skin-20 over 110 % of strain"
    bool is_wider = false;
};

/// The narrowest set whose range covers `stretch` (none does: the widest), where the design names a silicone and leaves the
/// range open; what else it says of the material is kept. nullopt where the set in use is that one, or was asked for.
[[nodiscard]] std::optional<FittingSet> fitting_set(std::string_view effective_yaml, double stretch);

/// Whether an override "path=value" is the change to such a set.
[[nodiscard]] bool is_change_of_set(std::string_view override_text);

}  // namespace soft::design
