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
    SOFT_PETSC(MatAssemblyBegin(A, MAT_FINAL_ASSEMBLY));
    SOFT_PETSC(MatAssemblyEnd(A, MAT_FINAL_ASSEMBLY));
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

TEST(LinearSolver, CorrectsTheUnsymmetricPartThatTheFactorDoesNotSee) {
    const auto A = dense(3, {4, 1, 1, 0.7, 3, 2, 1, 1.8, 0});
    LinearSolver solver(A);
    EXPECT_TRUE(solver.factorize().succeeded);
    EXPECT_LT(residual_after_solve(solver, A), 1e-8);
}

TEST(LinearSolver, GoesOverToLuWhereTheUnsymmetricPartIsLarge) {
    // LDL^T reads the upper triangle; this lower one has nothing to do with it.
    std::vector<double> values(400);
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 20; ++j) values[20 * i + j] = i == j ? 30.0 : (j > i ? 4.0 : -5.0 + (7 * i + 3 * j) % 11);
    const auto A = dense(20, values);
    LinearSolver solver(A);
    EXPECT_TRUE(solver.factorize().negative_pivots.has_value());
    EXPECT_LT(residual_after_solve(solver, A), 1e-8);
    EXPECT_EQ(solver.factorizations(), 2);
    EXPECT_FALSE(solver.factorize().negative_pivots.has_value());   // LU knows no inertia
}

TEST(LinearSolver, SolvesAChangedMatrixWithTheOldFactor) {
    auto A = dense(3, {4, 1, 1, 1, 3, 2, 1, 2, 5});
    LinearSolver solver(A);
    EXPECT_TRUE(solver.factorize().succeeded);
    SOFT_PETSC(MatSetValue(A, 0, 0, 4.5, INSERT_VALUES));
    SOFT_PETSC(MatAssemblyBegin(A, MAT_FINAL_ASSEMBLY));
    SOFT_PETSC(MatAssemblyEnd(A, MAT_FINAL_ASSEMBLY));
    EXPECT_LT(residual_after_solve(solver, A), 1e-8);
    EXPECT_EQ(solver.factorizations(), 1);
}

TEST(LinearSolver, ReportsASingularMatrixAsAValue) {
    const auto A = dense(2, {1, 1, 1, 1});
    LinearSolver solver(A);
    Vector x, b;
    SOFT_PETSC(MatCreateVecs(A, x.out(), b.out()));
    SOFT_PETSC(VecSetValue(b, 0, 1.0, INSERT_VALUES));   // not in the range of A
    SOFT_PETSC(VecAssemblyBegin(b));
    SOFT_PETSC(VecAssemblyEnd(b));
    EXPECT_FALSE(solver.factorize().succeeded && solver.solve(b, x).converged);
}

}  // namespace
}  // namespace soft::linalg
