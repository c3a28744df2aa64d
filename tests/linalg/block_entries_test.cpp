#include "linalg/block_entries.hpp"

#include <gtest/gtest.h>

#include <array>

#include "core/error.hpp"

namespace soft::linalg {
namespace {

// A chain of cells with three unknowns, each sharing one with the next. One unknown is constrained, one block is smaller.
constexpr PetscInt unknowns = 9;
const std::vector<std::vector<PetscInt>> chain = {{0, 1, 2}, {4, 2, 3}, {4, -1, 5}, {5, 6, 8}, {8, 7}};

std::vector<double> block_values(std::size_t block) {
    std::vector<double> values(chain[block].size() * chain[block].size());
    for (std::size_t k = 0; k < values.size(); ++k)
        values[k] = 0.1 * static_cast<double>(block + 1) + 1.0 / static_cast<double>(k + 3);
    return values;
}

Matrix empty_matrix(MatType type) {
    Matrix K;
    SOFT_PETSC(MatCreate(PETSC_COMM_SELF, K.out()));
    SOFT_PETSC(MatSetType(K, type));
    SOFT_PETSC(MatSetSizes(K, unknowns, unknowns, unknowns, unknowns));
    SOFT_PETSC(MatSetUp(K));
    return K;
}

/// By MatSetValues.
Matrix searched(MatType type) {
    Matrix K = empty_matrix(type);
    for (std::size_t b = 0; b < chain.size(); ++b) {
        const auto n = static_cast<PetscInt>(chain[b].size());
        SOFT_PETSC(MatSetValues(K, n, chain[b].data(), n, chain[b].data(), block_values(b).data(), ADD_VALUES));
    }
    assemble(K);
    return K;
}

class BlockEntries : public testing::TestWithParam<MatType> {};

TEST_P(BlockEntries, OfAPatternAreFound) {
    const Matrix K = searched(GetParam());
    for (const auto& block : chain) EXPECT_TRUE(contains_block(K, block));
    EXPECT_TRUE(contains_block(K, std::array<PetscInt, 2>{3, -1}));
    EXPECT_FALSE(contains_block(K, std::array<PetscInt, 2>{0, 3}));
    EXPECT_FALSE(contains_block(K, std::array<PetscInt, 3>{2, 4, 5}));
}

TEST_P(BlockEntries, AreBitwiseEqualToMatSetValues) {
    const Matrix expected = searched(GetParam());
    Matrix K = searched(GetParam());
    const std::vector<std::span<const PetscInt>> blocks(chain.begin(), chain.end());
    const BlockIndices indices(K, blocks);
    for (const int threads : {1, 3}) {
        SOFT_PETSC(MatZeroEntries(K));
        {
            BlockAdder adder(K);
            const int shares = adder.is_shareable(indices) ? threads : 1;
            for (int t = shares; t-- > 0;)
                for (std::size_t b = 0; b < chain.size(); ++b) adder.add(indices, b, block_values(b), {t, shares});
        }
        assemble(K);
        PetscBool equal = PETSC_FALSE;
        SOFT_PETSC(MatEqual(K, expected, &equal));
        EXPECT_EQ(equal, PETSC_TRUE) << threads;
    }
}

TEST_P(BlockEntries, OutsideThePatternAreRejected) {
    Matrix K = searched(GetParam());
    const std::array<PetscInt, 2> apart = {0, 7};
    const std::vector<std::span<const PetscInt>> blocks = {apart};
    EXPECT_THROW(BlockIndices(K, blocks), Error);
}

TEST_P(BlockEntries, HaveEqualHashesForEqualPatternsOnly) {
    Matrix K = searched(GetParam()), same = searched(GetParam()), other = empty_matrix(GetParam());
    SOFT_PETSC(MatSetValue(other, 0, 7, 1.0, INSERT_VALUES));
    assemble(other);
    EXPECT_EQ(pattern_hash(K), pattern_hash(same));
    EXPECT_NE(pattern_hash(K), pattern_hash(other));
}

INSTANTIATE_TEST_SUITE_P(Aij, BlockEntries, testing::Values(MATSEQAIJ, MATMPIAIJ));

}  // namespace
}  // namespace soft::linalg
