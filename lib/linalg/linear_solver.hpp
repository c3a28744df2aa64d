#pragma once
/// Solves K x = b for a sequence of slowly changing tangents K by flexible GMRES (Saad 1993). The preconditioner is built from one of
/// these tangents: a direct factorisation or a cheaper preconditioner (LinearSettings).
///   automatic: LDL^T without pivoting (multifrontal.hpp); on several ranks only if it needs few flops, because each rank factorises
///       the whole matrix. The solver switches permanently to LDL^T by MUMPS when a factorisation fails or needs many iterations.
///       MUMPS runs as one distributed instance on one rank or on very many, otherwise as one instance per rank (substructures.hpp).
///       With a fresh factor of a symmetric K the loop takes one or two iterations. The same loop corrects the unsymmetric part of K
///       (a follower pressure on a surface with a free edge), which LDL^T ignores unless the few
///       unknowns of such entries are given as `last`. If that part is large, the loop needs many iterations and the solver switches permanently to LU. If the caller declares K unsymmetric, the solver starts with LU.
///   mumps_ldlt, mumps_lu, superlu_dist, cholmod: this factorisation, however many iterations it needs. CHOLMOD's LL^T fails
///       (reported as a value) if K is not positive definite: beyond a limit point, and for any K with pressure unknowns.
///   krylov: the preconditioner of the settings; jacobian_free: the same, with an operator provided by the caller.
/// Tested by linalg/linear_solver_test, solver/linear_methods_test.
#include <memory>
#include <optional>
#include <vector>

#include "linalg/factors.hpp"
#include "linalg/multigrid.hpp"
#include "linalg/petsc.hpp"
#include "linalg/threaded_product.hpp"
#include "math/linear_settings.hpp"

namespace soft::linalg {

struct Factorization {
    bool succeeded = false;
    std::optional<PetscInt> negative_pivots;      ///< empty unless the preconditioner is an LDL^T factor
    std::optional<bool> determinant_is_negative;  ///< of an LU factor; empty for any other preconditioner
};

struct LinearSolve {
    bool converged = false;
    int iterations = 0;
    bool at_limit = false;  ///< a Krylov method reached its iteration limit: x is its best iterate (inexact Newton)
    [[nodiscard]] bool usable() const noexcept { return converged || at_limit; }
};

/// fresh: the last factor belongs to the current K; stale: to an earlier K.
enum class Factor { fresh, stale };

struct SolveSettings {
    Factor factor = Factor::fresh;
    double tolerance = 0;    ///< of the residual over the norm of the right-hand side; that of the settings at least
    int max_iterations = 0;  ///< 0: that of the settings
    bool starts_from_x = false;  ///< x is the last iterate, or the solution with a nearby K
};

class LinearSolver {
public:
    /// PETSc options (-ksp_*, -pc_*, -mat_mumps_*) override the defaults. Throws Error (bad_input) for a library that PETSc was built
    /// without, and for CHOLMOD on several ranks. `threads` (math/threads.hpp) are used by factorisations and
    /// products of method automatic; the results do not depend on their number.
    /// `last`: the unknowns of unsymmetric entries of a K that is called symmetric (multifrontal.hpp).
    explicit LinearSolver(Mat K, Symmetry symmetry = Symmetry::symmetric, const LinearSettings& settings = {},
                          int threads = 0, std::vector<PetscInt> last = {});

    /// Required by Preconditioner::multigrid, before the first factorize().
    void set_levels(ElementLevels levels);

    /// To be called when K has another pattern; the next factorize() orders the unknowns again.
    void pattern_changed();

    /// Sets the operator of method jacobian_free, not owned. The preconditioner is still built from K.
    void set_operator(Mat A) { operator_ = A; }

    /// Builds the preconditioner, usually a factorisation, of the current K. A failure (K singular, K not positive definite for
    /// CHOLMOD, a zero pivot of ILU) is returned as a value, not thrown.
    [[nodiscard]] Factorization factorize();

    /// Sign of det K from a separate MUMPS LU factorisation, as a check of the inertia reported by LDL^T; nullopt if it fails. LDL^T
    /// reads only one triangle of K: if K is slightly unsymmetric and nearly singular, the inertia of the symmetric matrix may differ
    /// from that of K.
    [[nodiscard]] std::optional<bool> determinant_is_negative();

    /// Solves with the current K and the last factor. Method automatic switches to LU only if a fresh LDL^T factor needs many iterations.
    [[nodiscard]] LinearSolve solve(Vec b, Vec x, const SolveSettings& how = {});

    /// Solves K^T x = b with the last factor, which must be symmetric: an LU factor, and an operator in the place of K, do not converge.
    [[nodiscard]] LinearSolve solve_transposed(Vec b, Vec x);

    [[nodiscard]] bool is_krylov() const noexcept {
        return settings_.method == LinearMethod::krylov || settings_.method == LinearMethod::jacobian_free;
    }
    /// True for a factorisation, whose stale factor remains a good preconditioner for some steps.
    [[nodiscard]] bool is_direct() const noexcept { return !is_krylov(); }
    [[nodiscard]] const LinearSettings& settings() const noexcept { return settings_; }
    /// Number of iterations that take as long as a factorisation, from counts; 0 if unknown.
    [[nodiscard]] double iterations_per_factorization() const noexcept { return iterations_per_factorization_; }
    [[nodiscard]] int factorizations() const noexcept { return factorizations_; }
    [[nodiscard]] long iterations() const noexcept { return iterations_; }  ///< total over all solves
    [[nodiscard]] KSP ksp() const noexcept { return ksp_; }

private:
    void use_threads_for_products();
    void set_operators();
    [[nodiscard]] PetscErrorCode set_up();
    /// The factorisations that method automatic tries, in this order.
    enum class Choice { multifrontal, ldlt, lu };
    void use_factorization(Choice choice);
    void try_multifrontal();
    /// Returns false if no other factorisation is left to try.
    [[nodiscard]] bool use_next_factorization();
    [[nodiscard]] bool has_own_factors() const;
    [[nodiscard]] PC preconditioner() const;
    [[nodiscard]] LinearSolve solve_once(Vec b, Vec x, const SolveSettings& how = {});
    /// Returns true for a numerical failure; throws for any other error code.
    [[nodiscard]] bool is_numerical_failure(PetscErrorCode code, const char* call) const;

    Mat K_, operator_ = nullptr;
    LinearSettings settings_;
    int threads_;
    Choice choice_ = Choice::lu;    // of method automatic
    std::vector<PetscInt> order_;   // elimination order of the substructures
    std::vector<PetscInt> last_;    // unknowns that the multifrontal factor eliminates last
    std::unique_ptr<Factors> own_;  // used by the preconditioner of ksp_, which is destroyed first
    std::unique_ptr<Multigrid> multigrid_;
    std::unique_ptr<ThreadedProduct> product_;  // of large matrices
    KrylovSolver ksp_;
    double iterations_per_factorization_ = 0;
    int factorizations_ = 0;
    long iterations_ = 0;
};

}  // namespace soft::linalg
