#pragma once
/// Solves K x = b for a sequence of slowly changing tangents K: a direct factorisation (MUMPS LDL^T unless PETSc
/// options say otherwise) of one of them preconditions flexible GMRES for the others. With a fresh factor of a
/// symmetric K this is one application; the same loop corrects the part of K that is not symmetric (a pressure whose
/// surface has a free rim), which LDL^T does not see. Where that part is large the loop takes many iterations: then the
/// solver goes over to LU for good; where it is known beforehand, LU is taken from the start. Held by linalg/linear_solver_test.
#include <optional>

#include "linalg/petsc.hpp"

namespace soft::linalg {

struct Factorization {
    bool succeeded = false;
    std::optional<PetscInt> negative_pivots;   ///< empty where the preconditioner is no LDL^T factor
    std::optional<bool> determinant_is_negative;   ///< of an LU factor; empty for any other preconditioner
};

struct LinearSolve {
    bool converged = false;
    int iterations = 0;
};

/// Whether the last factor is that of K as it stands, or of a K shortly before.
enum class Factor { fresh, stale };

enum class Symmetry { symmetric, general };

class LinearSolver {
public:
    /// Default options can be changed by any PETSc option (-ksp_*, -pc_*, -mat_mumps_*).
    explicit LinearSolver(Mat K, Symmetry symmetry = Symmetry::symmetric);

    /// Factorises K as it stands now. A failed factorisation (singular, out of memory) is a value, not an exception.
    [[nodiscard]] Factorization factorize();

    /// Sign of det K by an LU factorisation of its own, whatever else K is solved with; nullopt where that fails. An LDL^T
    /// factor sees one triangle of K: where K is not quite symmetric and nearly singular its inertia may be that of a
    /// neighbour.
    [[nodiscard]] std::optional<bool> determinant_is_negative();

    /// Solves with K as it stands now and the last factor. `x` is overwritten. Only a fresh LDL^T factor that needs many
    /// iterations is reason to go over to LU.
    [[nodiscard]] LinearSolve solve(Vec b, Vec x, Factor factor = Factor::fresh);

    [[nodiscard]] int factorizations() const noexcept { return factorizations_; }
    [[nodiscard]] KSP ksp() const noexcept { return ksp_; }

private:
    [[nodiscard]] LinearSolve solve_once(Vec b, Vec x);

    Mat K_;
    KrylovSolver ksp_;
    int factorizations_ = 0;
};

}  // namespace soft::linalg
