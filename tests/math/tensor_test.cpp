#include "math/tensor.hpp"

#include <gtest/gtest.h>

namespace soft {
namespace {

constexpr Tensor sample{1.2, 0.3, -0.4, 0.1, 0.9, 0.25, -0.2, 0.35, 1.1};

TEST(Tensor, CofactorTransposedTimesTheTensorIsTheDeterminant) {
    const Tensor cof = cofactor(sample);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            double sum = 0;
            for (int k = 0; k < 3; ++k) sum += cof[3 * k + i] * sample[3 * k + j];
            EXPECT_NEAR(sum, i == j ? determinant(sample) : 0.0, 1e-15);
        }
}

TEST(Tensor, EigenvaluesSatisfyTraceDeterminantAndOrder) {
    const Tensor C = right_cauchy_green(sample);
    const auto e = symmetric_eigenvalues(C);
    EXPECT_GE(e[0], e[1]);
    EXPECT_GE(e[1], e[2]);
    EXPECT_NEAR(e[0] + e[1] + e[2], trace(C), 1e-14);
    EXPECT_NEAR(e[0] * e[1] * e[2], determinant(C), 1e-14);
    EXPECT_NEAR(determinant(C), determinant(sample) * determinant(sample), 1e-14);
}

TEST(Tensor, EigenvaluesOfADiagonalTensorAreItsEntriesEvenIfTwoAreEqual) {
    const auto e = symmetric_eigenvalues({4.0, 0, 0, 0, 9.0, 0, 0, 0, 4.0});
    EXPECT_NEAR(e[0], 9.0, 1e-14);
    EXPECT_NEAR(e[1], 4.0, 1e-7);
    EXPECT_NEAR(e[2], 4.0, 1e-7);
    const auto same = symmetric_eigenvalues({2.0, 0, 0, 0, 2.0, 0, 0, 0, 2.0});
    EXPECT_DOUBLE_EQ(same[0], 2.0);
    EXPECT_DOUBLE_EQ(same[2], 2.0);
}

// The case of an almost undeformed body.
TEST(Tensor, EigenvaluesOfTheIdentityPlusATinyPerturbationAreOne) {
    for (const double s : {1e-20, 1e-120, 1e-200, 5e-324})
        for (const double e : symmetric_eigenvalues({1.0, s, 0, s, 1.0, -s, 0, -s, 1.0})) EXPECT_DOUBLE_EQ(e, 1.0) << s;
    const auto small = symmetric_eigenvalues({3e-120, 0, 0, 0, 1e-120, 0, 0, 0, 2e-120});
    EXPECT_NEAR(small[0] * 1e120, 3.0, 1e-14);
    EXPECT_NEAR(small[2] * 1e120, 1.0, 1e-14);
}

}  // namespace
}  // namespace soft
