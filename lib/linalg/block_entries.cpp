#include "linalg/block_entries.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "linalg/matrix_rows.hpp"

namespace soft::linalg {

namespace {

/// This rank's rows: on one rank `diagonal` is the matrix itself, on several its own columns, `rest` those of others, whose
/// numbers are `columns[...]`.
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

/// Position of a column in a sorted row; throws where it is not there.
std::size_t find(const MatrixRows& rows, PetscInt row, PetscInt column) {
    const PetscInt *first = rows.columns + rows.begin[row], *last = rows.columns + rows.begin[row + 1];
    const PetscInt* place = std::lower_bound(first, last, column);
    if (place == last || *place != column)
        throw Error(ExitCode::internal, "matrix",
                    "its pattern lacks row " + std::to_string(row) + ", column " + std::to_string(column));
    return static_cast<std::size_t>(place - first);
}

constexpr std::uint16_t left_out = std::numeric_limits<std::uint16_t>::max();

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

BlockPlaces::BlockPlaces(Mat K, std::span<const std::span<const PetscInt>> blocks) {
    const Parts parts = parts_of(K);
    const MatrixRows diagonal = rows_of(parts.diagonal),
                     rest = parts.rest == nullptr ? MatrixRows{} : rows_of(parts.rest);
    PetscInt begin = 0, end = 0, first = 0, last = 0, rest_columns = 0;
    SOFT_PETSC(MatGetOwnershipRange(K, &begin, &end));
    SOFT_PETSC(MatGetOwnershipRangeColumn(K, &first, &last));
    if (parts.rest != nullptr) SOFT_PETSC(MatGetSize(parts.rest, nullptr, &rest_columns));
    const auto place = [&](PetscInt row, PetscInt column) {
        if (column >= first && column < last) return find(diagonal, row, column - first);
        const PetscInt* known = std::lower_bound(parts.columns, parts.columns + rest_columns, column);
        return static_cast<std::size_t>(diagonal.begin[row + 1] - diagonal.begin[row]) +
               find(rest, row, static_cast<PetscInt>(known - parts.columns));
    };
    bool fits = true;
    for (const auto block : blocks) {
        blocks_.push_back({dofs_.size(), places_.size()});
        dofs_.insert(dofs_.end(), block.begin(), block.end());
        for (const PetscInt row : block)
            for (const PetscInt column : block) {
                const bool here = row >= begin && row < end && column >= 0;
                const std::size_t found = here ? place(row - begin, column) : left_out;
                fits = fits && found <= left_out - (here ? 1U : 0U);
                places_.push_back(static_cast<std::uint16_t>(found));
            }
    }
    blocks_.push_back({dofs_.size(), places_.size()});
    if (!fits) places_.clear();
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

void BlockAdder::add_own_row(PetscInt row, std::span<const std::uint16_t> places, std::span<const double> values) {
    double* own = diagonal_values_ + diagonal_rows_[row];
    if (rest_ == nullptr) {
        for (std::size_t j = 0; j < places.size(); ++j)
            if (places[j] != left_out) own[places[j]] += values[j];
        return;
    }
    const PetscInt length = diagonal_rows_[row + 1] - diagonal_rows_[row];
    double* others = rest_values_ + rest_rows_[row];
    for (std::size_t j = 0; j < places.size(); ++j) {
        if (places[j] == left_out) continue;
        (places[j] < length ? own[places[j]] : others[places[j] - length]) += values[j];
    }
}

void BlockAdder::add(const BlockPlaces& places, std::size_t block, std::span<const double> values) {
    const auto begin = places.blocks_[block], end = places.blocks_[block + 1];
    const std::span<const PetscInt> dofs(&places.dofs_[begin.dofs], end.dofs - begin.dofs);
    const std::size_t size = dofs.size();
    for (std::size_t i = 0; i < size; ++i) {
        if (dofs[i] < 0) continue;
        const auto row = values.subspan(i * size, size);
        if (places.places_.empty() || dofs[i] < begin_ || dofs[i] >= end_)
            SOFT_PETSC(MatSetValues(K_, 1, &dofs[i], static_cast<PetscInt>(size), dofs.data(), row.data(), ADD_VALUES));
        else
            add_own_row(dofs[i] - begin_, {&places.places_[begin.places + i * size], size}, row);
    }
}

}  // namespace soft::linalg
