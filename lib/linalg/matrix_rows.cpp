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
    std::vector<bool> found(static_cast<std::size_t>(rows.count));
    double largest = 0;
    for (PetscInt k = 0; k < rows.begin[rows.count]; ++k) largest = std::max(largest, std::abs(rows.values[k]));
    const double visible = visible_difference * largest;
    for (PetscInt row = 0; row < rows.count; ++row)
        for (PetscInt k = rows.begin[row]; k < rows.begin[row + 1]; ++k) {
            if (std::abs(rows.values[k]) <= 0.5 * visible) continue;  // one of a visible difference is larger
            const PetscInt column = rows.columns[k];
            const PetscInt *first = rows.columns + rows.begin[column], *last = rows.columns + rows.begin[column + 1];
            const PetscInt* other = std::lower_bound(first, last, row);
            const bool is_paired = other != last && *other == row;
            const double difference = rows.values[k] - (is_paired ? rows.values[other - rows.columns] : 0.0);
            if (std::abs(difference) > visible)
                found[static_cast<std::size_t>(row)] = found[static_cast<std::size_t>(column)] = true;
        }
    std::vector<PetscInt> unknowns;
    for (PetscInt row = 0; row < rows.count; ++row)
        if (found[static_cast<std::size_t>(row)]) unknowns.push_back(row);
    return unknowns;
}

}  // namespace soft::linalg
