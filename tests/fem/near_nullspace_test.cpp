#include "fem/near_nullspace.hpp"

#include <gtest/gtest.h>

#include "sample_cases.hpp"

namespace soft::fem {
namespace {

// Without supports, rigid motions are in the null space of K of the undeformed body.
TEST(NearNullspace, AFreeBodyDoesNotResistItsRigidMotions) {
    for (const bool mixed : {false, true}) {
        auto input = box_case(1, false);
        input.supports.clear();
        input.formulation = mixed ? model::Formulation::mixed : model::Formulation::displacement;
        System system(input, PETSC_COMM_WORLD);
        auto K = system.make_matrix();
        auto x = system.make_vector(), R = system.make_vector();
        (void)system.evaluate(x, no_loads(input), R, K);
        const auto motions = rigid_motions(system);
        ASSERT_EQ(motions.size(), 6u);
        PetscReal size = 0;
        SOFT_PETSC(MatNorm(K, NORM_FROBENIUS, &size));
        for (std::size_t i = 0; i < motions.size(); ++i) {
            SOFT_PETSC(MatMult(K, motions[i], R));
            EXPECT_LT(linalg::norm(R), 1e-13 * size);
            for (std::size_t j = 0; j <= i; ++j)
                EXPECT_NEAR(linalg::dot(motions[i], motions[j]), i == j ? 1.0 : 0.0, 1e-13);
        }
    }
}

TEST(NearNullspace, ASectionHasTheMotionsOfItsPlane) {
    const auto sphere = sphere_case(1, 2);
    EXPECT_EQ(rigid_motions(System(sphere, PETSC_COMM_WORLD)).size(), 1u);  // along the axis
    auto strip = sphere;
    strip.kinematics = model::Kinematics::plane_strain;
    EXPECT_EQ(rigid_motions(System(strip, PETSC_COMM_WORLD)).size(), 3u);
}

TEST(NearNullspace, OmitsAMotionThatTheSupportsPrevent) {
    auto input = box_case(1, false);
    for (const auto& [name, facets] : input.mesh.facet_sets) input.supports.push_back({name, {true, false, false}});
    // Outer nodes are fixed in x and move only in y and z: the rotations about y and z keep these components.
    System system(input, PETSC_COMM_WORLD);
    for (const auto& motion : rigid_motions(system)) EXPECT_NEAR(linalg::norm(motion), 1.0, 1e-13);
}

}  // namespace
}  // namespace soft::fem
