#include "linalg/matrix_rows.hpp"

#include <algorithm>
#include <cmath>

namespace soft::linalg {

namespace {

/// Two entries differ by more than rounding if their difference exceeds this fraction of the largest entry.
constexpr double visible_difference = 1e-10;

}  // namespace

std::vector<PetscInt> unsymmetric_unknowns(Mat K) {
    const MatrixRows rows = rows_of(K);
    std::vector<PetscInt> next(rows.begin, rows.begin + rows.count);  // [row] its first entry not yet compared
    std::vector<bool> found(static_cast<std::size_t>(rows.count));
    double largest = 0;
    for (PetscInt k = 0; k < rows.begin[rows.count]; ++k) largest = std::max(largest, std::abs(rows.values[k]));
    for (PetscInt row = 0; row < rows.count; ++row)
        for (PetscInt k = rows.begin[row]; k < rows.begin[row + 1]; ++k) {
            const PetscInt column = rows.columns[k];
            if (column <= row) continue;
            const auto i = static_cast<std::size_t>(row), j = static_cast<std::size_t>(column);
            PetscInt& other = next[j];  // rows have ascending columns
            const bool is_paired = other < rows.begin[column + 1] && rows.columns[other] == row;
            const double difference = rows.values[k] - (is_paired ? rows.values[other++] : 0.0);
            if (std::abs(difference) > visible_difference * largest) found[i] = found[j] = true;
        }
    std::vector<PetscInt> unknowns;
    for (PetscInt row = 0; row < rows.count; ++row)
        if (found[static_cast<std::size_t>(row)]) unknowns.push_back(row);
    return unknowns;
}

}  // namespace soft::linalg
