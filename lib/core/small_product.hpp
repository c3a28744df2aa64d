#pragma once
/// Products of matrices as small as those of a cell. Own code because a BLAS built for one thread (libopenblas0-serial) shares
/// its buffers between the threads of a program that calls it from several, without a word: its products are then wrong.
/// Tested by core/small_product_test.
namespace soft {

/// Row-major, rows one behind the other.
struct MatrixView {
    const double* numbers;
    int columns;
};

/// Numbers behind the last one of B that are read, whatever they are.
inline constexpr int gemm_padding = 7;

/// C = A^T B: C[i][j] = sum over d < depth of A[d][i] B[d][j]. Rows of C lie `next` numbers apart; nothing between them is
/// touched. The sum of an entry runs in the order of d. B has gemm_padding numbers of room behind it.
void transposed_product(int depth, MatrixView A, MatrixView B, double* C, int next);

}  // namespace soft
