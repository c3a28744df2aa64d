/// Mass matrices against volumes and rigid motions.
#include <gtest/gtest.h>

#include <numbers>

#include "block_mesh.hpp"
#include "core/error.hpp"
#include "fem/mass.hpp"

namespace soft::fem {
namespace {

using mesh::CellType;
using model::Formulation;
using model::Kinematics;

constexpr double density = 1080.0;

struct Sample {
    CellType type;
    Kinematics kinematics;
    Formulation formulation;
    double volume_m3;
};

/// The blocks of block_mesh.hpp: unit square (1 m deep), unit cube, ring 1 < r < 2 of length 1.
std::vector<Sample> samples() {
    return {{CellType::quad4, Kinematics::plane_strain, Formulation::displacement, 1.0},
            {CellType::quad9, Kinematics::plane_strain, Formulation::mixed, 1.0},
            {CellType::triangle6, Kinematics::plane_strain, Formulation::mixed, 1.0},
            {CellType::quad9, Kinematics::axisymmetric, Formulation::mixed, 3.0 * std::numbers::pi},
            {CellType::triangle6, Kinematics::axisymmetric, Formulation::displacement, 3.0 * std::numbers::pi},
            {CellType::hex27, Kinematics::solid, Formulation::mixed, 1.0},
            {CellType::tet10, Kinematics::solid, Formulation::mixed, 1.0},
            {CellType::wedge18, Kinematics::solid, Formulation::mixed, 1.0},
            {CellType::hex8, Kinematics::solid, Formulation::f_bar, 1.0}};
}

model::Case body(const Sample& sample) {
    auto input = block_case(sample.type, sample.kinematics, sample.formulation, {.n = 2, .shake = 0.2});
    input.materials[0].density_kg_m3 = density;
    return input;
}

/// A translation with this velocity along the first axis; zero in the pressures.
linalg::Vector translation(const System& system, double velocity) {
    linalg::Vector v = system.make_vector();
    const auto& map = system.dofs();
    for (std::size_t node = 0; node < system.input().mesh.points.size(); ++node)
        if (const auto dof = map.displacement[node * static_cast<std::size_t>(map.dimension)];
            dof >= map.begin && dof < map.end)
            SOFT_PETSC(VecSetValue(v, dof, velocity, INSERT_VALUES));
    linalg::assemble(v);
    return v;
}

TEST(Mass, ATranslationHasTheExactKineticEnergy) {
    for (const auto& sample : samples()) {
        const auto input = body(sample);
        const System system(input, PETSC_COMM_WORLD);
        const auto v = translation(system, 3.0);
        const auto M = consistent_mass(system);
        linalg::Vector momentum = system.make_vector();
        SOFT_PETSC(MatMult(M, v, momentum));
        EXPECT_NEAR(0.5 * linalg::dot(momentum, v) / (0.5 * density * sample.volume_m3 * 9.0), 1.0, 1e-12)
            << int(sample.type);
        SOFT_PETSC(VecPointwiseMult(momentum, lumped_mass(system), v));
        EXPECT_NEAR(0.5 * linalg::dot(momentum, v) / (0.5 * density * sample.volume_m3 * 9.0), 1.0, 1e-12)
            << int(sample.type);
    }
}

TEST(Mass, LumpedMassesArePositiveAndPressuresHaveNone) {
    for (const auto& sample : samples()) {
        const auto input = body(sample);
        const System system(input, PETSC_COMM_WORLD);
        linalg::Vector lumped = lumped_mass(system), mask = displacement_mask(system);
        PetscReal pressures = 0, negative = 0;
        SOFT_PETSC(VecSum(mask, &pressures));
        EXPECT_EQ(system.dofs().total - static_cast<PetscInt>(pressures), system.dofs().pressures) << int(sample.type);
        linalg::Vector signs = linalg::duplicate(lumped);  // mask where the mass is positive
        SOFT_PETSC(VecPointwiseDivide(signs, mask, lumped));
        SOFT_PETSC(VecMin(signs, nullptr, &negative));
        EXPECT_GE(negative, 0.0) << int(sample.type);
        linalg::Vector elsewhere = linalg::duplicate(lumped);
        SOFT_PETSC(VecPointwiseMult(elsewhere, mask, lumped));
        linalg::add(elsewhere, -1.0, lumped);
        EXPECT_EQ(linalg::norm(elsewhere), 0.0) << int(sample.type);
    }
}

// x^2 over the unit square: a quad9 represents it exactly, int rho x^4 dA = rho / 5.
TEST(Mass, TheConsistentMatrixIntegratesSquaresOfQuadraticFields) {
    auto input = block_case(CellType::quad9, Kinematics::plane_strain, Formulation::mixed, {.n = 2, .shake = 0.0});
    input.materials[0].density_kg_m3 = density;
    const System system(input, PETSC_COMM_WORLD);
    linalg::Vector v = system.make_vector(), momentum = system.make_vector();
    const auto& map = system.dofs();
    for (std::size_t node = 0; node < input.mesh.points.size(); ++node)
        if (const auto dof = map.displacement[2 * node]; dof >= map.begin && dof < map.end)
            SOFT_PETSC(VecSetValue(v, dof, input.mesh.points[node][0] * input.mesh.points[node][0], INSERT_VALUES));
    linalg::assemble(v);
    SOFT_PETSC(MatMult(consistent_mass(system), v, momentum));
    EXPECT_NEAR(linalg::dot(momentum, v) / (density / 5.0), 1.0, 1e-12);
}

TEST(Mass, RejectsAMaterialWithoutDensity) {
    auto input = body(samples()[0]);
    input.materials[0].density_kg_m3.reset();
    const System system(input, PETSC_COMM_WORLD);
    EXPECT_THROW((void)consistent_mass(system), Error);
    EXPECT_THROW((void)lumped_mass(system), Error);
}

}  // namespace
}  // namespace soft::fem
