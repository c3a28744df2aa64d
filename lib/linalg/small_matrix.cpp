#include "linalg/small_matrix.hpp"

#include <petscsys.h>
// Requires petscsys.h before it.
#include <petscblaslapack.h>

#include <algorithm>
#include <cmath>

namespace soft::linalg {

std::optional<std::vector<double>> solve(SmallMatrix A, std::vector<double> b) {
    const int n = A.size;
    SmallMatrix columns(n);  // column-major, as LAPACK expects
    for (int i = 0; i < n; ++i) {
        double largest = 0;
        for (int j = 0; j < n; ++j) largest = std::max(largest, std::abs(A.at(i, j)));
        if (!(largest > 0.0) || !std::isfinite(largest)) return std::nullopt;
        for (int j = 0; j < n; ++j) columns.at(j, i) = A.at(i, j) / largest;
        b[static_cast<std::size_t>(i)] /= largest;
    }
    PetscBLASInt size = n, one = 1, info = 0;
    std::vector<PetscBLASInt> pivots(static_cast<std::size_t>(n));
    LAPACKgesv_(&size, &one, columns.values.data(), &size, pivots.data(), b.data(), &size, &info);
    if (info != 0 || !std::all_of(b.begin(), b.end(), [](double value) { return std::isfinite(value); }))
        return std::nullopt;
    return b;
}

int negative_eigenvalues(const SmallMatrix& A) {
    const int n = A.size;
    if (n == 0) return 0;
    SmallMatrix symmetric(n);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) symmetric.at(i, j) = 0.5 * (A.at(i, j) + A.at(j, i));
    PetscBLASInt size = n, work_size = std::max(1, 3 * n - 1), info = 0;
    std::vector<double> eigenvalues(static_cast<std::size_t>(n)), work(static_cast<std::size_t>(work_size));
    LAPACKsyev_("N", "U", &size, symmetric.values.data(), &size, eigenvalues.data(), work.data(), &work_size, &info);
    return static_cast<int>(
        std::count_if(eigenvalues.begin(), eigenvalues.end(), [](double value) { return value < 0.0; }));
}

}  // namespace soft::linalg
