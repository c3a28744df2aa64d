// Reference: LAPACK. Solutions from dense LU, signatures from dense eigenvalues.
#include "linalg/sparse_ldlt.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "linalg/small_matrix.hpp"

namespace soft::linalg {
namespace {

Matrix sparse(const SmallMatrix& A) {
    Matrix K;
    SOFT_PETSC(MatCreateSeqAIJ(PETSC_COMM_SELF, A.size, A.size, A.size, nullptr, K.out()));
    for (int i = 0; i < A.size; ++i)
        for (int j = 0; j < A.size; ++j) SOFT_PETSC(MatSetValue(K, i, j, A.at(i, j), INSERT_VALUES));
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

double error_of_solve(SparseLdlt& factor, const SmallMatrix& A) {
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

TEST(SparseLdlt, SolvesASaddlePointAndCountsItsNegativeEigenvalues) {
    const auto A = saddle_point(12, 4, 0.01, 5.0);
    SparseLdlt factor(sparse(A));
    ASSERT_TRUE(factor.factorize(sparse(A)));
    EXPECT_LT(error_of_solve(factor, A), 1e-13);
    EXPECT_EQ(factor.negative_pivots(), 4);
    EXPECT_EQ(factor.negative_pivots(), negative_eigenvalues(A));
}

TEST(SparseLdlt, PressuresWithoutCompliancePerturbTheSolutionByNoMoreThanTheBound) {
    const auto A = saddle_point(12, 4, 0.0, 5.0);
    SparseLdlt factor(sparse(A));
    ASSERT_TRUE(factor.factorize(sparse(A)));
    EXPECT_LT(error_of_solve(factor, A), 1e-5);  // of the order of the bound, 1e-6
    EXPECT_EQ(factor.negative_pivots(), 4);
}

TEST(SparseLdlt, CountsNegativeEigenvaluesOfAnUnstableState) {
    const auto A = saddle_point(12, 2, 0.01, -9.0);
    SparseLdlt factor(sparse(A));
    ASSERT_TRUE(factor.factorize(sparse(A)));
    EXPECT_GT(negative_eigenvalues(A), 2);
    EXPECT_EQ(factor.negative_pivots(), negative_eigenvalues(A));
    EXPECT_LT(error_of_solve(factor, A), 1e-12);
}

TEST(SparseLdlt, FactorisesNewValuesWithTheSamePattern) {
    const auto first = saddle_point(9, 3, 0.02, 6.0), second = saddle_point(9, 3, 0.5, 2.0);
    SparseLdlt factor(sparse(first));
    ASSERT_TRUE(factor.factorize(sparse(first)));
    ASSERT_TRUE(factor.factorize(sparse(second)));
    EXPECT_LT(error_of_solve(factor, second), 1e-13);
}

TEST(SparseLdlt, ReadsOnlyTheUpperTriangle) {
    const auto A = saddle_point(6, 2, 0.1, 5.0);
    auto other_below = A;
    for (int i = 0; i < A.size; ++i)
        for (int j = 0; j < i; ++j) other_below.at(i, j) = 100.0 + i;
    SparseLdlt factor(sparse(A));
    ASSERT_TRUE(factor.factorize(sparse(other_below)));
    EXPECT_LT(error_of_solve(factor, A), 1e-13);
}

TEST(SparseLdlt, FailsForAMatrixWithoutPivots) {
    SmallMatrix A(2);
    A.at(0, 1) = A.at(1, 0) = 1.0;  // both diagonals are zero, so there is no scale for a replacement
    SparseLdlt factor(sparse(A));
    EXPECT_FALSE(factor.factorize(sparse(A)));
}

TEST(SparseLdlt, ReportsTheFlopsOfAFactorisation) {
    SmallMatrix A(10);
    for (int i = 0; i < 10; ++i)
        for (int j = 0; j < 10; ++j) A.at(i, j) = i == j ? 10.0 : 1.0;
    EXPECT_NEAR(SparseLdlt(sparse(A)).flops(), 385.0, 1e-9);  // dense: sum of the squared column lengths
}

}  // namespace
}  // namespace soft::linalg
