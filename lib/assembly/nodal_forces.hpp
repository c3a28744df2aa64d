#pragma once
/// Vectors on the unknowns that do not depend on the state: means over faces, and forces that stay fixed in space.
/// Every rank gets the whole vector. Entries of moved components keep their negative number (dof_map.hpp).
/// Held by assembly/system_test, assembly/loads_test.
#include <array>
#include <span>
#include <string>
#include <vector>

#include "assembly/dof_map.hpp"
#include "model/case.hpp"

namespace soft::assembly {

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
/// Throws Error (bad_input) for a face the mesh lacks; so do the functions below.
[[nodiscard]] FaceWeights face_weights(const model::Case& input, const std::string& face);

/// Weights w with sum w_i x_i = area mean over the undeformed face of the displacement along `direction`.
[[nodiscard]] SparseVector mean_displacement(const model::Case& input, const DofMap& map, const std::string& face,
                                             const std::array<double, 3>& direction);

/// Nodal forces of a dead traction [Pa] on a face: sum of f_i x_i is its work [J].
[[nodiscard]] SparseVector face_force(const model::Case& input, const DofMap& map, const std::string& face,
                                      const std::array<double, 3>& traction_Pa);

/// Nodal forces int N_a density acceleration dV. Throws Error (bad_input) for a material without density.
[[nodiscard]] SparseVector body_force(const model::Case& input, const DofMap& map,
                                      std::span<const element::ReferenceCell> references, const model::BodyForce& force);

}  // namespace soft::assembly
