#include "linalg/block_entries.hpp"

#include <algorithm>
#include <atomic>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "linalg/matrix_rows.hpp"
#include "math/threads.hpp"

namespace soft::linalg {

namespace {

/// This rank's rows. On one rank `diagonal` is the matrix itself. On several ranks `diagonal` contains the rank's own columns and
/// `rest` the columns of other ranks, whose global indices are `columns[...]`.
struct Parts {
    Mat diagonal = nullptr, rest = nullptr;
    const PetscInt* columns = nullptr;
};

Parts parts_of(Mat K) {
    Parts parts;
    PetscBool distributed = PETSC_FALSE;
    SOFT_PETSC(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(K), MATMPIAIJ, &distributed));
    if (distributed == PETSC_FALSE) return {K, nullptr, nullptr};
    SOFT_PETSC(MatMPIAIJGetSeqAIJ(K, &parts.diagonal, &parts.rest, &parts.columns));
    return parts;
}

/// Indices of columns in one row, from a table over all columns: cheaper than searching the row for each of many columns.
class RowIndices {
public:
    RowIndices(const MatrixRows& rows, PetscInt columns) : rows_(rows), indices_(static_cast<std::size_t>(columns)) {}

    void set_row(PetscInt row) {
        row_ = row;
        for (PetscInt k = 0; k < length(); ++k) indices_[at(column(k))] = k;
    }
    [[nodiscard]] PetscInt length() const { return rows_.begin[row_ + 1] - rows_.begin[row_]; }
    /// Throws if the row does not contain the column; the table entry then belongs to an earlier row.
    [[nodiscard]] PetscInt operator[](PetscInt wanted) const {
        const PetscInt found = at(wanted) < indices_.size() ? indices_[at(wanted)] : length();
        if (found >= length() || column(found) != wanted)
            throw Error(ExitCode::internal, "matrix",
                        "the sparsity pattern does not contain row " + std::to_string(row_) + ", column " +
                            std::to_string(wanted));
        return found;
    }

private:
    static std::size_t at(PetscInt index) { return static_cast<std::size_t>(index); }
    [[nodiscard]] PetscInt column(PetscInt k) const { return rows_.columns[rows_.begin[row_] + k]; }

    MatrixRows rows_;
    std::vector<PetscInt> indices_;
    PetscInt row_ = 0;
};

constexpr std::uint16_t omitted = std::numeric_limits<std::uint16_t>::max();

/// Consecutive rows that one thread adds: those of a cell are divided evenly.
constexpr PetscInt rows_together = 4;

}  // namespace

std::uint64_t pattern_hash(Mat K) {
    const Parts parts = parts_of(K);
    std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a, a word at a time
    const auto mix = [&](PetscInt value) { hash = (hash ^ static_cast<std::uint64_t>(value)) * 0x100000001b3; };
    for (Mat part : {parts.diagonal, parts.rest}) {
        if (part == nullptr) continue;
        const MatrixRows rows = rows_of(part);
        for (PetscInt r = 0; r <= rows.count; ++r) mix(rows.begin[r]);
        for (PetscInt k = 0; k < rows.begin[rows.count]; ++k) mix(rows.columns[k]);
    }
    return hash;
}

bool contains_block(Mat K, std::span<const PetscInt> dofs) {
    const Parts parts = parts_of(K);
    const MatrixRows own = rows_of(parts.diagonal), rest = parts.rest == nullptr ? MatrixRows{} : rows_of(parts.rest);
    PetscInt begin = 0, end = 0, rest_columns = 0;
    SOFT_PETSC(MatGetOwnershipRange(K, &begin, &end));
    if (parts.rest != nullptr) SOFT_PETSC(MatGetSize(parts.rest, nullptr, &rest_columns));
    if (rest_columns > 0 && parts.columns == nullptr) return false;  // in assembly
    const auto contains = [](const MatrixRows& rows, PetscInt row, PetscInt column) {
        return std::binary_search(rows.columns + rows.begin[row], rows.columns + rows.begin[row + 1], column);
    };
    for (const PetscInt row : dofs) {
        if (row < begin || row >= end) continue;
        for (const PetscInt column : dofs) {
            if (column < 0) continue;
            if (column >= begin && column < end) {
                if (!contains(own, row - begin, column - begin)) return false;
                continue;
            }
            const PetscInt* known = std::lower_bound(parts.columns, parts.columns + rest_columns, column);
            if (known == parts.columns + rest_columns || *known != column ||
                !contains(rest, row - begin, static_cast<PetscInt>(known - parts.columns)))
                return false;
        }
    }
    return true;
}

BlockIndices::BlockIndices(Mat K, std::span<const std::span<const PetscInt>> blocks, int threads) {
    for (const auto block : blocks) {
        blocks_.push_back({dofs_.size(), indices_.size()});
        dofs_.insert(dofs_.end(), block.begin(), block.end());
        indices_.resize(indices_.size() + block.size() * block.size(), omitted);
    }
    blocks_.push_back({dofs_.size(), indices_.size()});
    if (!find_indices(K, threads)) indices_.clear();
}

/// Runs row by row over all blocks that contribute to the row. Returns false if an index does not fit in 16 bits.
bool BlockIndices::find_indices(Mat K, int threads) {
    struct Part {
        std::size_t block, first_index;
    };
    PetscInt begin = 0, end = 0, first = 0, last = 0, rest_columns = 0;
    SOFT_PETSC(MatGetOwnershipRange(K, &begin, &end));
    SOFT_PETSC(MatGetOwnershipRangeColumn(K, &first, &last));
    std::vector<std::vector<Part>> parts_of_row(static_cast<std::size_t>(end - begin));
    for (std::size_t b = 0; b + 1 < blocks_.size(); ++b) {
        const std::size_t size = blocks_[b + 1].dofs - blocks_[b].dofs;
        for (std::size_t i = 0; i < size; ++i)
            if (const PetscInt row = dofs_[blocks_[b].dofs + i]; row >= begin && row < end)
                parts_of_row[static_cast<std::size_t>(row - begin)].push_back({b, blocks_[b].indices + i * size});
    }
    const Parts parts = parts_of(K);
    if (parts.rest != nullptr) SOFT_PETSC(MatGetSize(parts.rest, nullptr, &rest_columns));
    const MatrixRows own_rows = rows_of(parts.diagonal),
                     rest_rows = parts.rest == nullptr ? MatrixRows{} : rows_of(parts.rest);
    std::atomic<bool> is_too_long = false;
    for_ranges(parts_of_row.size(), threads, [&](std::size_t from, std::size_t to) {
        RowIndices own(own_rows, last - first), rest(rest_rows, rest_columns);
        const auto index_in_row = [&](PetscInt column) {
            if (column >= first && column < last) return own[column - first];
            const PetscInt* known = std::lower_bound(parts.columns, parts.columns + rest_columns, column);
            return own.length() + rest[static_cast<PetscInt>(known - parts.columns)];
        };
        for (std::size_t row = from; row < to && !is_too_long; ++row) {
            own.set_row(static_cast<PetscInt>(row));
            if (parts.rest != nullptr) rest.set_row(static_cast<PetscInt>(row));
            for (const auto& [block, first_index] : parts_of_row[row]) {
                std::uint16_t* found = indices_.data() + first_index;
                for (std::size_t d = blocks_[block].dofs; d < blocks_[block + 1].dofs; ++d, ++found) {
                    if (dofs_[d] < 0) continue;
                    const PetscInt in_row = index_in_row(dofs_[d]);
                    if (in_row >= omitted) is_too_long = true;
                    *found = static_cast<std::uint16_t>(in_row);
                }
            }
        }
    });
    return !is_too_long;
}

BlockAdder::BlockAdder(Mat K) : K_(K) {
    const Parts parts = parts_of(K);
    diagonal_ = parts.diagonal;
    rest_ = parts.rest;
    SOFT_PETSC(MatGetOwnershipRange(K, &begin_, &end_));
    diagonal_rows_ = rows_of(diagonal_).begin;
    SOFT_PETSC(MatSeqAIJGetArray(diagonal_, &diagonal_values_));
    if (rest_ == nullptr) return;
    rest_rows_ = rows_of(rest_).begin;
    SOFT_PETSC(MatSeqAIJGetArray(rest_, &rest_values_));
}

BlockAdder::~BlockAdder() {
    (void)MatSeqAIJRestoreArray(diagonal_, &diagonal_values_);
    if (rest_ != nullptr) (void)MatSeqAIJRestoreArray(rest_, &rest_values_);
}

void BlockAdder::add_own_row(PetscInt row, std::span<const std::uint16_t> indices, std::span<const double> values) {
    double* own = diagonal_values_ + diagonal_rows_[row];
    if (rest_ == nullptr) {
        for (std::size_t j = 0; j < indices.size(); ++j)
            if (indices[j] != omitted) own[indices[j]] += values[j];
        return;
    }
    const PetscInt length = diagonal_rows_[row + 1] - diagonal_rows_[row];
    double* others = rest_values_ + rest_rows_[row];
    for (std::size_t j = 0; j < indices.size(); ++j) {
        if (indices[j] == omitted) continue;
        (indices[j] < length ? own[indices[j]] : others[indices[j] - length]) += values[j];
    }
}

bool BlockAdder::is_shareable(const BlockIndices& indices) const {
    return rest_ == nullptr && !indices.indices_.empty();
}

void BlockAdder::add(const BlockIndices& indices, std::size_t block, std::span<const double> values, RowShare share) {
    const auto begin = indices.blocks_[block], end = indices.blocks_[block + 1];
    const std::span<const PetscInt> dofs(&indices.dofs_[begin.dofs], end.dofs - begin.dofs);
    const std::size_t size = dofs.size();
    for (std::size_t i = 0; i < size; ++i) {
        if (dofs[i] < 0 || (share.count > 1 && dofs[i] / rows_together % share.count != share.index)) continue;
        const auto row = values.subspan(i * size, size);
        if (indices.indices_.empty() || dofs[i] < begin_ || dofs[i] >= end_)
            SOFT_PETSC(MatSetValues(K_, 1, &dofs[i], static_cast<PetscInt>(size), dofs.data(), row.data(), ADD_VALUES));
        else
            add_own_row(dofs[i] - begin_, {&indices.indices_[begin.indices + i * size], size}, row);
    }
}

}  // namespace soft::linalg
