#pragma once
/// A direct factorisation that PETSc does not offer: what LinearSolver puts in a PETSc preconditioner's place.
#include <optional>

#include "linalg/petsc.hpp"

namespace soft::linalg {

/// Whether the matrices equal their transposes, but for so little that iterations correct it.
enum class Symmetry { symmetric, general };

/// All calls are collective over the ranks of the matrix that the factors were made for.
class Factors {
public:
    Factors() = default;
    virtual ~Factors() = default;
    Factors(const Factors&) = delete;
    Factors& operator=(const Factors&) = delete;

    /// False where a pivot vanishes or is not finite: there is no factor then. Later matrices have the pattern of the first.
    [[nodiscard]] virtual bool factorize(Mat K) = 0;
    /// The number of negative eigenvalues of the matrix that was factorised (Sylvester); nullopt of a general one.
    [[nodiscard]] virtual std::optional<PetscInt> negative_pivots() const = 0;
    /// Of a general matrix.
    [[nodiscard]] virtual std::optional<bool> determinant_is_negative() const = 0;
    virtual void solve(Vec b, Vec x) = 0;
};

}  // namespace soft::linalg
