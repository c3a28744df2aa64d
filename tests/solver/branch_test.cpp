/// Bifurcations, contact, and the messages of a path that cannot continue.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench.hpp"
#include "core/error.hpp"
#include "sphere.hpp"

namespace soft::solver {
namespace {

using model::StopReason;

constexpr double strut_length = 0.1, strut_height = 0.01;

/// A strut in plane strain between smooth plates, `n` x 2 quad9 cells, compressed along x by `share` of its length. It slides freely
/// along the plates; the facet of its top next to x = 0, where the buckling mode has zero slope, is fixed in y.
model::Case strut_case(int n, double share) {
    model::Case input;
    input.kinematics = model::Kinematics::plane_strain;
    auto& mesh = input.mesh;
    mesh.dimension = 2;
    mesh.region_names = {"rubber"};
    const int columns = 2 * n + 1, rows = 5;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            mesh.points.push_back({strut_length * i / (columns - 1), strut_height * j / (rows - 1), 0.0});
    for (int j = 0; j + 2 < rows; j += 2)
        for (int i = 0; i + 2 < columns; i += 2) {
            const auto id = [&](int di, int dj) { return static_cast<mesh::Index>(j + dj) * columns + i + di; };
            mesh::add_cell(
                mesh, mesh::CellType::quad9,
                std::array{id(0, 0), id(2, 0), id(2, 2), id(0, 2), id(1, 0), id(2, 1), id(1, 2), id(0, 1), id(1, 1)},
                0);
        }
    name_boundary(mesh, [&](const mesh::Point& p) {
        if (p[0] < 1e-9) return "fixed";
        if (p[0] > strut_length - 1e-9) return "end";
        return p[1] > strut_height - 1e-9 && p[0] < strut_length / n ? "level" : "side";
    });
    input.supports = {{"fixed", {true, false, false}}, {"level", {false, true, false}}};
    input.materials = {sample_material(true)};
    input.motions = {{"end", {-share * strut_length, std::nullopt, std::nullopt}}};
    input.outputs = {{"sway", "end", {0, 1, 0}}};
    input.path.stages = {full_load(input, {})};
    return input;
}

/// Exact strain at which the strut buckles into `half_waves`: displacements u2 = -k f(y) cos kx, f = A cosh ky + B cosh(l1/l2 ky)
/// of an incompressible neo-Hookean slab under thrust have no traction on y = +-h where
///     tanh(kh) / tanh(kh l1/l2) = 4 l1 l2^3 / (l1^2 + l2^2)^2,   k = half_waves pi / (l1 L),  h = l2 H / 2,  l2 = 1 / l1
/// (flexural mode of Sawyers and Rivlin, Int. J. Solids Structures 10 (1974) 483; rederived here).
double buckling_strain(int half_waves = 1) {
    const auto residual = [half_waves](double l1) {
        const double l2 = 1 / l1, kh = half_waves * std::numbers::pi / (l1 * strut_length) * l2 * strut_height / 2;
        const double sum = l1 * l1 + l2 * l2;
        return std::tanh(kh) / std::tanh(kh * l1 / l2) - 4 * l1 * l2 * l2 * l2 / (sum * sum);
    };
    double stable = 0.999, unstable = 0.8;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (stable + unstable);
        (residual(middle) * residual(0.999) > 0 ? stable : unstable) = middle;
    }
    return 1 - stable;
}

TEST(Bifurcation, AllWithinOneStepAreLocated) {
    auto input = strut_case(40, 0.1);
    input.solver.steps = model::StepRule::constant;
    input.solver.first_step = 1;
    const auto end = run(input).end;
    EXPECT_EQ(end.reason, StopReason::done);
    ASSERT_EQ(end.bifurcations.size(), 3u);
    for (int n = 1; n <= 3; ++n) {
        const model::Bifurcation& at = end.bifurcations[static_cast<std::size_t>(n - 1)];
        EXPECT_EQ(at.modes, 1);
        EXPECT_NEAR(0.1 * at.at.pressure_Pa / buckling_strain(n), 1.0, 4e-3) << n;  // 'level' has a finite length
        double error = 0;
        const double sign = at.mode[3 * (n == 1 ? 80 : 80 / n) + 1] > 0 ? 1.0 : -1.0;  // nodes 0 to 80: the lower side
        for (std::size_t node = 0; node <= 80; ++node)
            error =
                std::max(error, std::abs(sign * at.mode[3 * node + 1] -
                                         0.5 * (1 - std::cos(n * std::numbers::pi * static_cast<double>(node) / 80))));
        EXPECT_LT(error, 0.02 * n) << n;  // 'level', n fortieths of a half wave, does not rotate
    }
}

TEST(Bifurcation, AStrutBucklesAtItsExactStrainInItsExactMode) {
    const auto input = strut_case(40, 0.02);
    const auto [steps, end, log] = run(input);
    EXPECT_EQ(end.reason, StopReason::done);
    ASSERT_EQ(end.bifurcations.size(), 1u);
    const double at = end.bifurcations[0].at.pressure_Pa;   // the leading "load" is the load factor
    EXPECT_NEAR(0.02 * at / buckling_strain(), 1.0, 2e-3);  // the facet 'level' has a finite length
    EXPECT_EQ(end.bifurcations[0].modes, 1);
    for (const auto& step : steps)
        if (step.load_factor != at) {
            EXPECT_EQ(step.stable, step.load_factor < at);
        }
    const auto& mode = end.bifurcations[0].mode;
    ASSERT_EQ(mode.size(), 3 * input.mesh.points.size());
    double largest = 0, error = 0;
    for (std::size_t node = 0; node < input.mesh.points.size(); ++node)
        largest = std::max(largest, std::abs(mode[3 * node + 1]));
    EXPECT_NEAR(largest, 1.0, 1e-12);
    const double sign = mode[3 * 80 + 1] > 0 ? 1.0 : -1.0;  // node 80: the lower end corner
    for (std::size_t node = 0; node < input.mesh.points.size(); ++node)
        error = std::max(error,
                         std::abs(sign * mode[3 * node + 1] -
                                  0.5 * (1 - std::cos(std::numbers::pi * input.mesh.points[node][0] / strut_length))));
    EXPECT_LT(error, 0.02);  // the facet 'level', a fortieth of the length, does not rotate
}

// Shortening of a cosine of amplitude a beyond buckling: (pi a)^2 / (4 L) to lowest order; the end moves sideways by 2 a.
TEST(Bifurcation, TheBuckledBranchIsFollowedFromTheStatedImperfection) {
    auto input = strut_case(20, 0.012);
    input.path.branch = model::Branch::follow;
    input.path.imperfection_m = 5e-4;
    const auto [steps, end, log] = run(input);
    EXPECT_EQ(end.reason, StopReason::done);
    ASSERT_EQ(end.bifurcations.size(), 1u);
    const double beyond = 0.012 * strut_length * (1 - end.bifurcations[0].at.pressure_Pa);
    const double sway = 2 * std::sqrt(4 * strut_length * beyond) / std::numbers::pi;
    EXPECT_NEAR(std::abs(steps.back().outputs[0]) / sway, 1.0, 0.03);
    EXPECT_TRUE(steps.back().stable);
}

TEST(Bifurcation, IsLocatedByTheSignOfTheDeterminantWithAnLuFactor) {
    auto input = strut_case(40, 0.02);
    struct Lu {
        Lu() {
            SOFT_PETSC(PetscOptionsSetValue(nullptr, "-pc_type", "lu"));
            SOFT_PETSC(PetscOptionsSetValue(nullptr, "-pc_factor_mat_solver_type", "mumps"));
        }
        ~Lu() {
            (void)PetscOptionsClearValue(nullptr, "-pc_type");
            (void)PetscOptionsClearValue(nullptr, "-pc_factor_mat_solver_type");
        }
    };
    const Lu lu;
    const auto end = run(input).end;
    ASSERT_EQ(end.bifurcations.size(), 1u);
    EXPECT_NEAR(0.02 * end.bifurcations[0].at.pressure_Pa / buckling_strain(), 1.0, 2e-3);
}

// A listener that reports contact once the cavity has shrunk to 80 %.
TEST(Contact, EndsThePathJustBeforeWallsTouch) {
    auto input = sphere_case(2, 4);
    input.path.stages = {full_load(input, {-3 * sample_mu_Pa})};
    input.path.contact = model::Contact::stop;
    fem::System measuring(input, PETSC_COMM_WORLD);
    const double undeformed = measuring.volumes().of_load(0, measuring.make_vector(), nullptr);
    StopReason seen = StopReason::self_contact;
    const auto touches = [&](Vec x) -> std::optional<ContactEvent> {
        if (measuring.volumes().of_load(0, x, nullptr) > 0.8 * undeformed) return std::nullopt;
        return ContactEvent{"the walls touch", seen};
    };
    const auto [steps, end, log] = run(input, touches);
    EXPECT_EQ(end.reason, StopReason::self_contact);
    EXPECT_NE(end.detail.find("the walls touch"), std::string::npos);
    EXPECT_GT(*steps.back().volume_m3, 0.8 * undeformed);
    EXPECT_LT(*steps.back().volume_m3, 0.802 * undeformed);
    seen = StopReason::inverted_element;  // a wall that has passed through itself
    const auto inverted = run(input, touches).end;
    EXPECT_EQ(inverted.reason, StopReason::inverted_element);
    EXPECT_NE(end.detail.find("; path.contact: solve continues"), std::string::npos);
    EXPECT_NE(inverted.detail.find("; use smaller cells there (mesh.size)"), std::string::npos);
    input.path.contact = model::Contact::ignore;
    EXPECT_NE(run(input, touches).end.reason, StopReason::self_contact);
}

TEST(Recovery, LogsEachAttemptAndReportsTheLocationOfTheFailure) {
    // A box pressed flat: with so few cells no state of the body carries this load.
    auto input = box_case(1, false);
    input.supports = {{"fixed", {true, true, true}}};
    input.path.stages = {full_load(input, {60 * sample_mu_Pa})};
    const auto [steps, end, log] = run(input);
    ASSERT_TRUE(end.reason == StopReason::inverted_element || end.reason == StopReason::diverged ||
                end.reason == StopReason::limit_point)
        << end.detail;
    EXPECT_GT(steps.size(), 2u);
    const auto named = [&log = log](const char* words) {
        return std::ranges::any_of(log, [&](const std::string& line) { return line.find(words) != std::string::npos; });
    };
    EXPECT_TRUE(named("cut to"));
    EXPECT_TRUE(named("line search"));
    EXPECT_TRUE(named("arc length"));
    EXPECT_NE(end.detail.find("mm"), std::string::npos);
}

}  // namespace
}  // namespace soft::solver
