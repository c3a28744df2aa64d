#pragma once
/// Adds dense square blocks, as those of cells, to an AIJ matrix whose pattern holds them, without the search of MatSetValues for
/// every entry: where an entry lies in its row is looked up once (two bytes an entry). Sums run in the order of the calls, as
/// with MatSetValues: the same bytes. Rows of other ranks go through MatSetValues, so assembly has to follow as usual.
/// Tested by linalg/block_entries_test.
#include <cstdint>

#include "linalg/petsc.hpp"

namespace soft::linalg {

/// A number for the pattern of this rank's rows: equal for equal patterns. It tells whether places of one matrix are those of
/// another.
[[nodiscard]] std::uint64_t pattern_hash(Mat K);

/// Where the entries of many blocks lie in matrices of the pattern of K.
class BlockPlaces {
public:
    BlockPlaces() = default;
    /// `blocks` are the rows and columns of each block, -1 where left out. Throws Error (internal) for an entry that the
    /// pattern does not hold.
    BlockPlaces(Mat K, std::span<const std::span<const PetscInt>> blocks);

private:
    friend class BlockAdder;
    [[nodiscard]] bool find_places(Mat K);

    struct Block {
        std::size_t dofs, places;  // where its own begin
    };
    std::vector<Block> blocks_;          // and one beyond the last
    std::vector<PetscInt> dofs_;         // [block][row]
    std::vector<std::uint16_t> places_;  // [block][row][column] in the row; empty where a row is too long for them
};

/// Holds the values of a matrix for the time of its life; MatZeroEntries before it tells solvers that they change.
class BlockAdder {
public:
    explicit BlockAdder(Mat K);
    ~BlockAdder();
    BlockAdder(const BlockAdder&) = delete;
    BlockAdder& operator=(const BlockAdder&) = delete;

    /// values [row][column] of one block.
    void add(const BlockPlaces& places, std::size_t block, std::span<const double> values);

private:
    void add_own_row(PetscInt row, std::span<const std::uint16_t> places, std::span<const double> values);

    Mat K_, diagonal_ = nullptr, rest_ = nullptr;
    PetscInt begin_ = 0, end_ = 0;
    const PetscInt *diagonal_rows_ = nullptr, *rest_rows_ = nullptr;
    double *diagonal_values_ = nullptr, *rest_values_ = nullptr;
};

}  // namespace soft::linalg
