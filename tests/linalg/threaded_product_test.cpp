// Reference: PETSc's product.
#include "linalg/threaded_product.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace soft::linalg {
namespace {

/// Rows in groups of one to four with the same columns, which are one to `size`.
Matrix grouped(PetscInt size) {
    Matrix K;
    SOFT_PETSC(MatCreateSeqAIJ(PETSC_COMM_SELF, size, size, size, nullptr, K.out()));
    for (PetscInt row = 0, group = 0; row < size; ++group)
        for (PetscInt last = std::min(size, row + 1 + group % 4); row < last; ++row)
            for (PetscInt column = 0; column < size; ++column)
                if (column == row || (column * (group + 3)) % 7 < group % 8)
                    SOFT_PETSC(MatSetValue(K, row, column, std::sin(1.0 + row * size + column), INSERT_VALUES));
    assemble(K);
    return K;
}

Vector waves(Mat K) {
    Vector x;
    SOFT_PETSC(MatCreateVecs(K, x.out(), nullptr));
    PetscInt size = 0;
    SOFT_PETSC(VecGetSize(x, &size));
    std::vector<double> values;
    for (PetscInt i = 0; i < size; ++i) values.push_back(std::cos(i));
    spread(values, x);
    return x;
}

std::vector<double> product(Mat K, Vec x) {
    const Vector y = duplicate(x);
    SOFT_PETSC(MatMult(K, x, y));
    return gather(y);
}

TEST(ThreadedProduct, IsThatOfTheMatrixWithTheSameDigitsForAnyNumberOfThreads) {
    for (const PetscInt size : {1, 2, 3, 10, 61}) {
        const Matrix K = grouped(size);
        const Vector x = waves(K);
        const auto exact = product(K, x), found = product(ThreadedProduct(K, 1).operation(), x);
        for (std::size_t i = 0; i < exact.size(); ++i) EXPECT_NEAR(found[i], exact[i], 1e-12) << size << ' ' << i;
        for (const int threads : {2, 3, 100}) EXPECT_EQ(product(ThreadedProduct(K, threads).operation(), x), found);
    }
}

TEST(ThreadedProduct, UsesTheCurrentValues) {
    const Matrix K = grouped(20);
    const Vector x = waves(K);
    const ThreadedProduct twice(K, 2);
    auto expected = product(twice.operation(), x);
    SOFT_PETSC(MatScale(K, 2.0));
    for (double& value : expected) value *= 2.0;
    EXPECT_EQ(product(twice.operation(), x), expected);
}

}  // namespace
}  // namespace soft::linalg
