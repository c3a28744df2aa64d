/// Paths solved again on finer meshes: the thick sphere's bars against the closed form, stages, refusals, bounds.
#include "solver/accuracy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "mesh/refine.hpp"
#include "sphere.hpp"

namespace soft::solver {
namespace {

using model::Prescription;

struct Judged {
    Accuracy accuracy;
    std::vector<RowState> given;  ///< rows of the given mesh
    solution::PathEnd end;
};

Judged judge(const model::Case& input, const AccuracyTarget& target) {
    assembly::System system(input, PETSC_COMM_WORLD);
    Judged judged;
    judged.end = follow_path(system, {.step = [](const solution::Step&, Vec) {},
                                      .row = [&](const RowState& row) { judged.given.push_back(row); }});
    judged.accuracy = refine_path(system, judged.given, judged.end, target, {});
    return judged;
}

model::Case inflated_sphere(int layers, int sectors) {
    auto input = sphere_case(layers, sectors);
    input.path.stages[0].until = {{"volume_ratio", 8.0}};
    return input;
}

model::Case refined(model::Case input) {
    input.mesh = mesh::refine_once(input.mesh, mesh::Curve::circle).mesh;
    return input;
}

AccuracyTarget tolerance(double value) { return {.tolerance = value}; }

/// Room for one finer mesh, not for two: the given mesh itself is then what is reported.
AccuracyTarget two_meshes(const model::Case& input, double value) {
    return {.tolerance = value, .largest_unknowns_2d = 4 * assembly::System(input, PETSC_COMM_WORLD).dofs().total};
}

/// Largest |p - exact p| of the rows, and by how much of it a bar falls short at most.
double largest_error(const std::vector<RowState>& rows) {
    double largest = 0;
    for (const auto& row : rows)
        largest =
            std::max(largest, std::abs(row.step.pressure_Pa - sample_mu_Pa * sphere_pressure(inner_stretch(row.step))));
    return largest;
}

TEST(Accuracy, BarsOfTheSphereCoverTheClosedFormAtEveryRow) {
    for (const double wanted : {0.5, 1e-3, 1e-4}) {  // levels 0, 1, 2
        const auto input = inflated_sphere(1, 2);
        const auto [accuracy, given, end] = judge(input, wanted == 0.5 ? two_meshes(input, wanted) : tolerance(wanted));
        ASSERT_TRUE(accuracy.has_bars);
        EXPECT_TRUE(accuracy.obstacle.empty()) << accuracy.obstacle;
        EXPECT_LE(accuracy.reached, wanted);
        ASSERT_EQ(accuracy.rows.size(), given.size());
        double bars = 0, errors = 0;
        for (const auto& row : accuracy.rows) {
            const double error = row.step.pressure_Pa - sample_mu_Pa * sphere_pressure(inner_stretch(row.step));
            EXPECT_LE(std::abs(error), *row.step.pressure_error_Pa) << accuracy.level << ' ' << row.step.pressure_Pa;
            bars += *row.step.pressure_error_Pa * *row.step.pressure_error_Pa;
            errors += error * error;
        }
        EXPECT_LT(std::sqrt(bars / errors), 3) << accuracy.level;
    }
}

TEST(Accuracy, FinerMeshesAreNearerToTheClosedFormAndSoIsTheLimitPoint) {
    const auto input = inflated_sphere(1, 2);
    const auto coarse = judge(input, two_meshes(input, 0.5)), fine = judge(input, tolerance(1e-3));
    EXPECT_EQ(coarse.accuracy.level, 0);
    ASSERT_GE(fine.accuracy.level, 1);
    EXPECT_LT(largest_error(fine.accuracy.rows), 0.2 * largest_error(coarse.accuracy.rows));
    ASSERT_EQ(fine.end.limit_points.size(), 1u);
    EXPECT_EQ(fine.end.limit_points[0].step, coarse.end.limit_points[0].step);
    const auto off = [](const Judged& judged) {
        return std::abs(judged.end.limit_points[0].pressure_Pa / sample_mu_Pa - sphere_limit);
    };
    EXPECT_LT(off(fine), 0.2 * off(coarse));
}

TEST(Accuracy, RowsOfTheGivenMeshStayAsTheyWere) {
    const auto input = inflated_sphere(1, 2);
    const auto [accuracy, given, end] = judge(input, two_meshes(input, 0.5));
    ASSERT_EQ(accuracy.level, 0);
    for (std::size_t i = 0; i < given.size(); ++i) {
        EXPECT_EQ(accuracy.rows[i].step.pressure_Pa, given[i].step.pressure_Pa);
        EXPECT_EQ(accuracy.rows[i].displacement_m, given[i].displacement_m);
    }
}

// Two meshes may hide what is not in its rate yet: where a third one fits, the given mesh is never the reported one.
TEST(Accuracy, TakesAThirdMeshWhereItFits) {
    EXPECT_EQ(judge(inflated_sphere(1, 2), tolerance(0.5)).accuracy.level, 1);
}

/// The grid of the sphere laid out as a tube of 3 mm of rubber round 20 mm, held at both ends: one layer of cells, and corners.
model::Case held_tube(int cells, double length_m) {
    auto input = sphere_case(1, cells);
    for (auto& p : input.mesh.points) {
        const double radius = std::hypot(p[0], p[1]), angle = std::atan2(p[0], p[1]);
        p = {length_m * angle * 2 / std::numbers::pi, 0.01 + 0.3 * (radius - 0.01), 0};
    }
    input.model_fraction = 1;
    input.symmetry_planes = {};
    input.supports = {{"axis", {true, true, false}}, {"symmetry_x", {true, true, false}}};
    const double hole = std::numbers::pi * 1e-4;
    input.cavities[0].openings = {{"symmetry_x", hole, {-1, 0, 0}}, {"axis", hole, {1, 0, 0}}};
    input.path.stages[0].until = {{"volume_ratio", 1.3}};
    return input;
}

// The first differences are of opposite sign: bars of three meshes are believed where they are half of what is asked for.
TEST(Accuracy, TakesAFourthMeshWhereTheRatesAreAssumed) {
    const auto input = held_tube(4, 0.02);
    const std::int64_t three_meshes = 4 * assembly::System(refined(input), PETSC_COMM_WORLD).dofs().total;
    const auto three = judge(input, {.tolerance = 1e-12, .largest_unknowns_2d = three_meshes});
    ASSERT_EQ(three.accuracy.level, 1);
    const double reached = three.accuracy.reached;
    EXPECT_EQ(judge(input, tolerance(2.02 * reached)).accuracy.level, 1);
    const auto four = judge(input, tolerance(1.01 * reached));
    EXPECT_EQ(four.accuracy.level, 2);
    EXPECT_LT(four.accuracy.reached, reached);
    EXPECT_TRUE(four.accuracy.obstacle.empty());
    // Where no fourth mesh fits, three are enough.
    const auto stopped = judge(input, {.tolerance = 1.01 * reached, .largest_unknowns_2d = three_meshes});
    EXPECT_EQ(stopped.accuracy.level, 1);
    EXPECT_TRUE(stopped.accuracy.obstacle.empty());
}

// Halved cells have less than four times the unknowns: what is kept of a mesh goes by those it has, not by the four times.
TEST(Accuracy, GoesOnToAMeshThatJustFits) {
    const auto input = inflated_sphere(1, 2), halved = refined(input);
    const auto unknowns = [](const model::Case& of) { return assembly::System(of, PETSC_COMM_WORLD).dofs().total; };
    const std::int64_t bound = 4 * unknowns(halved);
    ASSERT_LT(bound, 16 * unknowns(input));
    const auto judged = judge(input, {.tolerance = 1e-12, .largest_unknowns_2d = bound});
    EXPECT_EQ(judged.accuracy.level, 1);
    EXPECT_FALSE(judged.accuracy.obstacle.empty());
}

/// The points of the given mesh keep their numbers, so that its displacements are the first of the finer one's.
TEST(Accuracy, FieldsOfAFinerLevelBeginWithTheGivenPoints) {
    const auto [accuracy, given, end] = judge(inflated_sphere(1, 2), tolerance(1e-3));
    ASSERT_GE(accuracy.level, 1);
    const auto &fine = accuracy.rows.back().displacement_m, &coarse = given.back().displacement_m;
    ASSERT_GT(fine.size(), coarse.size());
    for (std::size_t i = 0; i < coarse.size(); ++i) EXPECT_NEAR(fine[i], coarse[i], 2e-4);  // of 10 mm
}

/// Gas goes in, the valve is shut, the pressure is let out: the ends of the stages are held, the gas stays.
TEST(Accuracy, StagesEndAtTheirLoadsAndClosedGasKeepsItsMass) {
    auto input = sphere_case(1, 2);
    auto hold = input.path.stages[0], vent = hold;
    input.path.stages[0].supplies = {{Prescription::mass, 2e-6}};
    input.path.stages[0].name = "fill";
    hold.supplies = {{Prescription::closed, 0}};
    hold.name = "hold";
    vent.supplies = {{Prescription::pressure, 1e3}};
    vent.name = "vent";
    input.path.stages.push_back(hold);
    input.path.stages.push_back(vent);
    const auto [accuracy, given, end] = judge(input, tolerance(1e-3));
    ASSERT_GE(accuracy.level, 1) << accuracy.obstacle;
    const auto& rows = accuracy.rows;
    const auto mass = [&](const solution::Step& step) { return (step.pressure_Pa / 101325.0 + 1) * *step.volume_m3; };
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
        if (rows[i].step.stage != 0 || rows[i + 1].step.stage != 1) continue;
        EXPECT_NEAR(mass(rows[i].step) / (*rows[0].step.volume_m3 + 2e-6 / 1.204), 1, 1e-8);
        EXPECT_NEAR(mass(rows[i + 1].step) / mass(rows[i].step), 1, 1e-8);
    }
    EXPECT_NEAR(rows.back().step.pressure_Pa, 1e3, 1e-6);
}

TEST(Accuracy, SaysWhichBoundStopsIt) {
    const auto bound = two_meshes(inflated_sphere(1, 2), 1e-9);
    const auto one = judge(inflated_sphere(1, 2), bound);
    EXPECT_TRUE(one.accuracy.has_bars);
    EXPECT_EQ(one.accuracy.level, 0);
    EXPECT_NE(one.accuracy.obstacle.find(std::to_string(bound.largest_unknowns_2d)), std::string::npos)
        << one.accuracy.obstacle;
    const auto none = judge(inflated_sphere(1, 2), {.tolerance = 1e-9, .largest_unknowns_2d = 10});
    EXPECT_FALSE(none.accuracy.has_bars);
    EXPECT_EQ(none.accuracy.rows.size(), none.given.size());
    EXPECT_FALSE(none.accuracy.obstacle.empty());
}

TEST(Accuracy, RefusesCellsOfFirstOrder) {
    auto input = sphere_case(1, 1);
    const auto second = input.mesh;
    input.formulation = model::Formulation::displacement;
    input.materials = {sample_material(false)};
    input.mesh.connectivity.clear();
    input.mesh.offsets = {0};
    input.mesh.cell_types.clear();
    input.mesh.cell_regions.clear();
    mesh::add_cell(input.mesh, mesh::CellType::quad4, second.cell_nodes(0).first(4), 0);
    assembly::System system(input, PETSC_COMM_WORLD);
    solution::PathEnd end;
    EXPECT_THROW(static_cast<void>(refine_path(system, {RowState{}}, end, {}, {})), Error);
}

}  // namespace
}  // namespace soft::solver
