#pragma once
/// Dense matrices with a few rows, such as the border of a bordered system (one row and column per free supply, and one for the
/// constraint). LAPACK on plain vectors.
/// Tested by linalg/small_matrix_test.
#include <optional>
#include <vector>

namespace soft::linalg {

struct SmallMatrix {
    int size = 0;
    std::vector<double> values;  ///< [row x size + column]

    explicit SmallMatrix(int n = 0) : size(n), values(static_cast<std::size_t>(n) * static_cast<std::size_t>(n), 0.0) {}
    [[nodiscard]] std::size_t index(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(size) + static_cast<std::size_t>(column);
    }
    [[nodiscard]] double& at(int row, int column) { return values[index(row, column)]; }
    [[nodiscard]] double at(int row, int column) const { return values[index(row, column)]; }
};

/// A^-1 b; nullopt for a singular matrix or a non-finite result. Rows are scaled first.
[[nodiscard]] std::optional<std::vector<double>> solve(SmallMatrix A, std::vector<double> b);

/// Number of negative eigenvalues of the symmetric part.
[[nodiscard]] int negative_eigenvalues(const SmallMatrix& A);

}  // namespace soft::linalg
