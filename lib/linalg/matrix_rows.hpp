#pragma once
/// The rows of a sequential AIJ matrix as PETSc stores them, not owned.
/// Tested by linalg/block_entries_test and linalg/multifrontal_test.
#include <span>
#include <vector>

#include "linalg/petsc.hpp"

namespace soft::linalg {

struct MatrixRows {
    PetscInt count = 0;
    const PetscInt* begin = nullptr;    ///< [row] index of its first entry; size count + 1
    const PetscInt* columns = nullptr;  ///< ascending within a row
    const double* values = nullptr;
};

[[nodiscard]] inline MatrixRows rows_of(Mat sequential) {
    MatrixRows rows;
    PetscScalar* values = nullptr;
    SOFT_PETSC(MatGetLocalSize(sequential, &rows.count, nullptr));
    SOFT_PETSC(MatSeqAIJGetCSRAndMemType(sequential, &rows.begin, &rows.columns, &values, nullptr));
    rows.values = values;
    return rows;
}

[[nodiscard]] inline std::span<const PetscInt> columns_of(const MatrixRows& rows, PetscInt row) {
    return {rows.columns + rows.begin[row], rows.columns + rows.begin[row + 1]};
}

/// The unknowns of the entries K_ij that differ from K_ji, of a sequential K with a symmetric pattern.
[[nodiscard]] std::vector<PetscInt> unsymmetric_unknowns(Mat K);

}  // namespace soft::linalg
