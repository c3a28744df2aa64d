#pragma once
/// Products of small dense matrices, such as those of one cell. Implemented here because a single-threaded BLAS
/// (libopenblas0-serial) shares its buffers between calling threads without any error, so that its products are then wrong.
/// Tested by math/small_product_test.
namespace soft {

/// Row-major, contiguous.
struct MatrixView {
    const double* numbers;
    int columns;
};

/// Number of entries after the end of B that must be readable; their values do not matter.
inline constexpr int gemm_padding = 7;

/// C = A^T B: C[i][j] = sum over d < depth of A[d][i] B[d][j]. `next` is the row stride of C; the gaps between its rows are not
/// written. Each entry is summed in the order of d. B must be followed by gemm_padding readable entries.
void transposed_product(int depth, MatrixView A, MatrixView B, double* C, int next);

}  // namespace soft
