#pragma once
/// LDL^T (Bunch and Kaufman's pivots) or LU of a dense matrix, by LAPACK. Internal to the module. Tested by linalg/substructures_test.
#include <vector>

#include "linalg/factors.hpp"

namespace soft::linalg {

class DenseFactor {
public:
    /// `values` by columns; of a symmetric matrix the triangle above the diagonal is read.
    explicit DenseFactor(Symmetry symmetry = Symmetry::symmetric) : symmetry_(symmetry) {}
    /// False where a pivot vanishes or is not finite.
    [[nodiscard]] bool factorize(std::vector<double> values, int size);
    [[nodiscard]] PetscInt negative_eigenvalues() const;  ///< of a symmetric matrix
    [[nodiscard]] bool determinant_is_negative() const;   ///< of a general one
    void solve(std::vector<double>& b) const;             ///< in place

private:
    [[nodiscard]] double entry(int row, int column) const {
        return values_[static_cast<std::size_t>(column) * static_cast<std::size_t>(size_) +
                       static_cast<std::size_t>(row)];
    }
    Symmetry symmetry_;
    int size_ = 0;
    std::vector<double> values_;
    std::vector<PetscBLASInt> pivots_;
};

}  // namespace soft::linalg
