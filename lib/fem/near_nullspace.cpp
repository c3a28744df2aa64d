#include "fem/near_nullspace.hpp"

#include <array>

namespace soft::fem {

namespace {

using Velocity = std::array<double, 3>;

/// Smallest relative remainder of a motion after orthogonalisation; below it the motion depends on the previous ones.
constexpr double min_independent_part = 1e-8;

/// Velocity of a point at `r` from the centre in the rigid motion `number`: translations first, then rotations about x, y, z.
Velocity velocity(int number, const Velocity& r) {
    Velocity v{};
    if (number < 3) {
        v[number] = 1.0;
        return v;
    }
    const int next = (number - 2) % 3, after = (number - 1) % 3;  // e x r for the axis e = number - 3
    v[next] = -r[after];
    v[after] = r[next];
    return v;
}

std::vector<int> motions_of(model::Kinematics kinematics) {
    switch (kinematics) {
        case model::Kinematics::axisymmetric: return {0};
        case model::Kinematics::plane_strain: return {0, 1, 5};
        case model::Kinematics::solid: return {0, 1, 2, 3, 4, 5};
    }
    return {};
}

Velocity middle_of(const mesh::Mesh& mesh) {
    Velocity middle{};
    for (const auto& point : mesh.points)
        for (int i = 0; i < 3; ++i) middle[i] += point[i] / static_cast<double>(mesh.points.size());
    return middle;
}

}  // namespace

std::vector<linalg::Vector> rigid_motions(const System& system) {
    const auto& mesh = system.input().mesh;
    const auto& dofs = system.dofs();
    const Velocity middle = middle_of(mesh);
    std::vector<linalg::Vector> motions;
    for (const int number : motions_of(system.input().kinematics)) {
        linalg::Vector motion = system.make_vector();
        for (std::size_t node = 0; node < mesh.points.size(); ++node) {
            Velocity r{};
            for (int i = 0; i < 3; ++i) r[i] = mesh.points[node][i] - middle[i];
            const Velocity v = velocity(number, r);
            for (int i = 0; i < dofs.dimension; ++i) {
                const PetscInt dof = dofs.displacement[node * dofs.dimension + i];
                if (dof >= dofs.begin && dof < dofs.end) SOFT_PETSC(VecSetValue(motion, dof, v[i], INSERT_VALUES));
            }
        }
        SOFT_PETSC(VecAssemblyBegin(motion));
        SOFT_PETSC(VecAssemblyEnd(motion));
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
