/// Loads other than pressures, and outputs other than displacements.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "fem/rigid_motion.hpp"
#include "fem/system.hpp"
#include "sample_cases.hpp"
#include "sample_states.hpp"

namespace soft::fem {
namespace {

/// The box with its end moved along x and y and a pressure on its top.
model::Case moved_box() {
    auto input = box_case(2, true);
    input.loads = {{.name = "top", .targets = {"top"}, .gas = {}}};
    input.motions = {{"end", {2e-3, 5e-4, std::nullopt}}};
    // The plane y = 0 is fixed in y and shares nodes with the end, which moves in y.
    std::erase_if(input.supports, [](const model::Support& support) { return support.face == "left"; });
    return input;
}

LoadLevels levels_of(double pressure_Pa, double motion) { return {{pressure_Pa}, {}, {motion}}; }

TEST(Motion, ColumnIsTheDerivativeOfTheResidualByTheLevel) {
    const auto input = moved_box();
    System system(input, PETSC_COMM_WORLD);
    const auto x = wavy(system, 2e-5, 0.3);
    const auto matrix = system.make_matrix();
    auto column = system.make_vector(), R = system.make_vector(), ahead = system.make_vector(),
         behind = system.make_vector();
    const LoadColumn wanted{levels_of(0.0, 1.0), column};
    const double p = 0.3 * sample_mu_Pa;
    system.evaluate(x, levels_of(p, 0.4), R, matrix, {&wanted, 1});
    // Central difference of R: its error falls by 4 when h is halved.
    const auto error = [&](double h) {
        system.evaluate(x, levels_of(p, 0.4 + h), ahead, nullptr);
        system.evaluate(x, levels_of(p, 0.4 - h), behind, nullptr);
        linalg::add(ahead, -1.0, behind);
        linalg::add(ahead, 2.0 * h, column);  // the column is -dR
        return linalg::norm(ahead) / (2.0 * h);
    };
    EXPECT_LT(error(0.01), 1e-2 * linalg::norm(column));
    EXPECT_NEAR(error(0.2) / error(0.1), 4.0, 0.3);
}

TEST(Motion, FieldsAndOutputsIncludeMovedNodes) {
    const auto input = moved_box();
    System system(input, PETSC_COMM_WORLD);
    const auto x = system.make_vector();
    system.prescribe(levels_of(0.0, 0.5));
    EXPECT_NEAR(system.outputs().value(0, x, nullptr), 1e-3, 1e-15);  // all of the end, half way
    LoadLevels by_levels;
    (void)system.outputs().value(0, x, nullptr, &by_levels);
    EXPECT_NEAR(by_levels.motions[0], 2e-3, 1e-15);
    const auto fields = system.fields().gather(x);
    for (std::size_t node = 0; node < input.mesh.points.size(); ++node)
        EXPECT_NEAR(fields.displacement_m[3 * node + 1], input.mesh.points[node][0] > 0.0099 ? 2.5e-4 : 0.0, 1e-15);
}

TEST(Motion, RejectsAComponentThatIsFixedAndPrescribed) {
    auto input = moved_box();
    input.supports.push_back({"left", {false, true, false}});
    try {
        System system(input, PETSC_COMM_WORLD);
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("over-constrained"), std::string::npos);
        EXPECT_EQ(error.code(), ExitCode::bad_input);
    }
    input = moved_box();
    input.motions.push_back({"top", {1e-3, std::nullopt, std::nullopt}});  // shares an edge with the end
    EXPECT_THROW(System(input, PETSC_COMM_WORLD), Error);
}

TEST(Motion, PreventsRigidMotionsLikeASupport) {
    auto input = moved_box();
    input.supports = {{"bottom", {false, true, true}}, {"left", {false, true, false}}};
    input.motions = {{"end", {2e-3, std::nullopt, std::nullopt}}};
    EXPECT_FALSE(free_rigid_motion(input));
    input.motions.clear();
    EXPECT_TRUE(free_rigid_motion(input));
}

TEST(BodyForce, SumsToTheWeight) {
    for (auto input : {box_case(2, true), sphere_case(3, 16)}) {
        input.materials[0].density_kg_m3 = 1080.0;
        input.loads.clear();
        input.dead_loads = {{"gravity", model::DeadLoadKind::gravity, {9.81, 0, 0}}};
        input.supports.clear();  // every node counts
        System system(input, PETSC_COMM_WORLD);
        auto R = system.make_vector();
        system.evaluate(system.make_vector(), {{}, {1.0}, {}}, R, nullptr);
        double sum = 0;
        const PetscScalar* values = nullptr;
        SOFT_PETSC(VecGetArrayRead(R, &values));
        const auto dimension = static_cast<std::size_t>(input.mesh.dimension);
        for (std::size_t node = 0; node < input.mesh.points.size(); ++node)
            sum -= values[system.dofs().displacement[dimension * node]];
        SOFT_PETSC(VecRestoreArrayRead(R, &values));
        const double volume = dimension == 3 ? 1e-6 : 2.0 / 3.0 * std::numbers::pi * 7e-6;  // half a shell, 10 to 20 mm
        EXPECT_NEAR(sum / (1080.0 * 9.81 * volume), 1.0, dimension == 3 ? 1e-12 : 1e-6);
    }
    auto without = box_case(1, true);
    without.dead_loads = {{"gravity", model::DeadLoadKind::gravity, {9.81, 0, 0}}};
    EXPECT_THROW(System(without, PETSC_COMM_WORLD), Error);
}

/// Rigid rotation of the box about an axis through the origin.
linalg::Vector turned(const System& system, const std::array<double, 3>& axis, double angle) {
    auto x = system.make_vector();
    const auto& mesh = system.input().mesh;
    const double c = std::cos(angle), s = std::sin(angle);
    for (std::size_t node = 0; node < mesh.points.size(); ++node) {
        const auto& X = mesh.points[node];
        const std::array<double, 3> across{axis[1] * X[2] - axis[2] * X[1], axis[2] * X[0] - axis[0] * X[2],
                                           axis[0] * X[1] - axis[1] * X[0]};
        const double along = axis[0] * X[0] + axis[1] * X[1] + axis[2] * X[2];
        for (std::size_t i = 0; i < 3; ++i)  // Rodrigues
            if (const auto dof = system.dofs().displacement[3 * node + i]; dof >= 0)
                SOFT_PETSC(
                    VecSetValue(x, dof, c * X[i] + s * across[i] + (1 - c) * along * axis[i] - X[i], INSERT_VALUES));
    }
    linalg::assemble(x);
    return x;
}

model::Case measured_box() {
    auto input = box_case(2, true);
    input.supports.clear();
    input.outputs = {{"twist", "end", {1, 0, 0}, model::Measure::twist, ""},
                     {"bend", "end", {0, 1, 0}, model::Measure::bend, "fixed"}};
    return input;
}

TEST(Rotation, ARigidRotationHasItsAngleAsTwistAndNoBend) {
    const auto input = measured_box();
    System system(input, PETSC_COMM_WORLD);
    for (const double angle : {-2.5, -0.3, 0.0, 0.7, 3.0}) {
        const auto x = turned(system, {1, 0, 0}, angle);
        EXPECT_NEAR(system.outputs().value(0, x, nullptr), angle, 1e-12);
        EXPECT_NEAR(system.outputs().value(1, turned(system, {0, 1, 0}, angle), nullptr), 0.0,
                    1e-12);  // both faces turn
    }
}

// A block bent to a circular arc about y: the normals of its end and its fixed face differ by the angle of the arc.
TEST(Rotation, BendIsTheAngleBetweenTheFaces) {
    const auto input = measured_box();
    System system(input, PETSC_COMM_WORLD);
    const double angle = 1.2, radius = 0.01 / angle;  // of the line z = 0, 10 mm long
    auto x = system.make_vector();
    for (std::size_t node = 0; node < input.mesh.points.size(); ++node) {
        const auto& X = input.mesh.points[node];
        const double a = X[0] / radius;  // positive about y turns x towards -z
        const std::array<double, 3> bent{(radius + X[2]) * std::sin(a), X[1], (radius + X[2]) * std::cos(a) - radius};
        for (std::size_t i = 0; i < 3; ++i)
            SOFT_PETSC(VecSetValue(x, system.dofs().displacement[3 * node + i], bent[i] - X[i], INSERT_VALUES));
    }
    linalg::assemble(x);
    EXPECT_NEAR(system.outputs().value(1, x, nullptr), angle, 1e-12);
}

/// A quarter of a ring in plane strain, without supports.
model::Case measured_ring() {
    auto input = sphere_case(2, 8);
    input.kinematics = model::Kinematics::plane_strain;
    input.symmetry_planes = {};
    input.model_fraction = 1.0;
    input.supports.clear();
    input.outputs = {{"twist", "outer", {0, 0, 1}, model::Measure::twist, ""},
                     {"bend", "axis", {0, 0, 1}, model::Measure::bend, "symmetry_x"}};
    return input;
}

/// Maps each point at an angle f about the origin to the angle `share` f + `turn`.
linalg::Vector opened(const System& system, double share, double turn) {
    auto x = system.make_vector();
    const auto& points = system.input().mesh.points;
    for (std::size_t node = 0; node < points.size(); ++node) {
        const double radius = std::hypot(points[node][0], points[node][1]),
                     angle = share * std::atan2(points[node][1], points[node][0]) + turn;
        const std::array<double, 2> there{radius * std::cos(angle), radius * std::sin(angle)};
        for (std::size_t i = 0; i < 2; ++i)
            SOFT_PETSC(
                VecSetValue(x, system.dofs().displacement[2 * node + i], there[i] - points[node][i], INSERT_VALUES));
    }
    linalg::assemble(x);
    return x;
}

TEST(Rotation, FacesInPlaneStrainRotateAboutZ) {
    const auto input = measured_ring();
    System system(input, PETSC_COMM_WORLD);
    constexpr double right_angle = std::numbers::pi / 2;
    for (const double turn : {-2.5, -0.3, 0.0, 1.1}) {
        const auto x = opened(system, 1.0, turn);
        EXPECT_NEAR(system.outputs().value(0, x, nullptr), turn, 1e-12);
        EXPECT_NEAR(system.outputs().value(1, x, nullptr), 0.0, 1e-12);
        for (const double share : {0.3, 0.8, 1.4})  // the face on the x axis against that on the y axis
            EXPECT_NEAR(system.outputs().value(1, opened(system, share, turn), nullptr), (1.0 - share) * right_angle,
                        1e-12);
    }
}

/// measured_box as the half y >= 0.
model::Case measured_half() {
    auto input = measured_box();
    input.symmetry_planes = {false, true, false};
    input.model_fraction = 0.5;
    return input;
}

TEST(Rotation, AFaceAndItsMirrorImageRotateOnlyInThePlaneOfSymmetry) {
    auto input = measured_half();
    input.outputs.push_back({"sideways", "end", {0, 0, 1}, model::Measure::bend, "fixed"});
    const auto box = measured_box();
    System half(input, PETSC_COMM_WORLD), separate(box, PETSC_COMM_WORLD);
    const auto x = wavy(half, 5e-4, 0.3);
    EXPECT_NEAR(half.outputs().value(0, x, nullptr), 0.0, 1e-15);
    EXPECT_NEAR(half.outputs().value(2, x, nullptr), 0.0, 1e-15);
    EXPECT_GT(std::abs(separate.outputs().value(0, x, nullptr)), 1e-3);
    const double bend = separate.outputs().value(1, x, nullptr);
    EXPECT_GT(std::abs(bend), 1e-3);
    EXPECT_NEAR(half.outputs().value(1, x, nullptr), bend, 1e-14);
}

TEST(Rotation, GradientIsTheDerivative) {
    for (const auto& input : {measured_box(), measured_ring(), measured_half()}) {
        System system(input, PETSC_COMM_WORLD);
        const auto x = wavy(system, 5e-4, 0.3), d = wavy(system, 5e-4, 1.1);
        auto gradient = system.make_vector(), there = system.make_vector();
        for (const std::size_t output : {0, 1}) {
            const double value = system.outputs().value(output, x, gradient), slope = linalg::dot(gradient, d);
            const auto remainder = [&](double h) {
                linalg::copy(x, there);
                linalg::add(there, h, d);
                return std::abs(system.outputs().value(output, there, nullptr) - value - h * slope);
            };
            if (input.symmetry_planes[1] && output == 0)  // of the twist, which is 0
                EXPECT_LT(remainder(0.2), 1e-15);
            else
                EXPECT_NEAR(remainder(0.2) / remainder(0.1), 4.0, 0.3);
        }
    }
}

TEST(Rotation, RejectsABendInAnAxisymmetricSection) {
    auto input = sphere_case(1, 2);
    input.outputs = {{"bend", "outer", {0, 1, 0}, model::Measure::bend, "cavity"}};
    EXPECT_THROW(System(input, PETSC_COMM_WORLD), Error);
}

}  // namespace
}  // namespace soft::fem
