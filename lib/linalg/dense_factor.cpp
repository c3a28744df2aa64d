#include "linalg/dense_factor.hpp"

#include <petscblaslapack.h>

#include <algorithm>
#include <cmath>

namespace soft::linalg {

bool DenseFactor::factorize(std::vector<double> values, int size) {
    values_ = std::move(values);
    size_ = size;
    pivots_.assign(static_cast<std::size_t>(size), 0);
    if (!std::ranges::all_of(values_, [](double value) { return std::isfinite(value); })) return false;
    const PetscBLASInt n = size;
    PetscBLASInt info = 0;
    if (symmetry_ == Symmetry::general) {
        LAPACKgetrf_(&n, &n, values_.data(), &n, pivots_.data(), &info);
        return info == 0;
    }
    PetscBLASInt work_size = 64 * n;  // blocks of 64 columns
    std::vector<double> work(static_cast<std::size_t>(work_size));
    LAPACKsytrf_("U", &n, values_.data(), &n, pivots_.data(), work.data(), &work_size, &info);
    return info == 0;
}

/// A 2 x 2 pivot block has one positive and one negative eigenvalue.
PetscInt DenseFactor::negative_eigenvalues() const {
    PetscInt negative = 0, in_blocks = 0;
    for (int i = 0; i < size_; ++i) {
        if (pivots_[static_cast<std::size_t>(i)] < 0)
            ++in_blocks;
        else if (entry(i, i) < 0.0)
            ++negative;
    }
    return negative + in_blocks / 2;
}

bool DenseFactor::determinant_is_negative() const {
    bool negative = false;
    for (int i = 0; i < size_; ++i) {
        if (entry(i, i) < 0.0) negative = !negative;
        if (pivots_[static_cast<std::size_t>(i)] != i + 1) negative = !negative;  // row interchange
    }
    return negative;
}

void DenseFactor::solve(std::vector<double>& b, bool transposed) const {
    const PetscBLASInt n = size_, one = 1;
    PetscBLASInt info = 0;
    if (symmetry_ == Symmetry::general)
        LAPACKgetrs_(transposed ? "T" : "N", &n, &one, values_.data(), &n, pivots_.data(), b.data(), &n, &info);
    else
        LAPACKsytrs_("U", &n, &one, values_.data(), &n, pivots_.data(), b.data(), &n, &info);
}

}  // namespace soft::linalg
