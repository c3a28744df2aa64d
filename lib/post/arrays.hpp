#pragma once
/// All fields of a step as named arrays, for ParaView. Tensors have nine components, row-major, in the coordinates of the mesh
/// (for a section x, r, hoop); directions refer to the current configuration. Tested by post/arrays_test.
#include <vector>

#include "model/named_array.hpp"
#include "post/step_fields.hpp"

namespace soft::post {

/// deformation_gradient, principal_stretches (descending), stretch_direction_1 to _3, J, cauchy_stress_Pa,
/// first_piola_stress_Pa, von_mises_stress_Pa, pressure_Pa (positive in compression), and energy_density_J_m3 if all laws of the
/// case have an energy. One entry per state.
[[nodiscard]] std::vector<model::NamedArray> state_arrays(const model::Case& model, std::span<const LocalState> states);

/// displacement_m at the region points, then contact_pressure_Pa if something can touch, then state_arrays of the nodal states.
[[nodiscard]] std::vector<model::NamedArray> node_arrays(const model::Case& model, const RegionPoints& region_points,
                                                         const NodalState& state, const StepFields& fields);

/// The same with one entry per mesh point: on interfaces the mean over the regions (cell arrays keep the jump), 0 at points that
/// belong to no cell.
[[nodiscard]] std::vector<model::NamedArray> mesh_point_arrays(const model::Case& model,
                                                               const RegionPoints& region_points,
                                                               const NodalState& state, const StepFields& fields);

}  // namespace soft::post
