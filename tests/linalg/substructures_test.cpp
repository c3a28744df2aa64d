// Runs on one, two and three ranks (CMakeLists.txt). Reference: LAPACK on the whole matrix. Solutions from dense LU, signatures from
// dense eigenvalues.
#include "linalg/substructures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "linalg/small_matrix.hpp"

namespace soft::linalg {
namespace {

constexpr int unknowns = 66, reach = 5;

/// A chain of springs, each coupling unknowns up to `reach` apart. Every sixth unknown is a pressure. `weakened` springs have a
/// negative stiffness.
SmallMatrix chain(double compliance, int weakened = 0) {
    SmallMatrix A(unknowns);
    for (int i = 0; i < unknowns; ++i)
        for (int j = 0; j < unknowns; ++j) {
            if (std::abs(i - j) > reach) continue;
            const bool pressure_i = i % 6 == 5, pressure_j = j % 6 == 5;
            if (i == j)
                A.at(i, i) = pressure_i ? -compliance : 6.0 + i % 3;
            else if (pressure_i != pressure_j)
                A.at(i, j) = std::sin(0.7 * (i + j) + 0.3);
            else if (!pressure_i)
                A.at(i, j) = -0.4 * std::cos(0.2 * (i + j));
        }
    for (int k = 0; k < weakened; ++k) A.at(7 * k + 1, 7 * k + 1) -= 9.0;
    return A;
}

/// Rows multiplied by numbers of both signs.
SmallMatrix with_scaled_rows(SmallMatrix A) {
    for (int i = 0; i < A.size; ++i)
        for (int j = 0; j < A.size; ++j) A.at(i, j) *= i % 5 == 2 ? -0.5 : 1.5;
    return A;
}

Matrix on_all_ranks(const SmallMatrix& A) {
    Matrix K;
    SOFT_PETSC(MatCreateAIJ(PETSC_COMM_WORLD, PETSC_DECIDE, PETSC_DECIDE, A.size, A.size, A.size, nullptr, A.size,
                            nullptr, K.out()));
    PetscInt begin = 0, end = 0;
    SOFT_PETSC(MatGetOwnershipRange(K, &begin, &end));
    for (PetscInt i = begin; i < end; ++i)
        for (PetscInt j = 0; j < A.size; ++j)
            if (A.at(i, j) != 0.0 || i == j) SOFT_PETSC(MatSetValue(K, i, j, A.at(i, j), INSERT_VALUES));
    assemble(K);
    return K;
}

int ranks() {
    int size = 1;
    MPI_Comm_size(PETSC_COMM_WORLD, &size);
    return size;
}

double error_of_solve(Factors& factors, const SmallMatrix& A) {
    const Matrix K = on_all_ranks(A);
    Vector b, x;
    SOFT_PETSC(MatCreateVecs(K, x.out(), b.out()));
    std::vector<double> right;
    for (int i = 0; i < A.size; ++i) right.push_back(std::cos(i));
    spread(right, b);
    factors.solve(b, x);
    Vector exact = duplicate(x);
    spread(solve(A, right).value(), exact);
    const double size = norm(exact);
    add(exact, -1.0, x);
    return norm(exact) / size;
}

std::unique_ptr<Substructures> substructures(Mat K, Symmetry symmetry) {
    std::vector<PetscInt> order;
    return Substructures::create(K, symmetry, order);
}

TEST(Substructures, SolveAndCountNegativeEigenvaluesOfTheWholeMatrix) {
    for (const int weakened : {0, 1, 4, 9}) {
        const SmallMatrix A = chain(0.02, weakened);
        const Matrix K = on_all_ranks(A);
        const auto factors = substructures(K, Symmetry::symmetric);
        ASSERT_EQ(factors != nullptr, ranks() > 1);
        if (!factors) return;
        ASSERT_TRUE(factors->factorize(K));
        EXPECT_LT(error_of_solve(*factors, A), 1e-11) << weakened;
        EXPECT_EQ(factors->negative_pivots(), negative_eigenvalues(A)) << weakened;
        EXPECT_FALSE(factors->determinant_is_negative());
    }
}

TEST(Substructures, SolveAGeneralMatrixAndReportTheSignOfItsDeterminant) {
    for (const int weakened : {0, 1, 2}) {
        const SmallMatrix symmetric = chain(0.02, weakened), A = with_scaled_rows(symmetric);
        const int signs_of_rows = (unknowns + 2) / 5;  // i % 5 == 2
        const Matrix K = on_all_ranks(A);
        const auto factors = substructures(K, Symmetry::general);
        ASSERT_EQ(factors != nullptr, ranks() > 1);
        if (!factors) return;
        ASSERT_TRUE(factors->factorize(K));
        EXPECT_LT(error_of_solve(*factors, A), 1e-11) << weakened;
        EXPECT_EQ(factors->determinant_is_negative(), (negative_eigenvalues(symmetric) + signs_of_rows) % 2 == 1)
            << weakened;
        EXPECT_FALSE(factors->negative_pivots());
    }
}

TEST(Substructures, FactoriseLaterMatricesWithTheSamePattern) {
    const Matrix first = on_all_ranks(chain(0.02));
    const auto factors = substructures(first, Symmetry::symmetric);
    ASSERT_EQ(factors != nullptr, ranks() > 1);
    if (!factors) return;
    ASSERT_TRUE(factors->factorize(first));
    const SmallMatrix A = chain(0.5, 2);
    ASSERT_TRUE(factors->factorize(on_all_ranks(A)));
    EXPECT_LT(error_of_solve(*factors, A), 1e-11);
}

TEST(Substructures, ReuseTheEliminationOrderOfTheSamePattern) {
    const SmallMatrix A = with_scaled_rows(chain(0.02));
    const Matrix K = on_all_ranks(A);
    std::vector<PetscInt> order;
    if (!Substructures::create(K, Symmetry::symmetric, order)) {
        EXPECT_EQ(ranks(), 1);
        return;
    }
    const std::vector<PetscInt> made = order;
    EXPECT_FALSE(made.empty());
    const auto factors = Substructures::create(K, Symmetry::general, order);
    EXPECT_EQ(order, made);
    ASSERT_TRUE(factors->factorize(K));
    EXPECT_LT(error_of_solve(*factors, A), 1e-11);
}

TEST(Substructures, ApplyMumpsOptionsExceptThoseTheyDependOn) {
    const SmallMatrix A = chain(0.02);
    const Matrix K = on_all_ranks(A);
    const auto was_asked_for = [](const char* option) {
        PetscBool used = PETSC_FALSE;
        SOFT_PETSC(PetscOptionsUsed(nullptr, option + 1, &used));  // without its dash
        SOFT_PETSC(PetscOptionsClearValue(nullptr, option));
        return used == PETSC_TRUE;
    };
    SOFT_PETSC(PetscOptionsSetValue(nullptr, "-mat_mumps_icntl_14", "120"));
    SOFT_PETSC(PetscOptionsSetValue(nullptr, "-mat_mumps_cntl_1", "0.1"));
    SOFT_PETSC(PetscOptionsSetValue(nullptr, "-mat_mumps_icntl_19", "0"));  // no Schur complement
    const auto factors = substructures(K, Symmetry::symmetric);
    EXPECT_EQ(was_asked_for("-mat_mumps_icntl_14"), ranks() > 1);
    EXPECT_EQ(was_asked_for("-mat_mumps_cntl_1"), ranks() > 1);
    EXPECT_FALSE(was_asked_for("-mat_mumps_icntl_19"));
    if (!factors) return;
    ASSERT_TRUE(factors->factorize(K));
    EXPECT_LT(error_of_solve(*factors, A), 1e-11);
}

TEST(Substructures, FailOnAllRanksIfOneInteriorIsSingular) {
    SmallMatrix A = chain(0.02);
    for (int j = 0; j < unknowns; ++j) A.at(3, j) = A.at(j, 3) = j == 3 ? 2.0 : 0.0;  // decoupled from all others
    const Matrix K = on_all_ranks(A);
    const auto factors = substructures(K, Symmetry::symmetric);
    ASSERT_EQ(factors != nullptr, ranks() > 1);
    if (!factors) return;
    EXPECT_TRUE(factors->factorize(K));
    A.at(3, 3) = 0.0;
    EXPECT_FALSE(factors->factorize(on_all_ranks(A)));
}

TEST(Substructures, AreNotUsedIfRanksShareNoUnknowns) {
    SmallMatrix A(unknowns);
    for (int i = 0; i < unknowns; ++i) A.at(i, i) = 1.0 + i;
    EXPECT_EQ(substructures(on_all_ranks(A), Symmetry::symmetric), nullptr);
}

}  // namespace
}  // namespace soft::linalg
