/// Paths that return to earlier states: closed and reversed curves with known returns, curves without, and a closed branch.
#include "solver/visited_states.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "bench.hpp"
#include "sphere.hpp"

namespace soft::solver {
namespace {

/// A state in the plane of the first two components, and a third that leaves it.
VisitedState state_at(double x, double y, double direction, double aside = 0) {
    VisitedState state;
    state.state[0] = x;
    state.state[1] = y;
    state.state[2] = aside;
    state.tangent[0] = std::cos(direction);
    state.tangent[1] = std::sin(direction);
    return state;
}

/// Index of the state with which a return is found first.
std::optional<std::size_t> first_found(const std::vector<VisitedState>& path, Return::Sense sense) {
    for (std::size_t i = 1; i <= path.size(); ++i)
        if (const auto found = find_return(std::span(path).first(i))) {
            EXPECT_EQ(found->sense, sense);
            return i - 1;
        }
    return std::nullopt;
}

TEST(VisitedStates, ACircleIsClosedWithTheSecondStateOfItsSecondRound) {
    std::vector<VisitedState> path;
    constexpr double step = 2 * std::numbers::pi / 30.5;  // no state of the second round is one of the first
    for (int i = 0; i < 60; ++i)
        path.push_back(state_at(std::cos(i * step), std::sin(i * step), i * step + std::numbers::pi / 2));
    const auto found = first_found(path, Return::Sense::forward);
    ASSERT_TRUE(found);
    EXPECT_EQ(*found, 32u);  // state 31 is the first beyond 30.5 steps
}

TEST(VisitedStates, ASpiralAndALineNeverReturn) {
    std::vector<VisitedState> spiral, line;
    for (int i = 0; i < 100; ++i) {
        const double turn = 0.2 * i, radius = 1 + 0.01 * i;
        spiral.push_back(state_at(radius * std::cos(turn), radius * std::sin(turn), turn + std::numbers::pi / 2));
        line.push_back(state_at(0.1 * i * i, 0, 0));
    }
    EXPECT_FALSE(first_found(spiral, Return::Sense::forward));
    EXPECT_FALSE(first_found(line, Return::Sense::forward));
}

// The return is offset by a thousandth of the path's length, as where a single cell has changed.
TEST(VisitedStates, AReversedPathIsDetectedAfterAFiftiethOfItsLength) {
    std::vector<VisitedState> path;
    for (int i = 0; i <= 50; ++i) path.push_back(state_at(i, 0, 0));
    for (int i = 1; i <= 50; ++i) path.push_back(state_at(50 - 0.3 * i, 0, std::numbers::pi, 0.05));
    const auto found = first_found(path, Return::Sense::backward);
    ASSERT_TRUE(found);
    EXPECT_GE(path[*found].state[0], 48.0);
    EXPECT_LE(path[*found].state[0], 49.1);
}

// One of ten parts snaps through while the others reverse: a fold, not a reversal.
TEST(VisitedStates, AFoldOfOnePartIsNoReversal) {
    std::vector<VisitedState> path;
    for (int i = 0; i <= 50; ++i) path.push_back(state_at(i, 0, 0));
    for (int i = 1; i <= 20; ++i) path.push_back(state_at(50 - 0.3 * i, 0, std::numbers::pi, 0.3 * i));
    for (int i = 1; i <= 20; ++i) path.push_back(state_at(44 + i, 0, 0, 6));
    EXPECT_FALSE(first_found(path, Return::Sense::backward));
}

// A path that comes back beside its earlier states and passes them at one point only, at an angle whose cosine is 0.96.
TEST(VisitedStates, APathThatCrossesItsEarlierStatesIsNoReversal) {
    std::vector<VisitedState> path;
    for (int i = 0; i <= 50; ++i) path.push_back(state_at(i, 0, 0));
    for (int i = 0; i <= 40; ++i) path.push_back(state_at(45 - 0.5 * i, 3 - 0.15 * i, std::numbers::pi + 0.2915));
    EXPECT_FALSE(first_found(path, Return::Sense::backward));
}

// Two successive folds, at each of which one of many cells snaps through: the path continues beyond them.
TEST(VisitedStates, TwoFoldsAreNoReversal) {
    std::vector<VisitedState> path;
    for (int i = 0; i <= 50; ++i) path.push_back(state_at(i, 0, 0));
    for (int i = 1; i <= 9; ++i) path.push_back(state_at(50 - i, 0, std::numbers::pi, 0.4));
    for (int i = 1; i <= 20; ++i) path.push_back(state_at(41 + i, 0, 0, 0.45));
    EXPECT_FALSE(first_found(path, Return::Sense::backward));
}

TEST(VisitedStates, SketchesPreserveDistances) {
    const auto input = sphere_case(2, 4);
    const fem::System system(input, PETSC_COMM_WORLD);
    const auto x = system.make_vector(), y = system.make_vector();
    SOFT_PETSC(VecSet(x, 1.0));
    for (PetscInt i = system.dofs().begin; i < system.dofs().end; ++i)
        SOFT_PETSC(VecSetValue(y, i, std::sin(static_cast<double>(i)), INSERT_VALUES));
    SOFT_PETSC(VecAssemblyBegin(y));
    SOFT_PETSC(VecAssemblyEnd(y));
    const Sketch a = sketch_of(x), b = sketch_of(y);
    double distance2 = 0;
    for (std::size_t j = 0; j < sketch_size; ++j) distance2 += (a[j] - b[j]) * (a[j] - b[j]);
    linalg::add(x, -1.0, y);
    // chi squared with 16 degrees of freedom: within a factor of 2 with a probability of 99.3 %; the signs are always the same
    EXPECT_GT(std::sqrt(distance2) / linalg::norm(x), 0.5);
    EXPECT_LT(std::sqrt(distance2) / linalg::norm(x), 2.0);
}

// Beyond the pressure minimum of a Mooney-Rivlin shell the branch on which one of two spheres is larger returns to the path and
// continues as its mirror image: a closed curve.
TEST(VisitedStates, AClosedBranchOfTwoSpheresIsFollowedOnce) {
    auto input = two_spheres_case(1, 6, 200.0);
    for (auto& point : input.mesh.points) {  // thin walls, outer radius 1.1 inner radii: the shells stay spheres
        const double radius = std::hypot(point[0], point[1], point[2]);
        for (double& x : point) x *= (0.01 + 0.1 * (radius - 0.01)) / radius;
    }
    input.materials[0].law = "mooney-rivlin";
    input.materials[0].constants = {{"c10", {0.45 * sample_mu_Pa}}, {"c01", {0.045 * sample_mu_Pa}}};
    input.path.branch = model::Branch::follow;
    input.path.imperfection_m = 1e-4;
    input.path.stretch_limit = 50;
    input.solver.step_limit = 600;
    const auto [steps, end, log] = run(input);
    EXPECT_EQ(end.reason, model::StopReason::limit_point);
    EXPECT_NE(end.detail.find("the path is closed"), std::string::npos) << end.detail;
    // Pressure and both volumes of the last row lie on the line between two rows of the branch, up to its curvature.
    const auto values_of = [](const model::Step& step) {
        return std::array{step.pressure_Pa / sample_mu_Pa, step.volumes_m3[0] / sphere_cavity_m3 / 100,
                          step.volumes_m3[1] / sphere_cavity_m3 / 100};
    };
    const auto last = values_of(steps.back());
    double least = 1;
    ASSERT_FALSE(end.bifurcations.empty());
    for (auto i = static_cast<std::size_t>(end.bifurcations[0].at.step) + 1; i + 5 < steps.size(); ++i) {
        const auto a = values_of(steps[i]), b = values_of(steps[i + 1]);
        double along = 0, length2 = 0, distance2 = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            along += (last[j] - a[j]) * (b[j] - a[j]);
            length2 += (b[j] - a[j]) * (b[j] - a[j]);
        }
        const double t = length2 > 0 ? std::clamp(along / length2, 0.0, 1.0) : 0;
        for (std::size_t j = 0; j < 3; ++j) distance2 += std::pow(a[j] + t * (b[j] - a[j]) - last[j], 2);
        least = std::min(least, std::sqrt(distance2));
    }
    EXPECT_LT(least, 0.01);
}

}  // namespace
}  // namespace soft::solver
