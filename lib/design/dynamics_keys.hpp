#pragma once
/// The keys of `dynamics`, and the checks of a dynamic design. Private to the module. Tested by design/dynamics_test.
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "design/loads.hpp"

namespace soft::design {

/// Defaults are those of model::Dynamics.
[[nodiscard]] std::vector<Key> dynamics_keys();

/// Whether the tree contains a duration; its value is checked with the other values.
[[nodiscard]] bool is_dynamic(const Node& root);

/// Inputs of the checks of a dynamic design.
struct DynamicParts {
    std::span<const LoadEntry> loads;
    std::span<const Item> items;
    std::string_view formulation;  ///< mesh.formulation; empty where the design has no such key
};
/// The dynamic settings; nullopt without a duration, and the other keys of `dynamics` must then have their defaults. Rejects a material
/// without density; stages, control, end criteria and branches of a static path; supplies other than pressures; prescribed
/// displacements; and an explicit integrator with pressure unknowns.
[[nodiscard]] std::optional<model::Dynamics> dynamics_of(const DynamicParts& parts, const Values& values);

}  // namespace soft::design
