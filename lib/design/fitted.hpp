#pragma once
/// What a design says of the data behind its constants: material.fit, as fit-material writes it. Held by
/// design/material_library_test.
#include <optional>
#include <string>
#include <string_view>

namespace soft::design {

/// What to say of a path whose largest stretch is `stretch`: that it leaves the data of the constants (the I1 of a
/// principal stretch l is at least l^2 + 2/l, that of uniaxial tension), or that a set of the library over a narrower
/// range covers it. nullopt where there is nothing to say or the design has no material.fit.
[[nodiscard]] std::optional<std::string> fit_advice(std::string_view effective_yaml, double stretch);

}  // namespace soft::design
