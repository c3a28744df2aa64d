// Reference: LAPACK. Solutions from dense LU, signatures from dense eigenvalues.
#include "linalg/multifrontal.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "linalg/matrix_rows.hpp"
#include "linalg/small_matrix.hpp"

namespace soft::linalg {
namespace {

enum class Zeros { keep, omit };

Matrix sparse(const SmallMatrix& A, Zeros zeros = Zeros::keep) {
    Matrix K;
    SOFT_PETSC(MatCreateSeqAIJ(PETSC_COMM_SELF, A.size, A.size, A.size, nullptr, K.out()));
    for (int i = 0; i < A.size; ++i)
        for (int j = 0; j < A.size; ++j)
            if (zeros == Zeros::keep || i == j || A.at(i, j) != 0.0 || A.at(j, i) != 0.0)
                SOFT_PETSC(MatSetValue(K, i, j, A.at(i, j), INSERT_VALUES));
    assemble(K);
    return K;
}

/// `stiff` displacements and `pressures` pressures, [A B^T; B -C], with a spring of stiffness `weakest` in the middle.
SmallMatrix saddle_point(int stiff, int pressures, double compliance, double weakest) {
    SmallMatrix A(stiff + pressures);
    for (int i = 0; i < stiff; ++i) {
        A.at(i, i) = i == stiff / 2 ? weakest : 4.0 + i % 3;
        if (i > 0) A.at(i, i - 1) = A.at(i - 1, i) = -1.0;
    }
    for (int s = 0; s < pressures; ++s) {
        A.at(stiff + s, stiff + s) = -compliance;
        for (int i = 0; i < stiff; ++i) A.at(stiff + s, i) = A.at(i, stiff + s) = std::sin((0.7 + 0.9 * s) * (i + 0.5));
    }
    return A;
}

double error_of_solve(Multifrontal& factor, const SmallMatrix& A) {
    const auto K = sparse(A);
    Vector b, x;
    SOFT_PETSC(MatCreateVecs(K, x.out(), b.out()));
    std::vector<double> right;
    for (int i = 0; i < A.size; ++i) right.push_back(std::cos(i));
    spread(right, b);
    factor.solve(b, x);
    const auto exact = solve(A, right).value(), found = gather(x);
    double error = 0, size = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        error = std::hypot(error, found[i] - exact[i]);
        size = std::hypot(size, exact[i]);
    }
    return error / size;
}

TEST(Multifrontal, SolvesASaddlePointAndCountsItsNegativeEigenvalues) {
    const auto A = saddle_point(12, 4, 0.01, 5.0);
    Multifrontal factor(sparse(A));
    ASSERT_TRUE(factor.factorize(sparse(A)));
    EXPECT_LT(error_of_solve(factor, A), 1e-13);
    EXPECT_EQ(factor.negative_pivots(), 4);
    EXPECT_EQ(factor.negative_pivots(), negative_eigenvalues(A));
}

TEST(Multifrontal, PressuresWithoutCompliancePerturbTheSolutionByNoMoreThanTheBound) {
    const auto A = saddle_point(12, 4, 0.0, 5.0);
    Multifrontal factor(sparse(A));
    ASSERT_TRUE(factor.factorize(sparse(A)));
    EXPECT_LT(error_of_solve(factor, A), 1e-5);  // of the order of the bound, 1e-6
    EXPECT_EQ(factor.negative_pivots(), 4);
}

TEST(Multifrontal, CountsNegativeEigenvaluesOfAnUnstableState) {
    const auto A = saddle_point(12, 2, 0.01, -9.0);
    Multifrontal factor(sparse(A));
    ASSERT_TRUE(factor.factorize(sparse(A)));
    EXPECT_GT(negative_eigenvalues(A), 2);
    EXPECT_EQ(factor.negative_pivots(), negative_eigenvalues(A));
    EXPECT_LT(error_of_solve(factor, A), 1e-12);
}

TEST(Multifrontal, FactorisesNewValuesWithTheSamePattern) {
    const auto first = saddle_point(9, 3, 0.02, 6.0), second = saddle_point(9, 3, 0.5, 2.0);
    Multifrontal factor(sparse(first));
    ASSERT_TRUE(factor.factorize(sparse(first)));
    ASSERT_TRUE(factor.factorize(sparse(second)));
    EXPECT_LT(error_of_solve(factor, second), 1e-13);
}

TEST(Multifrontal, ReadsOnlyTheEntryInTheRowEliminatedFirst) {  // the rows of a dense matrix keep their order
    const auto A = saddle_point(6, 2, 0.1, 5.0);
    auto other_below = A;
    for (int i = 0; i < A.size; ++i)
        for (int j = 0; j < i; ++j) other_below.at(i, j) = 100.0 + i;
    Multifrontal factor(sparse(A));
    ASSERT_TRUE(factor.factorize(sparse(other_below)));
    EXPECT_LT(error_of_solve(factor, A), 1e-13);
}

/// A, and an unsymmetric part between some unknowns far apart.
SmallMatrix with_unsymmetric_part(SmallMatrix A, const std::vector<PetscInt>& unknowns) {
    for (const PetscInt i : unknowns)
        for (const PetscInt j : unknowns) {
            A.at(static_cast<int>(i), static_cast<int>(j)) += 0.4 * std::sin(1.0 + 3.0 * i + j);
            if (i == j) A.at(static_cast<int>(i), static_cast<int>(j)) += 2.0;
        }
    return A;
}

TEST(Multifrontal, SolvesWithBothTrianglesOfTheLastUnknowns) {
    const std::vector<PetscInt> last{1, 4, 11};
    const auto A = with_unsymmetric_part(saddle_point(30, 0, 0.0, 5.0), last);
    const Matrix K = sparse(A, Zeros::omit);
    EXPECT_EQ(unsymmetric_unknowns(K), last);
    Multifrontal factor(K, 1, last), of_one_triangle(K);
    ASSERT_TRUE(factor.factorize(K) && of_one_triangle.factorize(K));
    EXPECT_LT(error_of_solve(factor, A), 1e-13);
    EXPECT_GT(error_of_solve(of_one_triangle, A), 1e-3);
    EXPECT_EQ(factor.negative_pivots(), 0);
    auto transposed = A;
    for (int i = 0; i < A.size; ++i)
        for (int j = 0; j < A.size; ++j) transposed.at(i, j) = A.at(j, i);
    factor.set_transposed(true);
    EXPECT_LT(error_of_solve(factor, transposed), 1e-13);
    Multifrontal of_one_group(sparse(A), 1, last);  // all unknowns couple: each is in the group of the last ones
    ASSERT_TRUE(of_one_group.factorize(sparse(A)));
    EXPECT_LT(error_of_solve(of_one_group, A), 1e-13);
}

TEST(Multifrontal, FindsNoUnsymmetricUnknownsInRounding) {
    auto A = saddle_point(12, 4, 0.1, 5.0);
    A.at(3, 4) *= 1.0 + 1e-13;
    EXPECT_TRUE(unsymmetric_unknowns(sparse(A)).empty());
}

TEST(Multifrontal, FailsForAMatrixWithoutPivots) {
    SmallMatrix A(2);
    A.at(0, 1) = A.at(1, 0) = 1.0;  // both diagonals are zero, so there is no scale for a replacement
    Multifrontal factor(sparse(A));
    EXPECT_FALSE(factor.factorize(sparse(A)));
}

TEST(Multifrontal, ReportsTheFlopsOfAFactorisation) {
    SmallMatrix A(10);
    for (int i = 0; i < 10; ++i)
        for (int j = 0; j < 10; ++j) A.at(i, j) = i == j ? 10.0 : 1.0;
    EXPECT_NEAR(Multifrontal(sparse(A)).flops(), 1000.0 / 3.0, 1e-9);  // dense: n^3 / 3
}

/// Seven-point differences on a grid of n^3 points, with a random part of the diagonal; every third point has a pressure that couples
/// with its neighbours along x.
Matrix grid(int n, double weakest) {
    const int points = n * n * n, pressures = points / 3;
    Matrix K;
    SOFT_PETSC(MatCreateSeqAIJ(PETSC_COMM_SELF, points + pressures, points + pressures, 12, nullptr, K.out()));
    const auto set = [&](int i, int j, double value) {
        SOFT_PETSC(MatSetValue(K, i, j, value, INSERT_VALUES));
        SOFT_PETSC(MatSetValue(K, j, i, value, INSERT_VALUES));
    };
    for (int p = 0; p < points; ++p) {
        set(p, p, p == points / 2 ? weakest : 6.5 + std::sin(p));
        if (p % n > 0) set(p, p - 1, -1.0);
        if (p / n % n > 0) set(p, p - n, -1.0);
        if (p / (n * n) > 0) set(p, p - n * n, -1.0);
    }
    for (int s = 0; s < pressures; ++s) {
        set(points + s, points + s, 0.0);
        set(points + s, 3 * s, 1.0 + 0.3 * std::cos(s));
        set(points + s, 3 * s + 1, -1.0);
    }
    assemble(K);
    return K;
}

struct GridSolution {
    std::vector<double> x;
    double residual;
    int negative;
};

GridSolution solve_grid(int n, double weakest, int threads) {
    const auto K = grid(n, weakest);
    Multifrontal factor(K, threads);
    Vector b, x, r;
    SOFT_PETSC(MatCreateVecs(K, x.out(), b.out()));
    SOFT_PETSC(VecSet(b, 1.0));
    r = duplicate(b);
    EXPECT_TRUE(factor.factorize(K));
    factor.solve(b, x);
    SOFT_PETSC(MatMult(K, x, r));
    add(r, -1.0, b);
    return {gather(x), norm(r) / norm(b), static_cast<int>(factor.negative_pivots().value_or(-1))};
}

TEST(Multifrontal, FactorisesFrontsOfManyTilesWithTheSameBytesForAnyNumberOfThreads) {
    constexpr int n = 18;  // the largest front has about 500 rows
    const auto one = solve_grid(n, 7.0, 1);
    EXPECT_LT(one.residual, 1e-4);  // of the order of the bound of the pressures' diagonal, 1e-6
    EXPECT_EQ(one.negative, n * n * n / 3);
    for (const int threads : {2, 3}) {
        const auto several = solve_grid(n, 7.0, threads);
        EXPECT_EQ(several.x, one.x) << threads;
        EXPECT_EQ(several.negative, one.negative);
    }
    EXPECT_EQ(solve_grid(n, -40.0, 2).negative, n * n * n / 3 + 1);
}

}  // namespace
}  // namespace soft::linalg
