#pragma once
/// The keys of `dynamics`, and what a dynamic design cannot have. Private to the module. Tested by design/dynamics_test.
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "design/loads.hpp"

namespace soft::design {

/// Defaults are those of model::Dynamics.
[[nodiscard]] std::vector<Key> dynamics_keys();

/// Whether the tree gives a duration; what it is worth is checked with the other values.
[[nodiscard]] bool is_dynamic(const Node& root);

/// What the checks of a dynamic design look at.
struct DynamicParts {
    std::span<const LoadEntry> loads;
    std::span<const Item> items;
    std::string_view formulation;  ///< mesh.formulation; empty where the design has no such key
};
/// nullopt without a duration; then the other keys of `dynamics` must be at their defaults. Refuses a rubber without density,
/// stages, a control, an end or a branch of a static path, supplies other than pressures, prescribed motions, and pressure
/// unknowns under an explicit integrator.
[[nodiscard]] std::optional<model::Dynamics> dynamics_of(const DynamicParts& parts, const Values& values);

}  // namespace soft::design
