#pragma once
/// Solves K x = b for a sequence of slowly changing tangents K by flexible GMRES (Saad 1993) with a preconditioner made from
/// one of them: a direct factorisation or one of the cheaper kinds (model::LinearSettings).
///   automatic: LDL^T, where it takes few flops without pivoting (sparse_ldlt.hpp), else by MUMPS, which also takes over for good
///       where the first vanishes or takes many iterations: one for all on one rank or very many, else one a rank
///       (substructures.hpp). With a fresh factor of a symmetric K this is one application; the same loop corrects the part of K
///       that is not symmetric (a pressure whose surface has a free rim), which LDL^T does not see. Where that part is large
///       the loop takes many iterations: then the solver goes over to LU for good; where it is known beforehand, LU is taken
///       from the start.
///   mumps_ldlt, mumps_lu, superlu_dist, cholmod: that factorisation, whatever the iterations. CHOLMOD's LL^T fails (a value)
///       where K is not positive definite: beyond a limit point, and for any K with pressure unknowns.
///   krylov: the preconditioner of the settings; jacobian_free: the same, for an operator that the caller gives.
/// Tested by linalg/linear_solver_test, solver/linear_methods_test.
#include <memory>
#include <optional>
#include <vector>

#include "linalg/factors.hpp"
#include "linalg/multigrid.hpp"
#include "linalg/petsc.hpp"
#include "model/settings.hpp"

namespace soft::linalg {

struct Factorization {
    bool succeeded = false;
    std::optional<PetscInt> negative_pivots;      ///< empty where the preconditioner is no LDL^T factor
    std::optional<bool> determinant_is_negative;  ///< of an LU factor; empty for any other preconditioner
};

struct LinearSolve {
    bool converged = false;
    int iterations = 0;
    bool at_limit = false;  ///< a Krylov method has reached its iteration limit: x is its best so far (inexact Newton)
    [[nodiscard]] bool usable() const noexcept { return converged || at_limit; }
};

/// Whether the last factor is that of K as it stands, or of a K shortly before.
enum class Factor { fresh, stale };

class LinearSolver {
public:
    /// Default options can be changed by any PETSc option (-ksp_*, -pc_*, -mat_mumps_*). Throws Error (bad_input) for a
    /// library that this PETSc was built without, and for CHOLMOD on several ranks.
    explicit LinearSolver(Mat K, Symmetry symmetry = Symmetry::symmetric, const model::LinearSettings& settings = {});

    /// What Preconditioner::multigrid needs, before the first factorize().
    void set_levels(ElementLevels levels);

    /// The operator of method jacobian_free, not owned; K then is what the preconditioner is made from.
    void set_operator(Mat A) { operator_ = A; }

    /// Makes the preconditioner, mostly a factorisation, of K as it stands now. A failed one (singular, not positive definite
    /// for CHOLMOD, a zero pivot of ILU) is a value, not an exception.
    [[nodiscard]] Factorization factorize();

    /// Sign of det K by a MUMPS LU factorisation of its own, to check an LDL^T count of the same library; nullopt where it
    /// fails. An LDL^T factor sees one triangle of K: where K is not quite symmetric and nearly singular its inertia may be
    /// that of a neighbour.
    [[nodiscard]] std::optional<bool> determinant_is_negative();

    /// Solves with K as it stands now and the last factor. `x` is overwritten. Only a fresh LDL^T factor that needs many
    /// iterations is reason to go over to LU (automatic).
    [[nodiscard]] LinearSolve solve(Vec b, Vec x, Factor factor = Factor::fresh);

    /// The same with a stale factor, no further than a residual of `tolerance` times the right-hand side.
    [[nodiscard]] LinearSolve solve_roughly(Vec b, Vec x, double tolerance);

    /// Goes on from x, where a solve of a Krylov method has reached its limit; as many iterations once more.
    [[nodiscard]] LinearSolve improve(Vec b, Vec x);

    [[nodiscard]] bool is_krylov() const noexcept {
        return settings_.method == model::LinearMethod::krylov ||
               settings_.method == model::LinearMethod::jacobian_free;
    }
    /// By a factorisation, whose stale factor is a good preconditioner for a while.
    [[nodiscard]] bool is_direct() const noexcept { return !is_krylov(); }
    [[nodiscard]] const model::LinearSettings& settings() const noexcept { return settings_; }
    [[nodiscard]] int factorizations() const noexcept { return factorizations_; }
    [[nodiscard]] long iterations() const noexcept { return iterations_; }  ///< of all solves so far
    [[nodiscard]] KSP ksp() const noexcept { return ksp_; }

private:
    void set_operators();
    [[nodiscard]] PetscErrorCode set_up();
    /// What `automatic` takes, one after the other.
    enum class Choice { small_ldlt, ldlt, lu };
    void take(Choice choice);
    void take_small_factors();
    /// False where there is nothing left.
    [[nodiscard]] bool take_next_factorization();
    [[nodiscard]] bool has_own_factors() const;
    [[nodiscard]] LinearSolve solve_once(Vec b, Vec x);
    /// True where the failure is a property of the numbers; throws where it is not.
    [[nodiscard]] bool is_numerical_failure(PetscErrorCode code, const char* call) const;

    Mat K_, operator_ = nullptr;
    model::LinearSettings settings_;
    Choice choice_ = Choice::lu;    // of method automatic
    std::vector<PetscInt> order_;   // of the elimination by substructures
    std::unique_ptr<Factors> own_;  // behind the preconditioner of ksp_, which goes first
    std::unique_ptr<Multigrid> multigrid_;
    KrylovSolver ksp_;
    int factorizations_ = 0;
    long iterations_ = 0;
};

}  // namespace soft::linalg
