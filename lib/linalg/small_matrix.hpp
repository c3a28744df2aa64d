#pragma once
/// Dense matrices of a few rows, such as the border (a row and column a free supply, and one for the constraint): LAPACK on
/// plain vectors.
/// Tested by linalg/small_matrix_test.
#include <optional>
#include <vector>

namespace soft::linalg {

struct SmallMatrix {
    int size = 0;
    std::vector<double> values;  ///< [row x size + column]

    explicit SmallMatrix(int n = 0) : size(n), values(static_cast<std::size_t>(n) * static_cast<std::size_t>(n), 0.0) {}
    [[nodiscard]] std::size_t place(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(size) + static_cast<std::size_t>(column);
    }
    [[nodiscard]] double& at(int row, int column) { return values[place(row, column)]; }
    [[nodiscard]] double at(int row, int column) const { return values[place(row, column)]; }
};

/// A^-1 b; nullopt for a singular matrix or a result that is not finite. Rows are scaled first.
[[nodiscard]] std::optional<std::vector<double>> solve(SmallMatrix A, std::vector<double> b);

/// Number of negative eigenvalues of the symmetric part.
[[nodiscard]] int negative_eigenvalues(const SmallMatrix& A);

/// Eigenvalues, ascending, and their vectors of length 1, one a row of `vectors`.
struct Eigen {
    std::vector<double> values;
    SmallMatrix vectors;
};
[[nodiscard]] Eigen symmetric_eigen(SmallMatrix A);
/// Of a matrix whose eigenvalues are known to be real; imaginary parts, which are rounding, are left out. Throws
/// std::logic_error where LAPACK does not converge.
[[nodiscard]] Eigen real_eigen(const SmallMatrix& A);

}  // namespace soft::linalg
