#include "linalg/profile.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "linalg/linear_solver.hpp"

namespace soft::linalg {
namespace {

const ProfileRow* find(const std::vector<ProfileRow>& rows, const std::string& start) {
    for (const ProfileRow& row : rows)
        if (row.what.starts_with(start)) return &row;
    return nullptr;
}

TEST(Profile, CountsOwnAndPetscPhasesWithoutDoubleCounting) {
    start_profile();
    const auto begin = std::chrono::steady_clock::now();
    {
        const ScopedTimer timed(Phase::writing);
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    Matrix K;
    SOFT_PETSC(MatCreateConstantDiagonal(PETSC_COMM_SELF, 4, 4, 4, 4, 2.0, K.out()));
    SOFT_PETSC(MatConvert(K, MATAIJ, MAT_INPLACE_MATRIX, K.out()));
    LinearSolver solver(K);
    ASSERT_TRUE(solver.factorize().succeeded);
    Vector x, b;
    SOFT_PETSC(MatCreateVecs(K, x.out(), b.out()));
    SOFT_PETSC(VecSet(b, 1.0));
    ASSERT_TRUE(solver.solve(b, x).converged);
    const double whole_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

    const auto rows = profile_rows();
    const auto* writing = find(rows, "writing of the result");
    ASSERT_NE(writing, nullptr);
    EXPECT_EQ(writing->calls, 1);
    EXPECT_GE(writing->seconds, 0.02);
    ASSERT_NE(find(rows, "factorisations"), nullptr);
    EXPECT_EQ(find(rows, "factorisations")->calls, 1);
    EXPECT_EQ(find(rows, "tangent assembly"), nullptr) << "nothing was assembled";
    double sum_s = 0;
    for (const ProfileRow& row : rows) {
        EXPECT_GE(row.seconds, 0.0) << row.what;
        sum_s += row.seconds;
    }
    EXPECT_LE(sum_s, whole_s);
}

}  // namespace
}  // namespace soft::linalg
