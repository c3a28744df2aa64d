#pragma once
/// The scalar fields available for output, by name. One table feeds options, colour bars and the report.
/// Tested by post/quantity_test.
#include <span>
#include <string_view>
#include <vector>

#include "post/step_fields.hpp"

namespace soft::post {

enum class Quantity { stretch, von_mises, pressure, displacement, energy, jacobian, contact_pressure };

struct QuantityInfo {
    Quantity quantity;
    std::string_view name;   ///< "von-mises", as --field takes it
    std::string_view label;  ///< "von Mises stress", for colour bars
    std::string_view unit;   ///< "kPa"; empty for pure numbers
    double SI_per_unit;
    std::string_view meaning;  ///< one sentence
};

/// In the order of the enumeration.
[[nodiscard]] std::span<const QuantityInfo> quantities();
[[nodiscard]] const QuantityInfo& info(Quantity quantity);
/// Throws Error(usage, location "--field") for an unknown name.
[[nodiscard]] Quantity quantity_from_name(std::string_view name);

/// Whether it is a stress, or the energy.
[[nodiscard]] bool needs_stress(Quantity quantity);
/// Whether the case has the quantity: energy requires that all laws have an energy function, contact pressure that something can touch.
[[nodiscard]] bool is_available(Quantity quantity, const model::Case& model);

/// SI values, one per region point. Throws Error(bad_input, location "--field") for a quantity that the case does not have.
[[nodiscard]] std::vector<double> nodal_values(Quantity quantity, const model::Case& model,
                                               const RegionPoints& region_points, const NodalState& state,
                                               const StepFields& fields);

}  // namespace soft::post
