/// Reactions of constrained bodies against closed forms, along the whole path.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "../fem/sample_cases.hpp"
#include "bench.hpp"

namespace soft::solver {
namespace {

using model::Measure;

/// Segment of a tube between two planes that fix it in x: A = 10 mm, B = 20 mm, 10 mm long, sealed by plugs in both planes.
model::Case tube_between_planes(int layers) {
    constexpr double A = 0.01, B = 0.02, length = 0.01;
    model::Case input;
    input.kinematics = model::Kinematics::axisymmetric;
    auto& mesh = input.mesh;
    mesh.dimension = 2;
    mesh.region_names = {"rubber"};
    const int columns = 5;
    for (int j = 0; j <= 2 * layers; ++j)
        for (int i = 0; i < columns; ++i)
            mesh.points.push_back({length * i / (columns - 1), A + (B - A) * j / (2 * layers), 0.0});
    for (int j = 0; j < 2 * layers; j += 2)
        for (int i = 0; i + 2 < columns; i += 2) {
            const auto id = [&](int di, int dj) { return static_cast<mesh::Index>(j + dj) * columns + i + di; };
            mesh::add_cell(
                mesh, mesh::CellType::quad9,
                std::array{id(0, 0), id(2, 0), id(2, 2), id(0, 2), id(1, 0), id(2, 1), id(1, 2), id(0, 1), id(1, 1)},
                0);
        }
    name_boundary(mesh, [&](const mesh::Point& p) {
        if (p[0] < 1e-9) return "left";
        if (p[0] > length - 1e-9) return "right";
        return p[1] < 0.5 * (A + B) ? "cavity" : "outer";
    });
    const double hole = std::numbers::pi * A * A;
    input.supports = {{"left", {true, false, false}}, {"right", {true, false, false}}};
    input.cavities = {{"cavity", "cavity", {}, {{"left", hole, {-1, 0, 0}}, {"right", hole, {1, 0, 0}}}}};
    input.materials = {sample_material(true)};
    input.loads = {{.name = "cavity", .targets = {"cavity"}, .gas = {}}};
    input.outputs = {{"right", "right", {1, 0, 0}, Measure::force},
                     {"left", "left", {1, 0, 0}, Measure::force},
                     {"bore", "cavity", {1, 0, 0}, Measure::radial}};
    input.path.stages = {full_load(input, {0.25 * sample_mu_Pa})};
    return input;
}

// Force of the wall N = pi [int (2 s_z - s_t - s_r) r dr + p a^2], as int (sigma_t + sigma_r) r dr = p a^2 (verification/
// inflation_formula.cpp); s_i = mu l_i^2 in plane strain, l_t = r/R, r^2 = R^2 + c: the integral in closed form. The plug pushes
// with the pressure on the undeformed hole.
TEST(Reactions, OfATubeBetweenPlanesAreThrustMinusWallForce) {
    const auto input = tube_between_planes(8);
    const auto result = run(input);
    ASSERT_EQ(result.end.reason, model::StopReason::done);
    const double A = 0.01, B = 0.02, pi = std::numbers::pi;
    for (const auto& step : result.steps) {
        const double a = A + step.outputs[2], c = a * a - A * A, p = step.pressure_Pa;
        const double integral = sample_mu_Pa * c * (0.5 * std::log((B * B + c) / a / a) - std::log(B / A));
        const double expected = p * pi * A * A - pi * (integral + p * a * a);
        EXPECT_NEAR(step.outputs[0], expected, 1e-5 * pi * A * A * 0.25 * sample_mu_Pa);
        EXPECT_NEAR(step.outputs[0], -step.outputs[1], 1e-9 * std::abs(step.outputs[0]) + 1e-12);
        EXPECT_NEAR(*step.volume_m3, pi * a * a * 0.01, 1e-8 * *step.volume_m3);
    }
    EXPECT_GT(result.steps.back().outputs[2], 1e-3);  // the inflation is large
}

// A bar of A = 10 x 10 mm stretched to l has the force A mu (l - 1/l^2); the reactions at its two ends are opposite.
TEST(Reactions, OfAStretchedBarAreItsNominalStress) {
    auto input = box_case(1, true);
    input.loads.clear();
    input.motions = {{"end", {0.01, std::nullopt, std::nullopt}}};
    input.outputs = {{"pull", "end", {1, 0, 0}, Measure::force},
                     {"hold", "fixed", {1, 0, 0}, Measure::force},
                     {"elongation", "end", {1, 0, 0}}};
    input.path.stages = {full_load(input, {})};
    const auto result = run(input);
    ASSERT_EQ(result.end.reason, model::StopReason::done);
    for (const auto& step : result.steps) {
        const double l = 1 + step.outputs[2] / 0.01, expected = 1e-4 * sample_mu_Pa * (l - 1 / (l * l));
        EXPECT_NEAR(step.outputs[0], -expected, 1e-9);
        EXPECT_NEAR(step.outputs[1], expected, 1e-9);
        // d(force)/d(elongation) = A mu (1 + 2/l^3) / length
        EXPECT_NEAR(step.tangent_outputs[1] / step.tangent_outputs[2], 1e-2 * sample_mu_Pa * (1 + 2 / (l * l * l)),
                    1e-5);
    }
}

TEST(Reactions, CanBeTheGoalOfAPath) {
    auto input = tube_between_planes(2);
    input.path.stages[0].until = {{"right", -0.2}};
    const auto [steps, end, log] = run(input);
    EXPECT_EQ(end.reason, model::StopReason::done);
    EXPECT_NEAR(steps.back().outputs[0], -0.2, 1e-8);
    EXPECT_NE(end.detail.find("right of -0.2 N"), std::string::npos) << end.detail;
    auto bar = box_case(1, true);  // moved: the force depends on the load factor only through the motion
    bar.loads.clear();
    bar.motions = {{"end", {0.01, std::nullopt, std::nullopt}}};
    bar.outputs = {{"hold", "fixed", {1, 0, 0}, Measure::force}};
    bar.path.stages = {full_load(bar, {})};
    bar.path.stages[0].until = {{"hold", 10.0}};
    EXPECT_NEAR(run(bar).steps.back().outputs[0], 10.0, 1e-7);
}

/// A block fixed at both ends, under its weight, a traction and a pressure from below: bending, shear and tension.
model::Case clamped_block() {
    auto input = box_case(2, true);
    input.supports = {{"fixed", {true, true, true}}, {"end", {true, true, true}}};
    input.materials[0].density_kg_m3 = 1080;
    input.loads = {{.name = "bottom", .targets = {"bottom"}, .gas = {}, .shape = model::LoadShape::undeformed}};
    input.dead_loads = {{"right", model::DeadLoadKind::traction, {1e3, 2e3, 5e3}},
                        {"gravity", model::DeadLoadKind::gravity, {30, 0, -300}}};
    input.outputs.clear();
    for (const char* face : {"fixed", "end"})
        for (std::size_t i = 0; i < 3; ++i)
            for (const Measure measure : {Measure::force, Measure::moment}) {
                model::Output output{
                    std::string{face} + "xyz"[i] + std::string{model::name_of(measure)}, face, {}, measure};
                output.direction[i] = 1;
                input.outputs.push_back(output);
            }
    input.path.stages = {full_load(input, {2e4})};
    return input;
}

TEST(Reactions, OfBothEndsAreTheResultantOfDeadLoads) {
    auto input = clamped_block();
    const auto result = run(input);
    ASSERT_EQ(result.end.reason, model::StopReason::done);
    const auto& outputs = result.steps.back().outputs;
    const double weight = 1080 * 1e-6;
    const std::array<double, 3> loads{1e-4 * 1e3 + 30 * weight, 1e-4 * 2e3, 1e-4 * 5e3 - 300 * weight + 1e-4 * 2e4};
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(outputs[2 * i] + outputs[6 + 2 * i], loads[i], 1e-8 * loads[i]);
}

// A follower pressure on a closed surface has neither resultant force nor moment; the reactions at both ends balance each other.
TEST(Reactions, MomentsBalanceAboutAnyPoint) {
    auto input = clamped_block();
    input.supports = {{"fixed", {true, true, true}}, {"left", {true, true, true}}};
    for (auto& output : input.outputs)
        if (output.face == "end") output.face = "left";
    input.dead_loads.clear();
    input.loads = {{.name = "all", .targets = {"all"}, .gas = {}}};
    for (const char* face : {"fixed", "end", "left", "bottom", "right", "top"})
        for (const auto& facet : input.mesh.facet_sets.at(face)) input.mesh.facet_sets["all"].push_back(facet);
    // The fixed faces share an edge, which would count twice: remove the facets at that edge from one set.
    std::erase_if(input.mesh.facet_sets.at("left"), [&](const mesh::Facet& facet) {
        for (const auto node : mesh::facet_nodes(input.mesh, facet))
            if (input.mesh.point(node)[0] == 0.0) return true;
        return false;
    });
    input.motions = {{"left", {1e-3, std::nullopt, 1e-3}}};  // so that the block deforms
    input.supports[1].fixed = {false, true, false};
    input.path.stages = {full_load(input, {2e4})};
    const auto result = run(input);
    ASSERT_EQ(result.end.reason, model::StopReason::done);
    const auto& o = result.steps.back().outputs;
    const Vector3 F{o[0], o[2], o[4]}, M{o[1], o[3], o[5]}, G{o[6], o[8], o[10]}, N{o[7], o[9], o[11]};
    const Vector3 arm{0.0075, -0.005, 0};  // between the centroids: (0, 5, 5) mm and (7.5, 0, 5) mm
    const Vector3 carried = cross(arm, G);
    const double size = std::abs(M[1]) + std::abs(N[1]);
    EXPECT_GT(size, 1e-5);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(F[i] + G[i], 0.0, 1e-8 * std::abs(F[0]));
        EXPECT_NEAR(M[i] + N[i] + carried[i], 0.0, 1e-8 * size);
    }
}

// The half of a symmetric block gives the reactions of the whole.
TEST(Reactions, OfAHalfModelAreThoseOfTheWhole) {
    auto half = box_case(2, true);
    half.supports = {{"fixed", {true, true, true}}, {"end", {true, true, true}}, {"left", {false, true, false}}};
    half.symmetry_planes = {false, true, false};
    half.model_fraction = 0.5;
    half.loads = {{.name = "bottom", .targets = {"bottom"}, .gas = {}}};
    half.outputs = {{"lift", "end", {0, 0, 1}, Measure::force}, {"turn", "end", {0, 1, 0}, Measure::moment}};
    half.path.stages = {full_load(half, {2e4})};
    auto whole = half;
    whole.symmetry_planes = {};
    whole.model_fraction = 1;
    whole.supports.pop_back();
    for (auto& point : whole.mesh.points) point[1] = 2 * (point[1] - 0.005);
    const auto of_half = run(half), of_whole = run(whole);
    for (const std::size_t i :
         {0, 1})  // other meshes of the same body; a lost or doubled image would be a factor of two
        EXPECT_NEAR(of_half.steps.back().outputs[i] / of_whole.steps.back().outputs[i], 1.0, 0.05);
}

}  // namespace
}  // namespace soft::solver
