#include "fem/system.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "sample_cases.hpp"
#include "sample_states.hpp"

namespace soft::fem {
namespace {

/// Bellows-like opening in one solid cell: the box's right side as a cavity wall with a free rim and a plug.
model::Case open_box() {
    auto input = box_case(2, false);
    input.cavities = {{"cavity", "right", {}, {{"end", 2e-5, {1, 0, 0}}}}};
    input.loads = {{.name = "cavity", .targets = {"cavity"}, .gas = {}},
                   {.name = "top", .targets = {"top"}, .gas = {}}};
    return input;
}

/// Every load at this fraction of its full load.
LoadLevels levels_at(const model::Case& input, double share) {
    LoadLevels full{{}, std::vector(input.dead_loads.size(), 1.0), std::vector(input.motions.size(), 1.0)};
    for (std::size_t i = 0; i < input.loads.size(); ++i)
        full.pressures_Pa.push_back((i == 0 ? 0.3 : 0.2) * sample_mu_Pa);
    return moved(no_loads(input), share, full);
}
/// R, and its derivative with respect to the fraction.
void evaluate_at(System& system, Vec x, double share, Vec R, Vec load, Mat K = nullptr) {
    const LoadColumn column{levels_at(system.input(), 1.0), load};
    system.evaluate(x, levels_at(system.input(), share), R, K, {&column, 1});
}

double norm_of_remainder(System& system, Vec x, Vec d, double h, double load_factor) {
    auto R0 = system.make_vector(), R1 = system.make_vector(), load = system.make_vector(), Kd = system.make_vector();
    const auto K = system.make_matrix();
    evaluate_at(system, x, load_factor, R0, load, K);
    SOFT_PETSC(MatMult(K, d, Kd));
    auto there = linalg::duplicate(x);
    linalg::copy(x, there);
    linalg::add(there, h, d);
    evaluate_at(system, there, load_factor, R1, load);
    linalg::add(R1, -1.0, R0);
    linalg::add(R1, -h, Kd);
    return linalg::norm(R1);
}

TEST(System, TangentIsTheDerivativeOfTheResidualWithLoadsAndPlugs) {
    for (auto input : {sphere_case(2, 3), box_case(2, true), open_box()}) {
        System system(input, PETSC_COMM_WORLD);
        const auto x = wavy(system, 2e-5, 0.3), d = wavy(system, 2e-5, 1.1);
        const double quotient = norm_of_remainder(system, x, d, 0.2, 0.7) / norm_of_remainder(system, x, d, 0.1, 0.7);
        EXPECT_NEAR(quotient, 4.0, 0.15);
    }
}

TEST(System, LoadIsTheDerivativeOfTheResidualByTheLoadFactor) {
    const auto input = open_box();
    System system(input, PETSC_COMM_WORLD);
    const auto x = wavy(system, 2e-5, 0.3);
    auto R0 = system.make_vector(), R1 = system.make_vector(), load = system.make_vector();
    evaluate_at(system, x, 0.2, R0, load);
    evaluate_at(system, x, 0.7, R1, load);
    linalg::add(R1, -1.0, R0);
    linalg::add(R1, 0.5, load);
    EXPECT_NEAR(linalg::norm(R1), 0.0, 1e-12 * linalg::norm(load));
}

// Without pressure only the traction acts; every node of the box's end is free.
TEST(System, ForceOfADeadTractionIsItsAreaAndDoesNotFollowTheBody) {
    auto input = box_case(2, true);
    input.loads.clear();
    input.dead_loads = {{"end", model::DeadLoadKind::traction, {3e3, -2e3, 1e3}}};
    System system(input, PETSC_COMM_WORLD);
    auto R = system.make_vector(), load = system.make_vector(), elsewhere = system.make_vector();
    evaluate_at(system, system.make_vector(), 1.0, R, load);
    evaluate_at(system, wavy(system, 2e-4, 0.0), 0.5, R, elsewhere);
    double sum = 0;  // of the x components
    const PetscScalar* values = nullptr;
    SOFT_PETSC(VecGetArrayRead(load, &values));
    for (std::size_t node = 0; node < input.mesh.points.size(); ++node)
        if (const auto dof = system.dofs().displacement[3 * node]; dof >= 0) sum += values[dof];
    SOFT_PETSC(VecRestoreArrayRead(load, &values));
    EXPECT_NEAR(sum, 3e3 * 0.01 * 0.01, 1e-12);
    linalg::add(elsewhere, -1.0, load);
    EXPECT_EQ(linalg::norm(elsewhere), 0.0);
}

TEST(System, ClosedCavityLoadIsThePressureTimesTheVolumeGradient) {
    const auto input = sphere_case(2, 3);
    System system(input, PETSC_COMM_WORLD);
    const auto x = wavy(system, 2e-5, 0.3);
    auto R = system.make_vector(), load = system.make_vector(), gradient = system.make_vector();
    evaluate_at(system, x, 0.0, R, load);
    (void)system.volumes().of_cavity(0, x, gradient);
    // The load acts on the modelled half; the volume is the whole actuator's.
    linalg::add(load, -0.3 * sample_mu_Pa * input.model_fraction, gradient);
    EXPECT_NEAR(linalg::norm(load), 0.0, 1e-12 * sample_mu_Pa * linalg::norm(gradient));
}

TEST(System, VolumeGradientIsTheDerivativeOfTheVolumeWithRims) {
    for (auto input : {sphere_case(2, 3), open_box()}) {
        System system(input, PETSC_COMM_WORLD);
        const auto x = wavy(system, 2e-4, 0.3), d = wavy(system, 2e-4, 1.1);
        auto gradient = system.make_vector(), there = linalg::duplicate(x);
        const double V = system.volumes().of_cavity(0, x, gradient);
        const double slope = linalg::dot(gradient, d);
        const auto remainder = [&](double h) {
            linalg::copy(x, there);
            linalg::add(there, h, d);
            return std::abs(system.volumes().of_cavity(0, there, nullptr) - V - h * slope);
        };
        EXPECT_NEAR(remainder(0.2) / remainder(0.1), 4.0, 0.2);
    }
}

TEST(System, EnclosedVolumeOfTheHalfSphereModelIsThatOfTheWholeSphere) {
    const auto input = sphere_case(1, 16);
    System system(input, PETSC_COMM_WORLD);
    const auto x = system.make_vector();
    const double exact = 4.0 / 3.0 * std::numbers::pi * 1e-6;  // second-order arcs: error O(h^4)
    EXPECT_NEAR(system.volumes().of_cavity(0, x, nullptr) / exact, 1.0, 1e-6);
}

// A flat wall of the box, y = 10 mm, closed by a cap in its own plane: the volume between the wall and the cap is zero,
// but the divergence theorem counts the wall and its flat cap about the origin, which cancel.
TEST(System, AFlatWallWithItsCapEnclosesNoVolume) {
    auto input = open_box();
    System system(input, PETSC_COMM_WORLD);
    const auto x = system.make_vector();
    EXPECT_NEAR(system.volumes().of_cavity(0, x, nullptr), 0.0, 1e-20);
}

TEST(System, OutputIsTheAreaMeanOfTheFacesDisplacement) {
    const auto input = box_case(2, true);
    System system(input, PETSC_COMM_WORLD);
    auto x = system.make_vector();
    // u_x = 0.1 X + 0.5 Y^2 / edge on the end face: mean 0.001 + 0.5 edge / 3.
    for (std::size_t node = 0; node < input.mesh.points.size(); ++node)
        if (const auto dof = system.dofs().displacement[3 * node]; dof >= 0) {
            const auto& X = input.mesh.points[node];
            SOFT_PETSC(VecSetValue(x, dof, 0.1 * X[0] + 0.5 * X[1] * X[1] / 0.01, INSERT_VALUES));
        }
    linalg::assemble(x);
    EXPECT_NEAR(system.outputs().value(0, x, nullptr), 0.001 + 0.5 * 0.01 / 3.0, 1e-15);
}

TEST(System, ReportsTheInvertedCellAndItsJacobian) {
    const auto input = box_case(2, true);
    System system(input, PETSC_COMM_WORLD);
    auto x = system.make_vector(), R = system.make_vector(), load = system.make_vector();
    // Invert the far corner cell.
    const auto nodes = input.mesh.cell_nodes(7);
    for (const auto node : nodes)
        if (input.mesh.point(node)[0] > 0.0099)
            SOFT_PETSC(VecSetValue(x, system.dofs().displacement[3 * node], -0.02, INSERT_VALUES));
    linalg::assemble(x);
    const auto evaluation = system.evaluate(x, no_loads(input), R, nullptr);
    EXPECT_FALSE(evaluation.admissible());
    EXPECT_LT(evaluation.min_jacobian, 0.0);
    EXPECT_GE(evaluation.worst_cell, 0);
    const auto worst = input.mesh.cell_nodes(evaluation.worst_cell);
    EXPECT_TRUE(std::ranges::any_of(worst, [&](auto n) { return std::ranges::find(nodes, n) != nodes.end(); }));
}

TEST(System, StretchSummaryIsExactForAHomogeneousState) {
    const auto input = box_case(1, true);
    System system(input, PETSC_COMM_WORLD);
    auto x = system.make_vector();
    const double l = 1.5, across = 1.0 / std::sqrt(l);
    for (std::size_t node = 0; node < input.mesh.points.size(); ++node)
        for (int i = 0; i < 3; ++i)
            if (const auto dof = system.dofs().displacement[3 * node + i]; dof >= 0)
                SOFT_PETSC(
                    VecSetValue(x, dof, ((i == 0 ? l : across) - 1.0) * input.mesh.points[node][i], INSERT_VALUES));
    linalg::assemble(x);
    const auto summary = system.fields().stretches(x);
    EXPECT_NEAR(summary.p99, l, 1e-12);
    EXPECT_NEAR(summary.largest, l, 1e-12);
    EXPECT_NEAR(summary.min_jacobian, 1.0, 1e-12);
    const double energy = 0.5 * sample_mu_Pa * (l * l + 2.0 / l - 3.0) * 1e-6;  // neo-Hookean, box of 1 cm^3
    EXPECT_NEAR(system.fields().stored_energy(x), energy, 1e-12 * energy);
}

TEST(DofMap, CountsFreeComponentsAndPressures) {
    const auto input = box_case(2, true);  // 125 nodes, three faces of 25 nodes fixed in one component each, 8 cells
    System system(input, PETSC_COMM_WORLD);
    EXPECT_EQ(system.dofs().pressures, 8 * 4);
    EXPECT_EQ(system.dofs().total, 3 * 125 - 3 * 25 + 8 * 4);
}

TEST(System, RejectsUnsupportedCases) {
    auto unknown_face = box_case(1, true);
    unknown_face.supports.push_back({"nowhere", {true, true, true}});
    EXPECT_THROW(System(unknown_face, PETSC_COMM_WORLD), Error);
    auto unknown_law = box_case(1, true);
    unknown_law.materials[0].law = "jelly";
    EXPECT_THROW(System(unknown_law, PETSC_COMM_WORLD), Error);
    auto locking = box_case(1, true);
    locking.formulation = model::Formulation::displacement;
    EXPECT_THROW(System(locking, PETSC_COMM_WORLD), Error);
    // One family of fibres would twist a body of revolution.
    model::Material fibres;
    fibres.constants["families"] = {1.0};
    fibres.fiber_frame = model::FiberFrame::cylindrical;
    using model::Kinematics;
    const std::array<bool, 3> whole{}, half{false, true, false};
    EXPECT_FALSE(model::explain_incompatibility(fibres, Kinematics::axisymmetric, whole).empty());
    EXPECT_TRUE(model::explain_incompatibility(fibres, Kinematics::solid, whole).empty());
    EXPECT_FALSE(model::explain_incompatibility(fibres, Kinematics::solid, half).empty());
    fibres.constants["families"] = {2.0};
    EXPECT_TRUE(model::explain_incompatibility(fibres, Kinematics::axisymmetric, whole).empty());
    EXPECT_TRUE(model::explain_incompatibility(fibres, Kinematics::solid, half).empty());
    fibres.fibers = model::Fibers{0.5, 1e5, 1, 1};
    EXPECT_FALSE(model::explain_incompatibility(fibres, Kinematics::axisymmetric, whole).empty());
    fibres.fibers->angle_rad = 0;  // along the axis: its own mirror image
    EXPECT_TRUE(model::explain_incompatibility(fibres, Kinematics::axisymmetric, whole).empty());
    EXPECT_TRUE(model::explain_incompatibility(fibres, Kinematics::solid, half).empty());
    auto no_material = box_case(1, true);
    no_material.materials.clear();
    EXPECT_THROW(System(no_material, PETSC_COMM_WORLD), Error);
}

}  // namespace
}  // namespace soft::fem
