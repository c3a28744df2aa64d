#include "linalg/linear_solver.hpp"

#include <cmath>
#include <string_view>

namespace soft::linalg {

namespace {

/// Relative residual of a linear solve. Newton's own tolerance is 1e-9 of the forces; a correction solved to 1e-8
/// of the present residual keeps its quadratic convergence.
constexpr double linear_tolerance = 1e-8;
/// A good factor needs 1 to 5 iterations, a stale one more; beyond this a new factorisation is cheaper.
constexpr int linear_iteration_limit = 40;

/// An LDL^T factor that needs more than this misses too much of K: LU costs twice the factorisation, once a matrix.
constexpr int many_iterations_for_ldlt = 6;

bool is_type(PC pc, PCType type) {
    PetscBool same = PETSC_FALSE;
    SOFT_PETSC(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(pc), type, &same));
    return same == PETSC_TRUE;
}

bool is_mumps(PC pc) {
    if (!is_type(pc, PCCHOLESKY) && !is_type(pc, PCLU)) return false;
    MatSolverType type = nullptr;
    SOFT_PETSC(PCFactorGetMatSolverType(pc, &type));
    return type != nullptr && std::string_view(type) == MATSOLVERMUMPS;
}

}  // namespace

LinearSolver::LinearSolver(Mat K, Symmetry symmetry) : K_(K) {
    SOFT_PETSC(KSPCreate(PetscObjectComm(reinterpret_cast<PetscObject>(K)), ksp_.out()));
    SOFT_PETSC(KSPSetType(ksp_, KSPFGMRES));
    SOFT_PETSC(KSPGMRESSetRestart(ksp_, linear_iteration_limit));
    SOFT_PETSC(KSPSetTolerances(ksp_, linear_tolerance, PETSC_DEFAULT, PETSC_DEFAULT, linear_iteration_limit));
    PC pc = nullptr;
    SOFT_PETSC(KSPGetPC(ksp_, &pc));
    SOFT_PETSC(PCSetType(pc, symmetry == Symmetry::symmetric ? PCCHOLESKY : PCLU));
    SOFT_PETSC(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
    // ICNTL(14): work space beyond the estimate [%], small by default and pivoting of the saddle point needs more.
    // ICNTL(13) = 1: the root front is factorised on one rank, without which the count of negative pivots is partial.
    // ICNTL(33) = 1: the determinant, whose sign is all that LU tells of the inertia.
    // ICNTL(12) = 1, ICNTL(6) = 0: the order of elimination follows from the pattern of K alone, not from the values of the
    // first K that comes along, so that a path that is resumed in its middle is that of one run to the last digit.
    for (const auto& [option, value] : {std::pair{"-mat_mumps_icntl_14", "80"}, std::pair{"-mat_mumps_icntl_13", "1"},
                                        std::pair{"-mat_mumps_icntl_33", "1"}, std::pair{"-mat_mumps_icntl_12", "1"},
                                        std::pair{"-mat_mumps_icntl_6", "0"}}) {
        PetscBool given = PETSC_FALSE;
        SOFT_PETSC(PetscOptionsHasName(nullptr, nullptr, option, &given));
        if (!given) SOFT_PETSC(PetscOptionsSetValue(nullptr, option, value));
    }
    SOFT_PETSC(KSPSetFromOptions(ksp_));
    SOFT_PETSC(KSPSetOperators(ksp_, K_, K_));
}

Factorization LinearSolver::factorize() {
    ++factorizations_;
    SOFT_PETSC(KSPSetOperators(ksp_, K_, K_));
    SOFT_PETSC(KSPSetReusePreconditioner(ksp_, PETSC_FALSE));
    SOFT_PETSC(KSPSetUp(ksp_));
    SOFT_PETSC(KSPSetReusePreconditioner(ksp_, PETSC_TRUE));
    PC pc = nullptr;
    SOFT_PETSC(KSPGetPC(ksp_, &pc));
    PCFailedReason failed = PC_NOERROR;
    SOFT_PETSC(PCGetFailedReason(pc, &failed));
    Factorization result{failed == PC_NOERROR, std::nullopt, std::nullopt};
    if (!is_mumps(pc)) return result;
    Mat factor = nullptr;
    SOFT_PETSC(PCFactorGetMatrix(pc, &factor));
    PetscInt status = 0;
    SOFT_PETSC(MatMumpsGetInfog(factor, 1, &status));   // a failed MUMPS factorisation returns no PETSc error
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
    SOFT_PETSC(MatMumpsSetIcntl(factor, 33, 1));   // the determinant is wanted
    SOFT_PETSC(MatMumpsSetIcntl(factor, 14, 80));  // as in the constructor
    SOFT_PETSC(MatGetOrdering(K_, MATORDERINGEXTERNAL, rows.out(), columns.out()));
    SOFT_PETSC(MatLUFactorSymbolic(factor, K_, rows, columns, &info));
    SOFT_PETSC(MatLUFactorNumeric(factor, K_, &info));
    PetscInt status = 0;
    PetscReal mantissa = 0;
    SOFT_PETSC(MatMumpsGetInfog(factor, 1, &status));
    if (status < 0) return std::nullopt;
    SOFT_PETSC(MatMumpsGetRinfog(factor, 12, &mantissa));
    return mantissa < 0.0;
}

LinearSolve LinearSolver::solve(Vec b, Vec x, Factor factor) {
    const LinearSolve first = solve_once(b, x);
    PC pc = nullptr;
    SOFT_PETSC(KSPGetPC(ksp_, &pc));
    if (factor == Factor::stale || first.iterations <= many_iterations_for_ldlt || !is_type(pc, PCCHOLESKY)) return first;
    SOFT_PETSC(PCSetType(pc, PCLU));
    SOFT_PETSC(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
    SOFT_PETSC(PCSetFromOptions(pc));
    if (!factorize().succeeded) return {};
    return solve_once(b, x);
}

LinearSolve LinearSolver::solve_once(Vec b, Vec x) {
    SOFT_PETSC(KSPSolve(ksp_, b, x));
    KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
    PetscInt iterations = 0;
    SOFT_PETSC(KSPGetConvergedReason(ksp_, &reason));
    SOFT_PETSC(KSPGetIterationNumber(ksp_, &iterations));
    return {reason > 0 && std::isfinite(norm(x)), static_cast<int>(iterations)};
}

}  // namespace soft::linalg
