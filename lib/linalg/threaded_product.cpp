#include "linalg/threaded_product.hpp"

#include <algorithm>
#include <span>

#include "linalg/matrix_rows.hpp"
#include "math/lanes.hpp"
#include "math/threads.hpp"

namespace soft::linalg {

namespace {

/// Rows with the same columns (the displacements of a node) are multiplied together, which reads the columns once.
constexpr PetscInt most_together = 3;

std::vector<PetscInt> find_groups(const MatrixRows& rows) {
    std::vector<PetscInt> first_row{0};
    for (PetscInt row = 1; row < rows.count; ++row)
        if (row - first_row.back() == most_together ||
            !std::ranges::equal(columns_of(rows, first_row.back()), columns_of(rows, row)))
            first_row.push_back(row);
    first_row.push_back(rows.count);
    return first_row;
}

template <int count>
void multiply_rows(const MatrixRows& rows, PetscInt row, const PetscScalar* x, PetscScalar* y) {
    const PetscInt *columns = rows.columns + rows.begin[row], length = rows.begin[row + 1] - rows.begin[row];
    const double* values = rows.values + rows.begin[row];
    Lanes sums[count] = {};
    PetscInt k = 0;
    for (; k + lane_count <= length; k += lane_count) {
        const Lanes x_k{x[columns[k]], x[columns[k + 1]], x[columns[k + 2]], x[columns[k + 3]]};
        for (int r = 0; r < count; ++r) {
            Lanes v;
            load(values + r * length + k, v);
            __builtin_prefetch(values + (r + count) * length + k);  // rows are too short for the processor to do so
            sums[r] += v * x_k;
        }
    }
    for (int r = 0; r < count; ++r) {
        double sum = (sums[r][0] + sums[r][1]) + (sums[r][2] + sums[r][3]);
        for (PetscInt last = k; last < length; ++last) sum += values[r * length + last] * x[columns[last]];
        y[row + r] = sum;
    }
}

SOFT_VECTOR_CLONES
void multiply_groups(const MatrixRows& rows, std::span<const PetscInt> first_row, const PetscScalar* x,
                     PetscScalar* y) {
    for (std::size_t group = 0; group + 1 < first_row.size(); ++group) {
        const PetscInt row = first_row[group], count = first_row[group + 1] - row;
        if (count == 3)
            multiply_rows<3>(rows, row, x, y);
        else if (count == 2)
            multiply_rows<2>(rows, row, x, y);
        else
            multiply_rows<1>(rows, row, x, y);
    }
}

}  // namespace

ThreadedProduct::ThreadedProduct(Mat K, int threads) : K_(K), threads_(thread_count(threads)) {
    const MatrixRows rows = rows_of(K);
    first_row_ = find_groups(rows);
    SOFT_PETSC(MatCreateShell(PETSC_COMM_SELF, rows.count, rows.count, rows.count, rows.count, this, operation_.out()));
    SOFT_PETSC(MatShellSetOperation(operation_, MATOP_MULT, reinterpret_cast<void (*)()>(multiply)));
}

PetscErrorCode ThreadedProduct::multiply(Mat operation, Vec from, Vec to) {
    void* context = nullptr;
    SOFT_PETSC(MatShellGetContext(operation, static_cast<void*>(&context)));
    const auto& product = *static_cast<const ThreadedProduct*>(context);
    const MatrixRows rows = rows_of(product.K_);
    const PetscScalar* x = nullptr;
    PetscScalar* y = nullptr;
    SOFT_PETSC(VecGetArrayRead(from, &x));
    SOFT_PETSC(VecGetArrayWrite(to, &y));
    for_ranges(product.first_row_.size() - 1, product.threads_, [&](std::size_t begin, std::size_t end) {
        multiply_groups(rows, std::span(product.first_row_).subspan(begin, end - begin + 1), x, y);
    });
    SOFT_PETSC(VecRestoreArrayWrite(to, &y));
    SOFT_PETSC(VecRestoreArrayRead(from, &x));
    return 0;
}

}  // namespace soft::linalg
