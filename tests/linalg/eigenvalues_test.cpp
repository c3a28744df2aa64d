#include "linalg/eigenvalues.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace soft::linalg {
namespace {

/// K = diag(eigenvalues) and M = I on the first unknowns. Each of the `constraints` last unknowns couples two more unknowns as the pressure
/// of an incompressible cell does: u = -v, so that K x = lambda M x has one more eigenvalue, (k_u + k_v) / 2, and an infinite one.
struct Pencil {
    Matrix K, M;
};
Pencil pencil(const std::vector<double>& eigenvalues, const std::vector<std::pair<double, double>>& constraints) {
    const auto free = static_cast<PetscInt>(eigenvalues.size()), tied = static_cast<PetscInt>(constraints.size());
    const PetscInt n = free + 3 * tied;
    Pencil pencil;
    for (Matrix* A : {&pencil.K, &pencil.M}) SOFT_PETSC(MatCreateSeqAIJ(PETSC_COMM_SELF, n, n, n, nullptr, A->out()));
    const auto set = [&](PetscInt i, PetscInt j, double stiffness, double mass) {
        SOFT_PETSC(MatSetValue(pencil.K, i, j, stiffness, INSERT_VALUES));
        SOFT_PETSC(MatSetValue(pencil.M, i, j, mass, INSERT_VALUES));
    };
    for (PetscInt i = 0; i < free; ++i) set(i, i, eigenvalues[static_cast<std::size_t>(i)], 1.0);
    for (PetscInt k = 0; k < tied; ++k) {
        const PetscInt u = free + 2 * k, v = u + 1, p = free + 2 * tied + k;
        const auto [by_u, by_v] = constraints[static_cast<std::size_t>(k)];
        set(u, u, by_u, 1.0);
        set(v, v, by_v, 1.0);
        set(p, p, 0.0, 0.0);
        for (const PetscInt i : {u, v}) {
            set(i, p, 1.0, 0.0);
            set(p, i, 1.0, 0.0);
        }
    }
    for (Mat A : {pencil.K.get(), pencil.M.get()}) {
        assemble(A);
    }
    return pencil;
}

void expect_lowest(const Pencil& pencil, PetscInt constraints, const std::vector<double>& expected) {
    const auto found = lowest_eigenvalues(pencil.K, pencil.M, static_cast<PetscInt>(expected.size()), constraints);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-9 * std::abs(expected[i]));
}

std::vector<double> with_many_above(std::vector<double> low) {
    for (int i = 0; i < 60; ++i) low.push_back(10.0 + i);
    return low;
}

TEST(Eigenvalues, AreTheLowestOfASaddlePoint) {
    const auto given = pencil(with_many_above({3, 1, 5}), {{1.0, 3.0}, {7.0, 1.0}});
    for (std::size_t count = 1; count <= 5; ++count) {
        const std::vector<double> all{1, 2, 3, 4, 5};
        expect_lowest(given, 2, {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)});
    }
}

/// [3 4; -4 1] has the eigenvalues 2 + i sqrt(15) and 2 - i sqrt(15).
TEST(Eigenvalues, OfAnUnsymmetricMatrixMayBeComplex) {
    const auto given = pencil(with_many_above({3, 1, 5}), {{1.0, 3.0}});
    for (Mat A : {given.K.get(), given.M.get()})
        SOFT_PETSC(MatSetOption(A, MAT_NEW_NONZERO_ALLOCATION_ERR, PETSC_FALSE));
    for (const double entry : {4.0, -4.0}) {
        const PetscInt i = entry > 0 ? 0 : 1;
        SOFT_PETSC(MatSetValue(given.K, i, 1 - i, entry, INSERT_VALUES));
        SOFT_PETSC(MatSetValue(given.M, i, 1 - i, 0.0, INSERT_VALUES));
    }
    for (Mat A : {given.K.get(), given.M.get()}) assemble(A);
    auto found = nearest_eigenvalues(given.K, given.M, 4, 1);
    ASSERT_GE(found.size(), 4u);
    std::ranges::sort(found, {}, [](const auto& value) { return std::pair{std::abs(value), value.imag()}; });
    if (found[1].imag() > found[2].imag()) std::swap(found[1], found[2]);  // conjugates, equal to rounding
    const std::complex<double> expected[] = {2.0, {2.0, -std::sqrt(15.0)}, {2.0, std::sqrt(15.0)}, 5.0};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(std::abs(found[i] - expected[i]), 0.0, 1e-8) << i;
}

TEST(Eigenvalues, IncludeANegativeOneFarFromZero) {
    const auto given = pencil(with_many_above({1, -2000, 4}), {{1.0, -5.0}});
    expect_lowest(given, 1, {-2000});
    expect_lowest(given, 1, {-2000, -2, 1});
}

TEST(Eigenvalues, AreFoundWithTheirMultiplicity) {
    const auto given = pencil(with_many_above({2, 1, 2, 2, 5}), {});
    expect_lowest(given, 0, {1, 2, 2});
    expect_lowest(given, 0, {1, 2, 2, 2, 5});
}

TEST(Eigenvalues, MayBeAllOfASmallMatrix) {
    expect_lowest(pencil({2, 1}, {}), 0, {1, 2});
    expect_lowest(pencil({}, {{1.0, 3.0}, {3.0, 7.0}}), 2, {2, 5});
}

}  // namespace
}  // namespace soft::linalg
