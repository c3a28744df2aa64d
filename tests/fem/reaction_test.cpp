/// Reactions of constrained faces: derivatives, symmetry planes, and resultants.
#include "fem/reaction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "fem/system.hpp"
#include "model/face_symmetry.hpp"
#include "sample_cases.hpp"
#include "sample_states.hpp"

namespace soft::fem {
namespace {

using model::Measure;

/// A block fixed at one end; the other end moves along x and is free in y and z. Loads of every kind also act on fixed nodes.
model::Case loaded_block() {
    auto input = box_case(2, true);
    input.supports = {{"fixed", {true, true, true}}};
    input.materials[0].density_kg_m3 = 1080;
    input.loads = {{.name = "top", .targets = {"top"}, .gas = {}}};
    input.dead_loads = {{"right", model::DeadLoadKind::traction, {1e4, 2e4, 5e3}},
                        {"gravity", model::DeadLoadKind::gravity, {3, -9, -300}}};
    input.motions = {{"end", {2e-3, std::nullopt, std::nullopt}}};
    input.outputs = {{"push", "fixed", {0.6, 0, 0.8}, Measure::force},
                     {"turn", "fixed", {0, 1, 0}, Measure::moment},
                     {"pull", "end", {1, 0, 0}, Measure::force},
                     {"tip", "end", {0, 0.6, 0.8}, Measure::moment}};
    return input;
}

const LoadLevels levels{{3e4}, {0.7, 0.9}, {0.5}}, direction{{2e4}, {1.3, -0.4}, {0.8}};

TEST(Reaction, DerivativesByStateAndLoadsAreExact) {
    const auto input = loaded_block();
    System system(input, PETSC_COMM_WORLD);
    const auto x = wavy(system, 4e-5, 0.3), d = wavy(system, 4e-5, 1.1);
    auto gradient = system.make_vector(), there = system.make_vector();
    for (std::size_t output = 0; output < input.outputs.size(); ++output) {
        LoadLevels by_levels;
        system.prescribe(levels);
        const double value = system.outputs().value(output, x, gradient, &by_levels);
        const double slope = linalg::dot(gradient, d) + product(by_levels, direction);
        const auto remainder = [&](double h) {
            linalg::copy(x, there);
            linalg::add(there, h, d);
            system.prescribe(moved(levels, h, direction));
            return std::abs(system.outputs().value(output, there, nullptr) - value - h * slope);
        };
        EXPECT_NEAR(remainder(0.05) / remainder(0.025), 4.0, 0.3) << input.outputs[output].name;
    }
}

/// Sum of all nodal forces of R, without any constraint.
Vector3 total_force(model::Case input, const LoadLevels& at, const std::vector<double>& displacement_m) {
    input.supports.clear();
    input.motions.clear();
    input.outputs.clear();
    LoadLevels loads = at;
    loads.motions.clear();
    System free(input, PETSC_COMM_WORLD);
    auto x = free.make_vector(), R = free.make_vector();
    free.fields().spread(displacement_m, x);
    free.evaluate(x, loads, R, nullptr);
    Vector3 sum{};
    const PetscScalar* values = nullptr;
    SOFT_PETSC(VecGetArrayRead(R, &values));
    for (std::size_t node = 0; node < input.mesh.points.size(); ++node)
        for (std::size_t i = 0; i < 3; ++i) sum[i] -= values[free.dofs().displacement[3 * node + i]];
    SOFT_PETSC(VecRestoreArrayRead(R, &values));
    return sum;
}

// Internal forces of any state sum to zero, so that the residual of the free nodes plus the reactions equals the loads.
TEST(Reaction, OfAllNodesIsTheResultantOfTheLoadsInAnyState) {
    auto input = loaded_block();
    input.mesh.facet_sets["skin"];
    for (const char* face : {"fixed", "end", "left", "bottom", "right", "top"})
        for (const auto& facet : input.mesh.facet_sets.at(face)) input.mesh.facet_sets["skin"].push_back(facet);
    input.supports = {{"skin", {true, true, true}}};  // every node but the inner ones
    input.motions.clear();
    input.outputs.clear();
    for (std::size_t i = 0; i < 3; ++i) {
        model::Output output{std::string{"xyz"[i]}, "skin", {}, Measure::force};
        output.direction[i] = 1;
        input.outputs.push_back(output);
    }
    System system(input, PETSC_COMM_WORLD);
    const auto x = system.make_vector();
    LoadLevels at = levels;
    at.motions.clear();
    system.prescribe(at);
    const Vector3 total = total_force(input, at, std::vector(3 * input.mesh.points.size(), 0.0));
    // The mean pressure of the undeformed mixed cells is 0, so the only force at free inner nodes is their weight.
    auto R = system.make_vector();
    system.evaluate(x, at, R, nullptr);
    Vector3 inner{};
    const PetscScalar* values = nullptr;
    SOFT_PETSC(VecGetArrayRead(R, &values));
    for (std::size_t node = 0; node < input.mesh.points.size(); ++node)
        for (std::size_t i = 0; i < 3; ++i)
            if (const auto dof = system.dofs().displacement[3 * node + i]; dof >= 0) inner[i] -= values[dof];
    SOFT_PETSC(VecRestoreArrayRead(R, &values));
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(system.outputs().value(i, x, nullptr) + inner[i], total[i], 1e-12 * std::abs(total[i]));
}

// Half of the block, mirrored at y = 0, gives the whole face and the whole force.
TEST(Reaction, OfAHalfModelIsThatOfTheWhole) {
    auto half = box_case(2, true);
    half.symmetry_planes = {false, true, false};
    half.model_fraction = 0.5;
    const auto fixed = model::face_symmetry(half.mesh, {half.kinematics, half.symmetry_planes}, "fixed");
    EXPECT_EQ(fixed.copies, 2);
    EXPECT_EQ(fixed.mirrored, (std::array<bool, 3>{false, true, false}));
    EXPECT_EQ(model::uncancelled_force(fixed, {1, 2, 3}), (Vector3{1, 0, 3}));
    EXPECT_EQ(model::uncancelled_moment(fixed, {1, 2, 3}), (Vector3{0, 2, 0}));
    const model::ModelSymmetry cuts{half.kinematics, half.symmetry_planes};
    EXPECT_EQ(model::face_symmetry(half.mesh, cuts, "right").copies, 1);  // its image is another face
    EXPECT_EQ(model::face_symmetry(half.mesh, cuts, "left").copies, 1);   // it lies in the plane
    EXPECT_THROW((void)model::face_symmetry(half.mesh, cuts, "no face"), Error);
}

/// A block on rollers under a pressure on its top: only the bottom is fixed in z, "left" in y, "fixed" in x.
model::Case block_on_rollers(int n) {
    auto input = box_case(n, true);
    input.supports = {
        {"fixed", {true, false, false}}, {"left", {false, true, false}}, {"bottom", {false, false, true}}};
    input.loads = {{.name = "top", .targets = {"top"}, .gas = {}}};
    return input;
}

// Faces that share an edge with the bottom slide along z: the reaction at the edge does not belong to them.
TEST(Reaction, ExcludesThatOfNeighbouringFaces) {
    for (const int n : {1, 2}) {
        auto input = block_on_rollers(n);
        input.outputs = {{"fixed_z", "fixed", {0, 0, 1}, Measure::force},
                         {"bottom_z", "bottom", {0, 0, 1}, Measure::force},
                         {"bottom_x", "bottom", {1, 0, 0}, Measure::force}};
        System system(input, PETSC_COMM_WORLD);
        const auto x = wavy(system, 4e-5, 0.3);
        system.prescribe({{3e4}, {}, {}});
        EXPECT_EQ(system.outputs().value(0, x, nullptr), 0.0);
        EXPECT_GT(std::abs(system.outputs().value(1, x, nullptr)), 1e-3);  // that of the bottom itself
        EXPECT_EQ(system.outputs().value(2, x, nullptr), 0.0);
    }
}

// The reaction at an edge of two faces fixed in the same components is divided equally: their sum is that of the joined face.
TEST(Reaction, OfFacesWithACommonEdgeSumToThatOfTheirUnion) {
    auto input = loaded_block();
    input.supports = {{"fixed", {true, true, true}}, {"bottom", {true, true, true}}};
    auto& both = input.mesh.facet_sets["both"];
    for (const char* face : {"fixed", "bottom"})
        for (const auto& facet : input.mesh.facet_sets.at(face)) both.push_back(facet);
    input.motions.clear();
    input.outputs.clear();
    for (const char* face : {"fixed", "bottom", "both"})
        input.outputs.push_back({face, face, {0.6, 0, 0.8}, Measure::force});
    System system(input, PETSC_COMM_WORLD);
    const auto x = wavy(system, 4e-5, 0.3);
    LoadLevels at = levels;
    at.motions.clear();
    system.prescribe(at);
    const double sum = system.outputs().value(2, x, nullptr);
    EXPECT_NEAR(system.outputs().value(0, x, nullptr) + system.outputs().value(1, x, nullptr), sum,
                1e-12 * std::abs(sum));
}

TEST(Reaction, RejectsADynamicCase) {
    auto input = loaded_block();
    input.dynamics.emplace();
    EXPECT_THROW(System(input, PETSC_COMM_WORLD), Error);
}

}  // namespace
}  // namespace soft::fem
