#include "fem/near_nullspace.hpp"

#include "fem/rigid_motion.hpp"

namespace soft::fem {

namespace {

/// Smallest relative remainder of a motion after orthogonalisation; below it the motion depends on the previous ones.
constexpr double min_independent_part = 1e-8;

Vector3 middle_of(const mesh::Mesh& mesh) {
    Vector3 middle{};
    for (const auto& point : mesh.points)
        for (int i = 0; i < 3; ++i) middle[i] += point[i] / static_cast<double>(mesh.points.size());
    return middle;
}

}  // namespace

std::vector<linalg::Vector> rigid_motions(const System& system) {
    const auto& mesh = system.input().mesh;
    const auto& dofs = system.dofs();
    const Vector3 middle = middle_of(mesh);
    std::vector<linalg::Vector> motions;
    for (const RigidMode& mode : rigid_modes(system.input().kinematics)) {
        linalg::Vector motion = system.make_vector();
        for (std::size_t node = 0; node < mesh.points.size(); ++node) {
            const Vector3 v = mode.velocity(difference(mesh.points[node], middle));
            for (int i = 0; i < dofs.dimension; ++i) {
                const PetscInt dof = dofs.displacement[node * dofs.dimension + i];
                if (dof >= dofs.begin && dof < dofs.end) SOFT_PETSC(VecSetValue(motion, dof, v[i], INSERT_VALUES));
            }
        }
        linalg::assemble(motion);
        const double size = linalg::norm(motion);
        for (const auto& before : motions) linalg::add(motion, -linalg::dot(before, motion), before);
        const double remainder = linalg::norm(motion);
        if (!(remainder > min_independent_part * size)) continue;
        SOFT_PETSC(VecScale(motion, 1.0 / remainder));
        motions.push_back(std::move(motion));
    }
    return motions;
}

void attach_rigid_motions(const System& system, Mat K) {
    const auto motions = rigid_motions(system);
    std::vector<Vec> vectors;
    for (const auto& motion : motions) vectors.push_back(motion.get());
    linalg::NullSpace space;
    SOFT_PETSC(MatNullSpaceCreate(system.comm(), PETSC_FALSE, static_cast<PetscInt>(vectors.size()), vectors.data(),
                                  space.out()));
    SOFT_PETSC(MatSetNearNullSpace(K, space));
}

}  // namespace soft::fem
