#include "post/quantity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/text.hpp"
#include "post/contact_pressure.hpp"

namespace soft::post {

namespace {

constexpr std::array<QuantityInfo, 7> table{{
    {Quantity::stretch, "stretch", "largest principal stretch", "", 1.0,
     "ratio of current to undeformed length in the direction where it is largest"},
    {Quantity::von_mises, "von-mises", "von Mises stress", "kPa", 1e3,
     "sqrt(3/2 s : s) of the deviatoric Cauchy stress s"},
    {Quantity::pressure, "pressure", "pressure in the rubber", "kPa", 1e3,
     "minus the mean Cauchy stress: positive in compression"},
    {Quantity::displacement, "displacement", "displacement", "mm", 1e-3, "magnitude of the displacement vector"},
    {Quantity::energy, "energy", "energy density", "kJ/m^3", 1e3, "stored energy per undeformed volume"},
    {Quantity::jacobian, "J", "volume ratio J", "", 1.0, "ratio of current to undeformed volume"},
    {Quantity::contact_pressure, "contact-pressure", "contact pressure", "kPa", 1e3,
     "force per deformed area of surfaces that touch each other or an obstacle"},
}};

double value_of(Quantity quantity, const LocalState& state) {
    switch (quantity) {
        case Quantity::stretch: return principal_stretches(state.deformation_gradient).stretch[0];
        case Quantity::von_mises: return von_mises_Pa(state.cauchy_Pa);
        case Quantity::pressure: return pressure_Pa(state.cauchy_Pa);
        case Quantity::energy: return state.energy_J_m3;
        case Quantity::jacobian: return state.jacobian;
        case Quantity::displacement:
        case Quantity::contact_pressure: break;  // not part of LocalState; see nodal_values
    }
    return 0.0;
}

}  // namespace

std::span<const QuantityInfo> quantities() { return table; }

const QuantityInfo& info(Quantity quantity) { return table[static_cast<std::size_t>(quantity)]; }

Quantity quantity_from_name(std::string_view name) {
    std::vector<std::string> known;
    for (const QuantityInfo& entry : table) {
        if (entry.name == name) return entry.quantity;
        known.emplace_back(entry.name);
    }
    throw Error(ExitCode::usage, "--field", core::quoted(name) + " is not a field", core::did_you_mean(name, known));
}

bool needs_stress(Quantity quantity) {
    return quantity == Quantity::von_mises || quantity == Quantity::pressure || quantity == Quantity::energy;
}

bool is_available(Quantity quantity, const model::Case& model) {
    if (quantity == Quantity::contact_pressure) return has_contact(model);
    return quantity != Quantity::energy || has_energy(model);
}

std::vector<double> nodal_values(Quantity quantity, const model::Case& model, const RegionPoints& region_points,
                                 const NodalState& state, const StepFields& fields) {
    if (!is_available(quantity, model))
        throw Error(ExitCode::bad_input, "--field",
                    quantity == Quantity::energy ? "a material law of this case has no energy function"
                                                 : "this case has no obstacles, and path.contact is not solve",
                    "choose another field");
    if (!fields.stress_is_known && needs_stress(quantity))
        throw Error(
            ExitCode::bad_input, "--field",
            "the stress of inelastic rubber depends on all rows before, which are not stored (in a motion never)",
            "use stretch or displacement, or solve a static path with --fields all");
    std::vector<double> values(region_points.size());
    if (quantity == Quantity::contact_pressure) {
        const auto pressures_Pa = contact_pressures_Pa(model, state);
        for (std::size_t k = 0; k < values.size(); ++k)
            values[k] = pressures_Pa[static_cast<std::size_t>(region_points.node[k])];
        return values;
    }
    for (std::size_t k = 0; k < values.size(); ++k) {
        const double* u = &state.displacement_m[3 * static_cast<std::size_t>(region_points.node[k])];
        values[k] =
            quantity == Quantity::displacement ? std::hypot(u[0], u[1], u[2]) : value_of(quantity, fields.nodes[k]);
    }
    return values;
}

}  // namespace soft::post
