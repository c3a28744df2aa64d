#pragma once
/// Quantities that do not depend on the state: means over faces, and forces that stay fixed in space.
/// Every rank gets the whole vector. Entries of prescribed components keep their negative index (dof_map.hpp).
/// Tested by fem/system_test, fem/loads_test.
#include <array>
#include <span>
#include <string>
#include <vector>

#include "fem/dof_map.hpp"
#include "model/case.hpp"

namespace soft::fem {

struct SparseVector {
    std::vector<PetscInt> dofs;
    std::vector<double> values;
};

/// Nodes of a face with int N_a dA over the undeformed face; their sum is its area. Ascending by node.
struct FaceWeights {
    std::vector<mesh::Index> nodes;
    std::vector<double> weights_m2;
    double area_m2 = 0;
};
/// Throws Error (bad_input) for a face that the mesh does not have; so do the functions below.
[[nodiscard]] FaceWeights face_weights(const model::Case& input, const std::string& face);

/// Weights w with sum w_i x_i = area average over the undeformed face of the displacement along `direction`.
[[nodiscard]] SparseVector mean_displacement(const model::Case& input, const DofMap& map, const std::string& face,
                                             const std::array<double, 3>& direction);

/// The same for one point of the undeformed part, by the shape functions of its cell. Throws Error (bad_input) for a point outside the
/// mesh; `name` is that of the output.
[[nodiscard]] SparseVector point_displacement(const model::Case& input, const DofMap& map, const std::string& name,
                                              const mesh::Point& point, const std::array<double, 3>& direction);

/// Forces at nodes, including constrained nodes.
struct NodalForces {
    std::vector<mesh::Index> nodes;
    std::vector<std::array<double, 3>> forces_N;
};
/// The forces at components that are not fixed.
[[nodiscard]] SparseVector on_unknowns(const NodalForces& forces, const DofMap& map);

/// Nodal forces of a dead traction [Pa] on a face: the sum of forces times displacements is its work [J].
[[nodiscard]] NodalForces face_force(const model::Case& input, const std::string& face,
                                     const std::array<double, 3>& traction_Pa);

/// int N_a density acceleration dV. Throws Error (bad_input) for a material without density.
[[nodiscard]] NodalForces body_force(const model::Case& input, std::span<const fem::ReferenceCell> references,
                                     const model::BodyForce& force);

/// Thrust per unit pressure on the plugs of a load's openings (fem/cavity.hpp); none if it is not sealed or a fixture
/// carries them (PressureLoad::plug_thrust).
[[nodiscard]] NodalForces plug_force(const model::Case& input, const model::PressureLoad& load);

}  // namespace soft::fem
