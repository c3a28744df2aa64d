#include "solver/quasi_newton.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace soft::solver {
namespace {

using Three = std::array<double, 3>;

linalg::Vector vector(const Three& values) {
    linalg::Vector v;
    SOFT_PETSC(VecCreateSeq(PETSC_COMM_SELF, 3, v.out()));
    for (PetscInt i = 0; i < 3; ++i) SOFT_PETSC(VecSetValue(v, i, values[static_cast<std::size_t>(i)], INSERT_VALUES));
    SOFT_PETSC(VecAssemblyBegin(v));
    SOFT_PETSC(VecAssemblyEnd(v));
    return v;
}

/// K = [[4 1 0] [1 3 1] [0 1 2]]
Three K_times(const Three& x) { return {4 * x[0] + x[1], x[0] + 3 * x[1] + x[2], x[1] + 2 * x[2]}; }

bool apply_identity(Vec q, Vec r) {
    linalg::copy(q, r);
    return true;
}

double distance(Vec a, const Three& b) {
    auto difference = vector(b);
    linalg::add(difference, -1.0, a);
    return linalg::norm(difference);
}

TEST(SecantUpdates, TheNewestPairIsReproduced) {
    SecantUpdates updates;
    const Three s1{1, 0.5, -0.2}, s2{0.3, 1, 0.7};
    updates.add(vector(s1), vector(K_times(s1)));
    updates.add(vector(s2), vector(K_times(s2)));
    auto x = vector({0, 0, 0});
    ASSERT_TRUE(updates.apply(vector(K_times(s2)), x, apply_identity));
    EXPECT_LT(distance(x, s2), 1e-13);
}

// With conjugate pairs (s_i . K s_j = 0), as many as unknowns, H is K^-1.
TEST(SecantUpdates, ConjugatePairsOfEveryDirectionGiveTheInverse) {
    SecantUpdates updates;
    std::array<Three, 3> s{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const auto product = [](const Three& a, const Three& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const double share = product(s[i], K_times(s[j])) / product(s[j], K_times(s[j]));
            for (std::size_t k = 0; k < 3; ++k) s[i][k] -= share * s[j][k];
        }
        updates.add(vector(s[i]), vector(K_times(s[i])));
    }
    const Three wanted{0.2, -1.3, 0.4};
    auto x = vector({0, 0, 0});
    ASSERT_TRUE(updates.apply(vector(K_times(wanted)), x, apply_identity));
    EXPECT_LT(distance(x, wanted), 1e-12);
}

TEST(SecantUpdates, SkipsPairsWithoutPositiveCurvature) {
    SecantUpdates updates;
    updates.add(vector({1, 0, 0}), vector({0, 1, 0}));
    updates.add(vector({1, 0, 0}), vector({-1, 0.5, 0}));
    EXPECT_TRUE(updates.empty());
}

TEST(SecantUpdates, ReportsAFailedSolve) {
    SecantUpdates updates;
    auto x = vector({0, 0, 0});
    EXPECT_FALSE(updates.apply(vector({1, 1, 1}), x, [](Vec, Vec) { return false; }));
}

}  // namespace
}  // namespace soft::solver
