// Every linear solver of model::LinearSettings on small bodies: the same curve, at different cost.
#include <gtest/gtest.h>

#include <cmath>

#include "../fem/sample_cases.hpp"
#include "bench.hpp"
#include "fem/near_nullspace.hpp"
#include "mesh/split.hpp"

namespace soft::solver {
namespace {

using model::LinearMethod;
using model::Preconditioner;

constexpr int rows = 4;

/// The box pulled in `rows` equal steps, so that every solver has rows at the same load factors.
model::Case pulled_box(model::Formulation formulation) {
    auto input = box_case(2, false);
    input.formulation = formulation;
    input.materials[0].bulk_modulus_Pa = 5 * sample_mu_Pa;
    input.supports[0].fixed = {true, true, true};                  // clamped: no homogeneous state
    input.path.stages[0].supplies[0].value = -0.4 * sample_mu_Pa;  // well below the maximum of its load
    input.solver.steps = model::StepRule::constant;
    input.solver.first_step = 1.0 / rows;
    input.solver.residual_tolerance = 1e-11;
    input.solver.linear.iteration_limit = 600;
    return input;
}

void expect_the_curve_of_the_default(const model::Case& input, LinearMethod method, Preconditioner preconditioner) {
    const auto wanted = run(input).steps;
    auto other = input;
    other.solver.linear.method = method;
    other.solver.linear.preconditioner = preconditioner;
    const auto found = run(other);
    const std::string what = "method " + std::to_string(static_cast<int>(method)) + ", preconditioner " +
                             std::to_string(static_cast<int>(preconditioner));
    ASSERT_EQ(found.end.reason, model::StopReason::done) << what << ": " << found.end.detail;
    ASSERT_EQ(found.steps.size(), wanted.size()) << what;
    for (std::size_t i = 1; i < wanted.size(); ++i) {
        EXPECT_NEAR(found.steps[i].load_factor, wanted[i].load_factor, 1e-14) << what;
        EXPECT_NEAR(found.steps[i].outputs[0] / wanted[i].outputs[0], 1.0, 1e-8) << what;
    }
}

TEST(LinearMethods, EveryFactorisationGivesTheSameCurve) {
    const auto input = pulled_box(model::Formulation::displacement);
    for (const auto method :
         {LinearMethod::mumps_ldlt, LinearMethod::mumps_lu, LinearMethod::superlu_dist, LinearMethod::cholmod})
        expect_the_curve_of_the_default(input, method, Preconditioner::none);
}

TEST(LinearMethods, EveryPreconditionerGivesTheSameCurve) {
    const auto input = pulled_box(model::Formulation::displacement);
    for (const auto preconditioner : {Preconditioner::lu, Preconditioner::asm_lu, Preconditioner::asm_ilu,
                                      Preconditioner::asm_boomeramg, Preconditioner::boomeramg, Preconditioner::gamg,
                                      Preconditioner::multigrid, Preconditioner::jacobi, Preconditioner::none})
        expect_the_curve_of_the_default(input, LinearMethod::krylov, preconditioner);
}

TEST(LinearMethods, PivotingFactorisationsGiveTheSameCurveWithPressureUnknowns) {
    const auto input = pulled_box(model::Formulation::mixed);
    for (const auto method : {LinearMethod::mumps_ldlt, LinearMethod::mumps_lu, LinearMethod::superlu_dist})
        expect_the_curve_of_the_default(input, method, Preconditioner::none);
    auto incompressible = input;  // zeros on the diagonal
    incompressible.materials[0].bulk_modulus_Pa.reset();
    for (const auto method : {LinearMethod::mumps_lu, LinearMethod::superlu_dist})
        expect_the_curve_of_the_default(incompressible, method, Preconditioner::none);
    for (const auto preconditioner : {Preconditioner::lu, Preconditioner::asm_lu})
        expect_the_curve_of_the_default(input, LinearMethod::krylov, preconditioner);
}

TEST(LinearMethods, MultigridGivesTheSameCurveWithPressureUnknowns) {
    auto input = pulled_box(model::Formulation::mixed);
    auto tetrahedra = input;  // Taylor and Hood: a pressure at each vertex
    tetrahedra.mesh = mesh::split_into_simplices(input.mesh);
    auto incompressible = input;
    incompressible.materials[0].bulk_modulus_Pa.reset();
    for (const auto& body : {input, tetrahedra, incompressible})
        expect_the_curve_of_the_default(body, LinearMethod::krylov, Preconditioner::multigrid);
    expect_the_curve_of_the_default(input, LinearMethod::jacobian_free, Preconditioner::multigrid);
}

/// Iterations of the first linear solve of a clamped box of n x n x n mixed cells, incompressible.
int multigrid_iterations(int n) {
    auto input = pulled_box(model::Formulation::mixed);
    input.mesh = box_case(n, true).mesh;
    input.materials[0].bulk_modulus_Pa.reset();
    input.solver.linear.method = LinearMethod::krylov;
    input.solver.linear.preconditioner = Preconditioner::multigrid;
    Bench bench(input, input.solver);
    EXPECT_TRUE(bench.newton.tangent({ConstraintKind::load_factor}, bench.rest()));
    return static_cast<int>(bench.newton.linear_iterations());
}

// The published bounds of the smoother, the coarse space and the Schur complement do not depend on the cell size.
TEST(LinearMethods, IterationsOfMultigridDoNotGrowWithTheMesh) {
    EXPECT_LE(multigrid_iterations(8), 1.2 * multigrid_iterations(4));
}

TEST(LinearMethods, JacobianFreeGivesTheSameCurve) {
    for (const auto formulation : {model::Formulation::displacement, model::Formulation::mixed})
        expect_the_curve_of_the_default(pulled_box(formulation), LinearMethod::jacobian_free, Preconditioner::asm_lu);
    expect_the_curve_of_the_default(pulled_box(model::Formulation::displacement), LinearMethod::jacobian_free,
                                    Preconditioner::gamg);
}

// K of mixed cells is indefinite from the start: Sylvester, one negative pivot per pressure.
TEST(LinearMethods, CholmodReportsATangentThatIsNotDefinite) {
    auto input = pulled_box(model::Formulation::mixed);
    input.solver.linear.method = LinearMethod::cholmod;
    Bench bench(input, input.solver);
    State state = bench.rest();
    EXPECT_EQ(bench.newton.correct({ConstraintKind::load_factor}, 0.1, state).end, NewtonEnd::not_definite);
    EXPECT_FALSE(bench.newton.tangent({ConstraintKind::load_factor}, bench.rest()));
    EXPECT_EQ(bench.newton.tangent_end(), NewtonEnd::not_definite);
}

TEST(LinearMethods, RigidMotionsReduceTheIterationsOfGamg) {
    auto input = pulled_box(model::Formulation::displacement);
    input.materials[0].bulk_modulus_Pa = sample_mu_Pa;
    Bench bench(input, input.solver);
    auto K = bench.system.make_matrix();
    auto R = bench.system.make_vector(), x = bench.system.make_vector(), b = bench.system.make_vector();
    const auto levels = bench.loads.levels(0.0, {});
    (void)bench.system.evaluate(x, bench.loads.levels(0.5, {}), b, K);
    (void)bench.system.evaluate(x, levels, R, K);
    model::LinearSettings settings;
    settings.method = LinearMethod::krylov;
    settings.preconditioner = Preconditioner::gamg;
    settings.iteration_limit = 200;
    const auto iterations = [&] {
        linalg::LinearSolver solver(K, linalg::Symmetry::symmetric, settings);
        EXPECT_TRUE(solver.factorize().succeeded);
        const auto solve = solver.solve(b, x);
        EXPECT_TRUE(solve.converged);
        return solve.iterations;
    };
    const int without = iterations();
    fem::attach_rigid_motions(bench.system, K);
    EXPECT_LT(iterations(), without);
}

TEST(LinearMethods, APathReportsALinearLimitThatIsFarTooLow) {
    auto input = pulled_box(model::Formulation::displacement);
    input.solver.linear = {LinearMethod::krylov, Preconditioner::none, 1e-8, 1};
    const auto [steps, end, log] = run(input);
    EXPECT_EQ(end.reason, model::StopReason::diverged);
    EXPECT_NE(end.detail.find("solver.linear_limit"), std::string::npos) << end.detail;
    ASSERT_EQ(steps.size(), 1u);
    EXPECT_EQ(steps[0].outputs[0], 0.0);
}

TEST(LinearMethods, InexactCorrectionsConvergeToEquilibrium) {
    auto input = pulled_box(model::Formulation::displacement);
    input.solver.newton_limit = 60;
    input.solver.linear = {LinearMethod::krylov, Preconditioner::asm_ilu, 1e-8, 6};
    Bench inexact(input, input.solver);
    State state = inexact.rest();
    const auto result = inexact.newton.correct({ConstraintKind::load_factor}, 0.2, state);
    EXPECT_EQ(result.end, NewtonEnd::converged);
    input.solver.linear = {};
    Bench exact(input, input.solver);
    State wanted = exact.rest();
    const auto direct = exact.newton.correct({ConstraintKind::load_factor}, 0.2, wanted);
    EXPECT_GT(result.iterations, direct.iterations);
    EXPECT_NEAR(
        inexact.system.outputs().value(0, state.x, nullptr) / exact.system.outputs().value(0, wanted.x, nullptr), 1.0,
        1e-8);
    EXPECT_GT(inexact.newton.linear_iterations(), exact.newton.linear_iterations());
}

TEST(LinearMethods, OnlyAFactorisationWithPivotsDeterminesStability) {
    auto input = pulled_box(model::Formulation::displacement);
    const auto modes = [&](LinearMethod method, Preconditioner preconditioner) {
        input.solver.linear.method = method;
        input.solver.linear.preconditioner = preconditioner;
        Bench bench(input, input.solver);
        const auto tangent = bench.newton.tangent({ConstraintKind::load_factor}, bench.rest());
        return tangent ? tangent->unstable_modes : std::optional<int>(-1);
    };
    EXPECT_EQ(modes(LinearMethod::mumps_ldlt, Preconditioner::none), 0);
    EXPECT_EQ(modes(LinearMethod::mumps_lu, Preconditioner::none), 0);
    EXPECT_EQ(modes(LinearMethod::superlu_dist, Preconditioner::none), std::nullopt);
    EXPECT_EQ(modes(LinearMethod::krylov, Preconditioner::boomeramg), std::nullopt);
}

}  // namespace
}  // namespace soft::solver
