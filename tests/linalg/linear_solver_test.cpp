#include "linalg/linear_solver.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace soft::linalg {
namespace {

Matrix dense(PetscInt n, const std::vector<double>& values) {
    Matrix A;
    SOFT_PETSC(MatCreateSeqAIJ(PETSC_COMM_SELF, n, n, n, nullptr, A.out()));
    for (PetscInt i = 0; i < n; ++i)
        for (PetscInt j = 0; j < n; ++j) SOFT_PETSC(MatSetValue(A, i, j, values[i * n + j], INSERT_VALUES));
    assemble(A);
    return A;
}

double residual_after_solve(LinearSolver& solver, Mat A) {
    Vector x, b;
    SOFT_PETSC(MatCreateVecs(A, x.out(), b.out()));
    PetscInt n = 0;
    SOFT_PETSC(VecGetSize(b, &n));
    for (PetscInt i = 0; i < n; ++i) SOFT_PETSC(VecSetValue(b, i, 1.0 + static_cast<double>(i), INSERT_VALUES));
    const double size = norm(b);
    EXPECT_TRUE(solver.solve(b, x).converged);
    SOFT_PETSC(VecScale(b, -1.0));
    SOFT_PETSC(MatMultAdd(A, x, b, b));
    return norm(b) / size;
}

TEST(LinearSolver, CountsTheNegativePivotsOfASaddlePoint) {
    // Two displacements, one pressure with a zero diagonal: signature (2, 1).
    const auto A = dense(3, {4, 1, 1, 1, 3, 2, 1, 2, 0});
    LinearSolver solver(A);
    const auto factor = solver.factorize();
    EXPECT_TRUE(factor.succeeded);
    EXPECT_EQ(factor.negative_pivots, 1);
    EXPECT_LT(residual_after_solve(solver, A), 1e-12);
}

TEST(LinearSolver, CorrectsTheUnsymmetricPartThatLdltIgnores) {
    const auto A = dense(3, {4, 1, 1, 0.7, 3, 2, 1, 1.8, 0});
    LinearSolver solver(A);
    EXPECT_TRUE(solver.factorize().succeeded);
    EXPECT_LT(residual_after_solve(solver, A), 1e-8);
}

TEST(LinearSolver, SwitchesToLuIfTheUnsymmetricPartIsLarge) {
    // LDL^T reads the upper triangle only; this lower triangle is unrelated to it.
    std::vector<double> values(400);
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 20; ++j) values[20 * i + j] = i == j ? 30.0 : (j > i ? 4.0 : -5.0 + (7 * i + 3 * j) % 11);
    const auto A = dense(20, values);
    LinearSolver solver(A);
    EXPECT_TRUE(solver.factorize().negative_pivots.has_value());
    EXPECT_LT(residual_after_solve(solver, A), 1e-8);
    EXPECT_GE(solver.factorizations(), 2);
    EXPECT_FALSE(solver.factorize().negative_pivots.has_value());  // LU does not give the inertia
}

TEST(LinearSolver, SolvesAChangedMatrixWithAStaleFactor) {
    auto A = dense(3, {4, 1, 1, 1, 3, 2, 1, 2, 5});
    LinearSolver solver(A);
    EXPECT_TRUE(solver.factorize().succeeded);
    SOFT_PETSC(MatSetValue(A, 0, 0, 4.5, INSERT_VALUES));
    assemble(A);
    EXPECT_LT(residual_after_solve(solver, A), 1e-8);
    EXPECT_EQ(solver.factorizations(), 1);
}

TEST(LinearSolver, ReportsASingularMatrixAsAValue) {
    const auto A = dense(2, {1, 1, 1, 1});
    LinearSolver solver(A);
    Vector x, b;
    SOFT_PETSC(MatCreateVecs(A, x.out(), b.out()));
    SOFT_PETSC(VecSetValue(b, 0, 1.0, INSERT_VALUES));  // not in the range of A
    assemble(b);
    EXPECT_FALSE(solver.factorize().succeeded && solver.solve(b, x).converged);
}

/// 1D Laplacian: positive definite, condition (n / pi)^2 / 4 or so.
Matrix laplacian(PetscInt n) {
    Matrix A;
    SOFT_PETSC(MatCreateSeqAIJ(PETSC_COMM_SELF, n, n, 3, nullptr, A.out()));
    for (PetscInt i = 0; i < n; ++i) {
        SOFT_PETSC(MatSetValue(A, i, i, 2.0, INSERT_VALUES));
        if (i > 0) SOFT_PETSC(MatSetValue(A, i, i - 1, -1.0, INSERT_VALUES));
        if (i + 1 < n) SOFT_PETSC(MatSetValue(A, i, i + 1, -1.0, INSERT_VALUES));
    }
    assemble(A);
    return A;
}

LinearSettings settings_of(LinearMethod method, Preconditioner preconditioner = Preconditioner::asm_lu) {
    LinearSettings settings;
    settings.method = method;
    settings.preconditioner = preconditioner;
    return settings;
}

TEST(LinearSolver, EveryFactorisationSolvesAPositiveDefiniteSystemInTwoIterations) {
    const auto A = laplacian(200);
    for (const auto method : {LinearMethod::automatic, LinearMethod::mumps_ldlt, LinearMethod::mumps_lu,
                              LinearMethod::superlu_dist, LinearMethod::cholmod}) {
        LinearSolver solver(A, Symmetry::symmetric, settings_of(method));
        EXPECT_TRUE(solver.factorize().succeeded);
        EXPECT_LT(residual_after_solve(solver, A), 1e-10);
        EXPECT_LE(solver.iterations(), 2);
    }
}

TEST(LinearSolver, ConvergesWithEveryPreconditioner) {
    const auto A = laplacian(200);
    for (const auto preconditioner :
         {Preconditioner::lu, Preconditioner::asm_lu, Preconditioner::asm_ilu, Preconditioner::asm_boomeramg,
          Preconditioner::boomeramg, Preconditioner::gamg, Preconditioner::jacobi, Preconditioner::none}) {
        auto settings = settings_of(LinearMethod::krylov, preconditioner);
        settings.iteration_limit = 300;
        LinearSolver solver(A, Symmetry::symmetric, settings);
        EXPECT_TRUE(solver.factorize().succeeded);
        EXPECT_LT(residual_after_solve(solver, A), 1e-8);
        EXPECT_GT(solver.iterations(), 0);
    }
}

TEST(LinearSolver, CholmodReportsAnIndefiniteMatrixAsAValueAndRecovers) {
    auto A = laplacian(50);
    LinearSolver solver(A, Symmetry::symmetric, settings_of(LinearMethod::cholmod));
    SOFT_PETSC(MatSetValue(A, 20, 20, -2.0, INSERT_VALUES));
    assemble(A);
    EXPECT_FALSE(solver.factorize().succeeded);
    SOFT_PETSC(MatSetValue(A, 20, 20, 2.0, INSERT_VALUES));
    assemble(A);
    EXPECT_TRUE(solver.factorize().succeeded);
    EXPECT_LT(residual_after_solve(solver, A), 1e-10);
}

TEST(LinearSolver, IluReportsAZeroPivotAsAValue) {
    const auto A = dense(2, {0, 1, 1, 0});
    LinearSolver solver(A, Symmetry::symmetric, settings_of(LinearMethod::krylov, Preconditioner::asm_ilu));
    Vector x, b;
    SOFT_PETSC(MatCreateVecs(A, x.out(), b.out()));
    SOFT_PETSC(VecSet(b, 1.0));
    EXPECT_FALSE(solver.factorize().succeeded && solver.solve(b, x).converged);
}

TEST(LinearSolver, DoesNotSwitchFromAUserSelectedMethod) {
    std::vector<double> values(400);  // as above: LDL^T reads one triangle only
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 20; ++j) values[20 * i + j] = i == j ? 30.0 : (j > i ? 4.0 : -5.0 + (7 * i + 3 * j) % 11);
    const auto A = dense(20, values);
    LinearSolver solver(A, Symmetry::symmetric, settings_of(LinearMethod::mumps_ldlt));
    EXPECT_TRUE(solver.factorize().succeeded);
    EXPECT_LT(residual_after_solve(solver, A), 1e-8);
    EXPECT_EQ(solver.factorizations(), 1);
    EXPECT_GT(solver.iterations(), 6);
}

TEST(LinearSolver, KrylovSolveKeepsItsBestIterateAtTheLimitAndCanContinue) {
    const auto A = laplacian(100);
    auto settings = settings_of(LinearMethod::krylov, Preconditioner::jacobi);
    settings.iteration_limit = 60;
    LinearSolver solver(A, Symmetry::symmetric, settings);
    ASSERT_TRUE(solver.factorize().succeeded);
    Vector x, b, r;
    SOFT_PETSC(MatCreateVecs(A, x.out(), b.out()));
    r = duplicate(b);
    SOFT_PETSC(VecSet(b, 1.0));
    const auto residual = [&] {
        SOFT_PETSC(MatMult(A, x, r));
        add(r, -1.0, b);
        return norm(r) / norm(b);
    };
    const auto first = solver.solve(b, x);  // symmetric right-hand side: exact after 50
    EXPECT_TRUE(first.converged);
    SOFT_PETSC(VecSetValue(b, 3, 2.0, INSERT_VALUES));
    assemble(b);
    const auto second = solver.solve(b, x);
    EXPECT_TRUE(second.at_limit && second.usable());
    EXPECT_FALSE(second.converged);
    EXPECT_EQ(second.iterations, 60);
    const double before = residual();
    EXPECT_LT(before, 1.0);
    auto more = solver.solve(b, x, {.starts_from_x = true});
    EXPECT_LT(residual(), before);
    for (int i = 0; i < 200 && more.at_limit; ++i) more = solver.solve(b, x, {.starts_from_x = true});
    EXPECT_TRUE(more.converged);
    EXPECT_LT(residual(), 1e-8);
}

TEST(LinearSolver, StopsAtMaxIterationsWithAnEarlierFactorAndStartsFromANearbySolution) {
    const auto A = laplacian(100);
    LinearSolver solver(A);
    ASSERT_TRUE(solver.factorize().succeeded);
    SOFT_PETSC(MatShift(A, 0.3));
    Vector x, b;
    SOFT_PETSC(MatCreateVecs(A, x.out(), b.out()));
    SOFT_PETSC(VecSet(b, 1.0));
    SOFT_PETSC(VecSetValue(b, 3, 2.0, INSERT_VALUES));
    assemble(b);
    const auto full = solver.solve(b, x, {.factor = Factor::stale});
    EXPECT_TRUE(full.converged);
    EXPECT_GT(full.iterations, 3);
    const auto few = solver.solve(b, duplicate(x), {.factor = Factor::stale, .max_iterations = 2});
    EXPECT_EQ(few.iterations, 2);
    EXPECT_FALSE(few.usable());
    SOFT_PETSC(MatShift(A, 1e-5));
    const auto near = solver.solve(b, x, {.factor = Factor::stale, .starts_from_x = true});
    EXPECT_TRUE(near.converged);
    EXPECT_LT(near.iterations, full.iterations);
    EXPECT_TRUE(solver.solve(b, x, {.factor = Factor::stale}).converged);  // the limit of one solve only
}

TEST(LinearSolver, StopsAtTheRequestedTolerance) {
    const auto A = laplacian(200);
    long iterations = 0;
    for (const double tolerance : {1e-2, 1e-10}) {
        auto settings = settings_of(LinearMethod::krylov, Preconditioner::gamg);
        settings.tolerance = tolerance;
        LinearSolver solver(A, Symmetry::symmetric, settings);
        ASSERT_TRUE(solver.factorize().succeeded);
        EXPECT_LT(residual_after_solve(solver, A), tolerance);
        EXPECT_GT(solver.iterations(), iterations);
        iterations = solver.iterations();
    }
}

}  // namespace
}  // namespace soft::linalg
