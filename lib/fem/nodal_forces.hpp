#pragma once
/// Quantities that do not depend on the state: means over faces, and forces that stay fixed in space.
/// Every rank gets the whole vector. All throw Error (bad_input) for a face that the mesh does not have.
/// Tested by fem/system_test, fem/loads_test.
#include <span>
#include <string>
#include <vector>

#include "fem/discretization.hpp"
#include "math/vector.hpp"

namespace soft::fem {

/// Weights w with sum w_i x_i = area average over the undeformed face of the displacement along `direction`.
[[nodiscard]] SparseVector mean_displacement(const model::Case& input, const DofMap& map, const std::string& face,
                                             const Vector3& direction);

/// The same for one point of the undeformed part, by the shape functions of its cell. Throws Error (bad_input) for a point outside the
/// mesh; `name` is that of the output.
[[nodiscard]] SparseVector point_displacement(const model::Case& input, const DofMap& map, const std::string& name,
                                              const mesh::Point& point, const Vector3& direction);

/// Forces at nodes, including constrained nodes.
struct NodalForces {
    std::vector<mesh::Index> nodes;
    std::vector<Vector3> forces_N;
};
/// The forces at components that are not fixed.
[[nodiscard]] SparseVector on_unknowns(const NodalForces& forces, const DofMap& map);

/// Nodal forces of a dead load at level 1: the sum of forces times displacements is its work [J].
///   traction, force: int N_a traction dA over the undeformed face     gravity: int N_a density acceleration dV
/// Throws Error (bad_input) for gravity and a material without density.
[[nodiscard]] NodalForces dead_force(const Discretization& fe, const model::DeadLoad& load);

/// Thrust per unit pressure on the plugs of a load's openings (fem/loads.hpp); none if it is not sealed or a fixture
/// carries them (PressureLoad::plug_thrust).
[[nodiscard]] NodalForces plug_force(const model::Case& input, const model::PressureLoad& load);

}  // namespace soft::fem
