#pragma once
/// LDL^T (Bunch-Kaufman pivoting) or LU factorisation of a dense matrix by LAPACK. Internal to the module.
/// Tested by linalg/substructures_test.
#include <vector>

#include "linalg/factors.hpp"

namespace soft::linalg {

class DenseFactor {
public:
    /// `values` are stored by columns; only the upper triangle of a symmetric matrix is read.
    explicit DenseFactor(Symmetry symmetry = Symmetry::symmetric) : symmetry_(symmetry) {}
    /// Returns false if a pivot is zero or not finite.
    [[nodiscard]] bool factorize(std::vector<double> values, int size);
    [[nodiscard]] PetscInt negative_eigenvalues() const;                ///< symmetric matrices only
    [[nodiscard]] bool determinant_is_negative() const;                 ///< general matrices only
    void solve(std::vector<double>& b, bool transposed = false) const;  ///< in place

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
