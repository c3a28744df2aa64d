#pragma once
/// From a case's material (law name and constants) to the law the elements run.
#include <variant>

#include "material/law.hpp"
#include "model/case.hpp"

namespace soft::assembly {

using AnyRubber = std::variant<material::Rubber<material::NeoHookean>>;

/// Throws Error (bad_input) for an unknown law, a missing constant or one outside its range.
[[nodiscard]] AnyRubber make_rubber(const model::Material& material);

[[nodiscard]] double initial_shear_modulus_Pa(const AnyRubber& rubber);

}  // namespace soft::assembly
