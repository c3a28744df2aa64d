#pragma once
/// Interface of a direct factorisation that PETSc does not provide. LinearSolver applies it through a PCSHELL.
#include <optional>

#include "linalg/petsc.hpp"

namespace soft::linalg {

/// symmetric: the matrix equals its transpose up to a part that is small enough for the iterations to correct.
enum class Symmetry { symmetric, general };

/// All calls are collective over the ranks of the matrix passed at construction.
class Factors {
public:
    Factors() = default;
    virtual ~Factors() = default;
    Factors(const Factors&) = delete;
    Factors& operator=(const Factors&) = delete;

    /// Returns false if a pivot is zero or not finite; no factor exists then. All matrices must have the pattern of the first.
    [[nodiscard]] virtual bool factorize(Mat K) = 0;
    /// Number of negative eigenvalues of the factorised matrix (Sylvester's law of inertia); nullopt for a general matrix.
    [[nodiscard]] virtual std::optional<PetscInt> negative_pivots() const = 0;
    /// nullopt for a symmetric matrix.
    [[nodiscard]] virtual std::optional<bool> determinant_is_negative() const = 0;
    virtual void solve(Vec b, Vec x) = 0;
    /// Whether later solves are with the transposed matrix; ignored by factors of symmetric matrices.
    virtual void set_transposed(bool) {}
};

}  // namespace soft::linalg
