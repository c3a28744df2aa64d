#include "linalg/linear_solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "linalg/multifrontal.hpp"
#include "linalg/mumps.hpp"
#include "linalg/preconditioner.hpp"
#include "linalg/profile.hpp"
#include "linalg/substructures.hpp"

namespace soft::linalg {

namespace {

/// GMRES restart lengths. Multigrid is meant for large systems, in which each vector takes much memory.
constexpr int max_restart = 300, max_multigrid_restart = 100;

int restart_of(const LinearSettings& settings) {
    const bool large = settings.preconditioner == Preconditioner::multigrid;
    return std::min(settings.iteration_limit, large ? max_multigrid_restart : max_restart);
}

/// A factor that needs more iterations approximates K too poorly. MUMPS's LDL^T takes twice as long as that without pivoting, and its
/// LU a quarter more than LDL^T, as much as four or five iterations, and does not give the inertia.
constexpr int max_iterations_without_pivoting = 6, max_iterations_of_ldlt = 4;

/// On several ranks, above this a distributed factorisation is faster than that of the whole matrix on each rank.
constexpr double flops_of_each_rank = 1e8;
/// Flops of a factorisation in the time of an iteration, per entry of K: its triangular solves and products are bound by memory (measured on
/// fingers of 36,000 and 251,000 unknowns; small matrices take fewer).
constexpr double flops_per_entry = 42;

PetscErrorCode apply_factors(PC pc, Vec b, Vec x) {
    void* context = nullptr;
    SOFT_PETSC(PCShellGetContext(pc, &context));
    const ScopedTimer timed(Phase::factor_solve);
    static_cast<Factors*>(context)->solve(b, x);
    return 0;
}

}  // namespace

LinearSolver::LinearSolver(Mat K, Symmetry symmetry, const LinearSettings& settings, int threads,
                           std::vector<PetscInt> last)
    : K_(K), settings_(settings), threads_(threads), last_(std::move(last)) {
    SOFT_PETSC(KSPCreate(PetscObjectComm(reinterpret_cast<PetscObject>(K)), ksp_.out()));
    SOFT_PETSC(KSPSetType(ksp_, KSPFGMRES));
    SOFT_PETSC(KSPGMRESSetRestart(ksp_, restart_of(settings)));
    SOFT_PETSC(KSPSetTolerances(ksp_, settings.tolerance, PETSC_DEFAULT, PETSC_DEFAULT, settings.iteration_limit));
    const PC pc = preconditioner();
    if (settings.method != LinearMethod::automatic)
        set_type(pc, settings, symmetry);
    else
        use_factorization(symmetry == Symmetry::symmetric ? Choice::multifrontal : Choice::lu);
    SOFT_PETSC(KSPSetFromOptions(ksp_));
    use_threads_for_products();
    set_operators();
}

void LinearSolver::use_threads_for_products() {
    product_.reset();
    PetscBool sequential = PETSC_FALSE;
    MatInfo entries;
    SOFT_PETSC(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(K_), MATSEQAIJ, &sequential));
    SOFT_PETSC(MatGetInfo(K_, MAT_LOCAL, &entries));
    const bool is_large = sequential == PETSC_TRUE && entries.nz_used > entries_of_threaded_product;
    if (is_large && settings_.method == LinearMethod::automatic)
        product_ = std::make_unique<ThreadedProduct>(K_, threads_);
}

void LinearSolver::pattern_changed() {
    SOFT_PETSC(KSPReset(ksp_));
    order_.clear();
    if (settings_.method == LinearMethod::automatic) use_factorization(choice_);
    if (multigrid_) multigrid_->attach(preconditioner());
    use_threads_for_products();
    set_operators();
}

void LinearSolver::use_factorization(Choice choice) {
    PetscBool chosen = PETSC_FALSE;
    SOFT_PETSC(PetscOptionsHasName(nullptr, nullptr, "-pc_type", &chosen));  // the user overrides set_type
    const PC pc = preconditioner();
    own_.reset();
    iterations_per_factorization_ = 0;
    choice_ = choice;
    const char* name = "LDL^T without pivoting, multifrontal";
    if (choice == Choice::multifrontal) {
        if (chosen == PETSC_FALSE) try_multifrontal();
        if (!own_) return use_factorization(Choice::ldlt);
    } else if (chosen == PETSC_FALSE) {
        const ScopedTimer timed(Phase::ordering);
        own_ = Substructures::create(K_, choice == Choice::ldlt ? Symmetry::symmetric : Symmetry::general, order_);
        name = choice == Choice::ldlt ? "LDL^T by substructures, MUMPS" : "LU by substructures, MUMPS";
    }
    if (!own_) {
        LinearSettings mumps = settings_;
        mumps.method = choice == Choice::ldlt ? LinearMethod::mumps_ldlt : LinearMethod::mumps_lu;
        return set_type(pc, mumps, Symmetry::symmetric);
    }
    SOFT_PETSC(PCSetType(pc, PCSHELL));
    SOFT_PETSC(PCShellSetContext(pc, own_.get()));
    SOFT_PETSC(PCShellSetApply(pc, apply_factors));
    SOFT_PETSC(PCShellSetName(pc, name));
}

void LinearSolver::try_multifrontal() {
    int ranks = 1;
    MPI_Comm_size(PetscObjectComm(reinterpret_cast<PetscObject>(K_)), &ranks);
    if (ranks > 1) {
        // The factor has at least as many entries as the triangle of K; with n columns the flops are at least entries^2 / n.
        PetscInt unknowns = 0;
        MatInfo entries;
        SOFT_PETSC(MatGetSize(K_, &unknowns, nullptr));
        SOFT_PETSC(MatGetInfo(K_, MAT_GLOBAL_SUM, &entries));
        const double n = unknowns, triangle = (entries.nz_used + n) / 2.0;
        if (triangle * triangle / n > flops_of_each_rank) return;
    }
    const ScopedTimer timed(Phase::ordering);
    auto factors = std::make_unique<Multifrontal>(K_, threads_, last_);
    const double limit = ranks > 1 ? flops_of_each_rank : std::numeric_limits<double>::max();
    if (!(factors->flops() <= limit)) return;
    MatInfo info;
    SOFT_PETSC(MatGetInfo(K_, MAT_GLOBAL_SUM, &info));
    iterations_per_factorization_ = factors->flops() / (flops_per_entry * info.nz_used);
    own_ = std::move(factors);
}

PC LinearSolver::preconditioner() const {
    PC pc = nullptr;
    SOFT_PETSC(KSPGetPC(ksp_, &pc));
    return pc;
}

bool LinearSolver::has_own_factors() const { return own_ && is_type(preconditioner(), PCSHELL); }

void LinearSolver::set_levels(ElementLevels levels) {
    multigrid_ = std::make_unique<Multigrid>(std::move(levels));
    multigrid_->attach(preconditioner());
}

void LinearSolver::set_operators() {
    const bool given = settings_.method == LinearMethod::jacobian_free && operator_ != nullptr;
    const Mat product = product_ ? product_->operation() : K_;
    SOFT_PETSC(KSPSetOperators(ksp_, given ? operator_ : product, K_));
}

PetscErrorCode LinearSolver::set_up() {
    const PetscErrorCode code = KSPSetUp(ksp_);
    const PC pc = preconditioner();
    if (code != 0 || !is_type(pc, PCASM)) return code;
    set_block_type(pc, settings_.preconditioner);
    return KSPSetUpOnBlocks(ksp_);
}

/// PETSc raises an error if CHOLMOD finds a pivot, or multigrid a spectrum, that is not positive.
bool LinearSolver::is_numerical_failure(PetscErrorCode code, const char* call) const {
    if (code == 0) return false;
    const bool may_fail = is_krylov() || settings_.method == LinearMethod::cholmod;
    const bool is_program_error = code == PETSC_ERR_MEM || code == PETSC_ERR_ARG_UNKNOWN_TYPE ||
                                  code == PETSC_ERR_MISSING_FACTOR || code == PETSC_ERR_USER;
    if (!may_fail || is_program_error) check(code, call);
    return true;
}

Factorization LinearSolver::factorize() {
    ++factorizations_;
    set_operators();
    const PC pc = preconditioner();
    if (has_own_factors()) {
        const ScopedTimer timed(Phase::factorization);
        if (own_->factorize(K_)) return {true, own_->negative_pivots(), own_->determinant_is_negative()};
    }
    if (has_own_factors()) {
        if (choice_ != Choice::multifrontal) return {};
        use_factorization(Choice::ldlt);
        SOFT_PETSC(PCSetFromOptions(pc));
        return factorize();
    }
    SOFT_PETSC(KSPSetReusePreconditioner(ksp_, PETSC_FALSE));
    const bool raised = is_numerical_failure(set_up(), "KSPSetUp");
    SOFT_PETSC(KSPSetReusePreconditioner(ksp_, PETSC_TRUE));
    if (raised) {
        SOFT_PETSC(KSPReset(ksp_));  // discards the partial set-up and its vectors
        return {};
    }
    PCFailedReason failed = PC_NOERROR;
    SOFT_PETSC(PCGetFailedReason(pc, &failed));
    Factorization result{failed == PC_NOERROR, std::nullopt, std::nullopt};
    if (!is_mumps(pc)) return result;
    Mat factor = nullptr;
    SOFT_PETSC(PCFactorGetMatrix(pc, &factor));
    PetscInt status = 0;
    SOFT_PETSC(MatMumpsGetInfog(factor, 1, &status));  // a failed MUMPS factorisation returns no PETSc error
    require_mumps_memory(status);
    if (status < 0) return {false, std::nullopt, std::nullopt};
    if (is_type(pc, PCCHOLESKY)) {
        PetscInt negative = 0;
        SOFT_PETSC(MatMumpsGetInfog(factor, 12, &negative));
        result.negative_pivots = negative;
    } else if (is_type(pc, PCLU)) {
        PetscReal mantissa = 0;
        SOFT_PETSC(MatMumpsGetRinfog(factor, 12, &mantissa));
        result.determinant_is_negative = mantissa < 0.0;
    }
    return result;
}

std::optional<bool> LinearSolver::determinant_is_negative() {
    ++factorizations_;
    Matrix factor;
    IndexSet rows, columns;
    MatFactorInfo info;
    SOFT_PETSC(MatFactorInfoInitialize(&info));
    SOFT_PETSC(MatGetFactor(K_, MATSOLVERMUMPS, MAT_FACTOR_LU, factor.out()));
    SOFT_PETSC(MatMumpsSetIcntl(factor, 33, 1));   // compute the determinant
    SOFT_PETSC(MatMumpsSetIcntl(factor, 14, 80));  // as in the constructor
    SOFT_PETSC(MatGetOrdering(K_, MATORDERINGEXTERNAL, rows.out(), columns.out()));
    SOFT_PETSC(MatLUFactorSymbolic(factor, K_, rows, columns, &info));
    SOFT_PETSC(MatLUFactorNumeric(factor, K_, &info));
    PetscInt status = 0;
    PetscReal mantissa = 0;
    SOFT_PETSC(MatMumpsGetInfog(factor, 1, &status));
    require_mumps_memory(status);
    if (status < 0) return std::nullopt;
    SOFT_PETSC(MatMumpsGetRinfog(factor, 12, &mantissa));
    return mantissa < 0.0;
}

LinearSolve LinearSolver::solve(Vec b, Vec x, const SolveSettings& how) {
    LinearSolve result = solve_once(b, x, how);
    if (settings_.method != LinearMethod::automatic || how.factor == Factor::stale) return result;
    const auto is_poor = [&] {
        return choice_ == Choice::multifrontal
                   ? result.iterations > max_iterations_without_pivoting || !result.converged
                   : result.iterations > max_iterations_of_ldlt;
    };
    while (is_poor() && use_next_factorization()) {
        if (!factorize().succeeded) return {};
        result = solve_once(b, x, how);
    }
    return result;
}

bool LinearSolver::use_next_factorization() {
    const PC pc = preconditioner();
    const bool is_user_selected = !own_ && !is_type(pc, PCCHOLESKY);  // by -pc_type
    if (choice_ == Choice::lu || is_user_selected) return false;
    use_factorization(choice_ == Choice::multifrontal ? Choice::ldlt : Choice::lu);
    SOFT_PETSC(PCSetFromOptions(pc));
    return true;
}

LinearSolve LinearSolver::solve_transposed(Vec b, Vec x) {
    if (operator_ != nullptr || choice_ == Choice::lu) return {};
    Matrix transposed;
    SOFT_PETSC(MatCreateTranspose(K_, transposed.out()));
    SOFT_PETSC(KSPSetOperators(ksp_, transposed, K_));
    if (has_own_factors()) own_->set_transposed(true);
    const LinearSolve result = solve_once(b, x);
    if (has_own_factors()) own_->set_transposed(false);
    set_operators();
    return result;
}

LinearSolve LinearSolver::solve_once(Vec b, Vec x, const SolveSettings& how) {
    PetscReal usual = 0;
    PetscInt limit = 0;
    SOFT_PETSC(KSPGetTolerances(ksp_, &usual, nullptr, nullptr, &limit));
    SOFT_PETSC(KSPSetTolerances(ksp_, std::max<PetscReal>(how.tolerance, usual), PETSC_DEFAULT, PETSC_DEFAULT,
                                how.max_iterations > 0 ? std::min<PetscInt>(how.max_iterations, limit) : limit));
    PetscBool factor_only = PETSC_FALSE;  // -ksp_type preonly, which allows no start
    SOFT_PETSC(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(ksp_.get()), KSPPREONLY, &factor_only));
    const bool starts_from_x = how.starts_from_x && factor_only == PETSC_FALSE;
    SOFT_PETSC(KSPSetInitialGuessNonzero(ksp_, starts_from_x ? PETSC_TRUE : PETSC_FALSE));
    const PetscErrorCode code = KSPSolve(ksp_, b, x);
    SOFT_PETSC(KSPSetTolerances(ksp_, usual, PETSC_DEFAULT, PETSC_DEFAULT, limit));
    if (is_numerical_failure(code, "KSPSolve")) return {};
    KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
    PetscInt iterations = 0;
    SOFT_PETSC(KSPGetConvergedReason(ksp_, &reason));
    SOFT_PETSC(KSPGetIterationNumber(ksp_, &iterations));
    iterations_ += iterations;
    const bool finite = std::isfinite(norm(x));
    return {reason > 0 && finite, static_cast<int>(iterations), reason == KSP_DIVERGED_ITS && finite && is_krylov()};
}

}  // namespace soft::linalg
