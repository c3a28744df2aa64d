#include "post/arrays.hpp"

#include <string>

#include "post/quantity.hpp"

namespace soft::post {

namespace {

using model::NamedArray;

void add(NamedArray& array, std::span<const double> values) {
    array.values.insert(array.values.end(), values.begin(), values.end());
}
void add(NamedArray& array, double value) { array.values.push_back(value); }

NamedArray displacements(const RegionPoints& region_points, const NodalState& state) {
    NamedArray array{"displacement_m", "m", "displacement", 3, {}};
    for (const mesh::Index node : region_points.node)
        add(array, state.displacement_m.subspan(3 * static_cast<std::size_t>(node), 3));
    return array;
}

}  // namespace

std::vector<NamedArray> state_arrays(const model::Case& model, std::span<const LocalState> states) {
    NamedArray F{"deformation_gradient", "1", "F = I + du/dX", 9, {}};
    NamedArray stretches{"principal_stretches", "1", "principal stretches, descending", 3, {}};
    std::vector<NamedArray> directions;
    for (int a = 1; a <= 3; ++a)
        directions.push_back({"stretch_direction_" + std::to_string(a),
                              "1",
                              "unit vector in the current configuration along principal stretch " + std::to_string(a),
                              3,
                              {}});
    NamedArray J{"J", "1", "ratio of current to undeformed volume", 1, {}};
    NamedArray cauchy{"cauchy_stress_Pa", "Pa", "force per current area", 9, {}};
    NamedArray piola{"first_piola_stress_Pa", "Pa", "force per undeformed area", 9, {}};
    NamedArray von_mises{"von_mises_stress_Pa", "Pa", "of the Cauchy stress", 1, {}};
    NamedArray pressure{"pressure_Pa", "Pa", "minus the mean Cauchy stress", 1, {}};
    NamedArray energy{"energy_density_J_m3", "J/m3", "stored energy per undeformed volume", 1, {}};
    for (const LocalState& state : states) {
        const PrincipalStretches principal = principal_stretches(state.deformation_gradient);
        add(F, state.deformation_gradient);
        add(stretches, principal.stretch);
        for (std::size_t a = 0; a < 3; ++a) add(directions[a], principal.direction[a]);
        add(J, state.jacobian);
        add(cauchy, state.cauchy_Pa);
        add(piola, state.first_piola_Pa);
        add(von_mises, von_mises_Pa(state.cauchy_Pa));
        add(pressure, pressure_Pa(state.cauchy_Pa));
        add(energy, state.energy_J_m3);
    }
    std::vector<NamedArray> arrays{F, stretches, directions[0], directions[1], directions[2],
                                   J, cauchy,    piola,         von_mises,     pressure};
    if (has_energy(model)) arrays.push_back(energy);
    return arrays;
}

std::vector<NamedArray> node_arrays(const model::Case& model, const RegionPoints& region_points,
                                    const NodalState& state, const StepFields& fields) {
    std::vector<NamedArray> arrays{displacements(region_points, state)};
    if (is_available(Quantity::contact_pressure, model))
        arrays.push_back({"contact_pressure_Pa", "Pa", std::string{info(Quantity::contact_pressure).meaning}, 1,
                          nodal_values(Quantity::contact_pressure, model, region_points, state, fields)});
    for (NamedArray& array : state_arrays(model, fields.nodes)) arrays.push_back(std::move(array));
    return arrays;
}

std::vector<NamedArray> mesh_point_arrays(const model::Case& model, const RegionPoints& region_points,
                                          const NodalState& state, const StepFields& fields) {
    const std::size_t points = model.mesh.points.size();
    std::vector<double> shares(points, 0.0);
    for (const mesh::Index node : region_points.node) shares[static_cast<std::size_t>(node)] += 1.0;
    std::vector<NamedArray> arrays = node_arrays(model, region_points, state, fields);
    for (NamedArray& array : arrays) {
        const auto n = static_cast<std::size_t>(array.components);
        std::vector<double> merged(points * n, 0.0);
        for (std::size_t k = 0; k < region_points.size(); ++k) {
            const auto node = static_cast<std::size_t>(region_points.node[k]);
            for (std::size_t i = 0; i < n; ++i) merged[node * n + i] += array.values[k * n + i] / shares[node];
        }
        array.values = std::move(merged);
    }
    return arrays;
}

}  // namespace soft::post
