#include "fem/contact.hpp"

#include <gtest/gtest.h>

#include "fem/system.hpp"
#include "sample_cases.hpp"
#include "sample_states.hpp"

namespace soft::fem {
namespace {

/// A box beside a rigid plane, at a distance from its side y = 10 mm.
model::Case box_at_plane(bool incompressible, double gap_m = 0) {
    auto input = box_case(2, incompressible);
    input.obstacles.push_back({"plate", model::Plane{{0, 0.01 + gap_m, 0}, {0, -1, 0}}});
    return input;
}

struct Assembled {
    linalg::Vector R;
    linalg::Matrix K;
};

Assembled assemble(System& system, Vec x) {
    Assembled at{system.make_vector(), system.make_matrix()};
    const auto levels = no_loads(system.input());
    system.evaluate(x, levels, at.R, at.K, {});
    return at;
}

TEST(Contact, TangentIsTheSymmetricDerivativeOfTheResidual) {
    for (const bool incompressible : {false, true}) {
        const auto input = box_at_plane(incompressible);
        System system(input, PETSC_COMM_WORLD);
        const auto x = wavy(system, 2e-5, 0.3), d = wavy(system, 2e-5, 1.1);
        const Assembled at = assemble(system, x);
        PetscBool symmetric = PETSC_FALSE;
        SOFT_PETSC(MatIsSymmetric(at.K, 1e-6 * sample_mu_Pa, &symmetric));
        EXPECT_TRUE(symmetric);
        const auto remainder = [&](double step) {
            auto there = linalg::duplicate(x), change = system.make_vector();
            linalg::copy(x, there);
            linalg::add(there, step, d);
            SOFT_PETSC(MatMult(at.K, d, change));
            const Assembled next = assemble(system, there);
            linalg::add(next.R, -1.0, at.R);
            linalg::add(next.R, -step, change);
            return linalg::norm(next.R);
        };
        EXPECT_TRUE(system.contact().measure(x).touches());
        EXPECT_NEAR(remainder(0.02) / remainder(0.01), 4.0, 0.4);
    }
}

TEST(Contact, NothingActsWithoutTouch) {
    auto input = box_at_plane(false, 1e-3);
    System with(input, PETSC_COMM_WORLD);
    input.obstacles.clear();
    System without(input, PETSC_COMM_WORLD);
    const auto x = wavy(with, 2e-5, 0.3);
    EXPECT_FALSE(with.contact().measure(x).touches());
    const auto R = assemble(with, x).R;
    linalg::add(R, -1.0, assemble(without, x).R);
    EXPECT_EQ(linalg::norm(R), 0.0);
}

TEST(Contact, OutputsTheDisplacementOfAnObstacle) {
    auto input = box_at_plane(false, 1e-3);
    input.obstacles.push_back({"another", model::Plane{{0.02, 0, 0}, {-1, 0, 0}}});
    input.motions = {{"another", {1e-4, 0.0, 0.0}}, {"plate", {3e-4, -4e-4, 0.0}}};
    model::Output way{"way", "", {0.6, -0.8, 0}, model::Measure::displacement, "", {}, "plate"};
    input.outputs = {way};
    System system(input, PETSC_COMM_WORLD);
    auto levels = no_loads(input);
    levels.motions = {0.7, 0.5};
    system.prescribe(levels);
    const auto x = wavy(system, 2e-5, 0.3), gradient = system.make_vector();
    LoadLevels by_levels = no_loads(input);
    EXPECT_NEAR(system.outputs().value(0, x, gradient, &by_levels), 0.5 * 5e-4, 1e-18);
    EXPECT_EQ(linalg::norm(gradient), 0.0);
    EXPECT_EQ(by_levels.motions[0], 0.0);
    EXPECT_NEAR(by_levels.motions[1], 5e-4, 1e-18);
}

}  // namespace
}  // namespace soft::fem
