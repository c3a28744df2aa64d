#include <gtest/gtest.h>

#include <limits>

#include "linalg/small_matrix.hpp"

namespace soft::linalg {
namespace {

SmallMatrix of(int size, std::vector<double> values) {
    SmallMatrix matrix(size);
    matrix.values = std::move(values);
    return matrix;
}

TEST(SmallMatrix, SolvesSystemsThatNeedPivotingAndRowScaling) {
    const auto x = solve(of(3, {0, 2e9, 1e9, 3e-6, 0, 0, 0, 1, -1}), {7e9, 6e-6, -0.5});
    ASSERT_TRUE(x);
    EXPECT_NEAR((*x)[0], 2.0, 1e-12);
    EXPECT_NEAR((*x)[1], 6.5 / 3, 1e-12);
    EXPECT_NEAR((*x)[2], 8.0 / 3, 1e-12);
}

TEST(SmallMatrix, ReportsASingularMatrix) {
    EXPECT_FALSE(solve(of(2, {1, 2, 2, 4}), {1, 1}));
    EXPECT_FALSE(solve(of(1, {0}), {1}));
    EXPECT_FALSE(solve(of(1, {std::numeric_limits<double>::quiet_NaN()}), {1}));
}

TEST(SmallMatrix, CountsNegativeEigenvaluesOfTheSymmetricPart) {
    EXPECT_EQ(negative_eigenvalues(of(2, {1, 5, -5, 2})), 0);  // the antisymmetric part is ignored
    EXPECT_EQ(negative_eigenvalues(of(2, {1, 3, 3, 1})), 1);
    EXPECT_EQ(negative_eigenvalues(of(3, {-1, 0, 0, 0, -2, 0, 0, 0, 3})), 2);
    EXPECT_EQ(negative_eigenvalues(SmallMatrix(0)), 0);
}

}  // namespace
}  // namespace soft::linalg
