#pragma once
/// Adds dense square blocks, such as element matrices, to an AIJ matrix whose pattern contains them. MatSetValues searches the row
/// for every entry; here the index of each entry in its row is looked up once and stored (two bytes per entry). The sums run in the
/// order of the calls, so the result is bitwise equal to that of MatSetValues. Rows of other ranks go through MatSetValues:
/// MatAssemblyBegin/End must follow.
/// Tested by linalg/block_entries_test.
#include <cstdint>

#include "linalg/petsc.hpp"

namespace soft::linalg {

/// Hash of the sparsity pattern of this rank's rows: equal for equal patterns. A BlockIndices is valid for all matrices with the
/// same hash.
[[nodiscard]] std::uint64_t pattern_hash(Mat K);

/// Whether the pattern of K contains all entries of a block in this rank's rows; -1 omits an unknown. Does not communicate.
[[nodiscard]] bool contains_block(Mat K, std::span<const PetscInt> dofs);

/// Indices of the entries of many blocks in matrices with the pattern of K.
class BlockIndices {
public:
    BlockIndices() = default;
    /// `blocks` contains the rows (= columns) of each block; -1 omits an unknown. Throws Error (internal) for an entry that is not in
    /// the pattern. `threads`: for the search only.
    BlockIndices(Mat K, std::span<const std::span<const PetscInt>> blocks, int threads = 1);

private:
    friend class BlockAdder;
    [[nodiscard]] bool find_indices(Mat K, int threads);

    struct Block {
        std::size_t dofs, indices;  // begin of the block in dofs_ and indices_
    };
    std::vector<Block> blocks_;   // plus one end marker
    std::vector<PetscInt> dofs_;  // [block][row]
    /// [block][row][column], index in the row; empty if a row is too long for 16 bits.
    std::vector<std::uint16_t> indices_;
};

/// The rows that one of several threads adds: all entries of a row are added by one thread in the order of the calls, so that the sums do not
/// depend on the number of threads.
struct RowShare {
    int index = 0, count = 1;
};

/// Accesses the values of a matrix during its lifetime. Call MatZeroEntries first: it marks the matrix as changed for solvers.
class BlockAdder {
public:
    explicit BlockAdder(Mat K);
    ~BlockAdder();
    BlockAdder(const BlockAdder&) = delete;
    BlockAdder& operator=(const BlockAdder&) = delete;

    /// Whether threads may add their shares at the same time: no row belongs to another rank or is too long for its indices.
    [[nodiscard]] bool is_shareable(const BlockIndices& indices) const;
    /// values [row][column] of one block.
    void add(const BlockIndices& indices, std::size_t block, std::span<const double> values, RowShare share = {});

private:
    void add_own_row(PetscInt row, std::span<const std::uint16_t> indices, std::span<const double> values);

    Mat K_, diagonal_ = nullptr, rest_ = nullptr;
    PetscInt begin_ = 0, end_ = 0;
    const PetscInt *diagonal_rows_ = nullptr, *rest_rows_ = nullptr;
    double *diagonal_values_ = nullptr, *rest_values_ = nullptr;
};

}  // namespace soft::linalg
