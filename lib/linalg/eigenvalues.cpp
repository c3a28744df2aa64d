#include "linalg/eigenvalues.hpp"

#include <slepceps.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "linalg/linear_solver.hpp"

namespace soft::linalg {

namespace {

using EigenSolver = Owned<EPS, EPSDestroy>;

/// Relative residual of an eigenpair; the error of an eigenvalue is of second order in it.
constexpr double eigenvalue_tolerance = 1e-10;
/// Relative residual of the linear solves.
constexpr double inverse_tolerance = 1e-10;
/// Distance of the shift of the inertia below the last eigenvalue, relative to the largest one: far above the rounding of an eigenvalue.
constexpr double shift_gap = 1e-4;
/// An eigenvalue this many times larger than the smallest one is infinite but for rounding.
constexpr double infinite = 1e12;
/// Number of pairs beyond which no further search is made.
constexpr PetscInt max_pairs = 400;

/// SLEPc's classes are destroyed by PetscFinalize.
void start_slepc() {
    PetscBool started = PETSC_FALSE;
    SOFT_PETSC(SlepcInitialized(&started));
    if (started == PETSC_FALSE) SOFT_PETSC(SlepcInitializeNoArguments());
}

/// Krylov-Schur with shift-and-invert at 0 by the solver.
EigenSolver make_eigen_solver(Mat K, Mat M, EPSProblemType problem, const LinearSolver& solver) {
    start_slepc();
    EigenSolver eps;
    SOFT_PETSC(EPSCreate(PetscObjectComm(reinterpret_cast<PetscObject>(K)), eps.out()));
    SOFT_PETSC(EPSSetOperators(eps, K, M));
    SOFT_PETSC(EPSSetProblemType(eps, problem));
    SOFT_PETSC(EPSSetType(eps, EPSKRYLOVSCHUR));
    SOFT_PETSC(EPSSetWhichEigenpairs(eps, EPS_TARGET_MAGNITUDE));
    SOFT_PETSC(EPSSetTarget(eps, 0.0));
    SOFT_PETSC(EPSSetTolerances(eps, eigenvalue_tolerance, PETSC_DEFAULT));
    ST inverse = nullptr;
    SOFT_PETSC(EPSGetST(eps, &inverse));
    SOFT_PETSC(STSetType(inverse, STSINVERT));
    SOFT_PETSC(STSetKSP(inverse, solver.ksp()));
    SOFT_PETSC(EPSSetFromOptions(eps));
    return eps;
}

PetscInt number_of_eigenvalues(Mat K, PetscInt constraints) {
    PetscInt size = 0;
    SOFT_PETSC(MatGetSize(K, &size, nullptr));
    return std::min(size - constraints, max_pairs);
}

/// All converged eigenvalues; empty where the method or its linear solver fails.
std::vector<std::complex<double>> solve(EPS eps, PetscInt wanted) {
    SOFT_PETSC(EPSSetDimensions(eps, wanted, PETSC_DEFAULT, PETSC_DEFAULT));
    const PetscErrorCode code = EPSSolve(eps);
    if (code == PETSC_ERR_NOT_CONVERGED) return {};
    check(code, "EPSSolve(eps)");
    PetscInt converged = 0;
    SOFT_PETSC(EPSGetConverged(eps, &converged));
    std::vector<std::complex<double>> eigenvalues;
    double smallest = std::numeric_limits<double>::infinity();
    for (PetscInt i = 0; i < converged; ++i) {
        double real = 0, imaginary = 0;
        SOFT_PETSC(EPSGetEigenvalue(eps, i, &real, &imaginary));
        eigenvalues.emplace_back(real, imaginary);
        smallest = std::min(smallest, std::abs(eigenvalues.back()));
    }
    std::erase_if(eigenvalues, [&](const auto& value) { return !(std::abs(value) <= infinite * smallest); });
    return eigenvalues;
}

/// Number of eigenvalues below `shift`; nullopt where the factorisation fails.
std::optional<PetscInt> count_below(Mat K, Mat M, double shift, PetscInt constraints) {
    Matrix shifted;
    SOFT_PETSC(MatDuplicate(K, MAT_COPY_VALUES, shifted.out()));
    add(shifted, -shift, M);
    LinearSolver solver(shifted, Symmetry::symmetric, {.method = LinearMethod::mumps_ldlt});
    const auto pivots = solver.factorize().negative_pivots;
    return pivots ? std::optional(*pivots - constraints) : std::nullopt;
}

}  // namespace

std::vector<double> lowest_eigenvalues(Mat K, Mat M, PetscInt count, PetscInt constraints) {
    LinearSolver solver(K, Symmetry::symmetric, {.method = LinearMethod::mumps_ldlt, .tolerance = inverse_tolerance});
    const EigenSolver eps = make_eigen_solver(K, M, EPS_GHEP, solver);
    const PetscInt last = number_of_eigenvalues(K, constraints);
    for (PetscInt wanted = count;; wanted = std::min(2 * wanted, last)) {
        std::vector<double> found;
        for (const auto& value : solve(eps, wanted)) found.push_back(value.real());
        std::ranges::sort(found);
        if (static_cast<PetscInt>(found.size()) < count) return {};
        const double largest = std::max(std::abs(found.front()), std::abs(found.back()));
        const double shift = found[static_cast<std::size_t>(count) - 1] - shift_gap * largest;
        const auto below = std::ranges::lower_bound(found, shift) - found.begin();
        if (count_below(K, M, shift, constraints).value_or(below) == below) {
            found.resize(static_cast<std::size_t>(count));
            return found;
        }
        if (wanted >= last) return {};
    }
}

std::vector<std::complex<double>> nearest_eigenvalues(Mat K, Mat M, PetscInt count, PetscInt constraints) {
    LinearSolver solver(K, Symmetry::general, {.method = LinearMethod::mumps_lu, .tolerance = inverse_tolerance});
    const EigenSolver eps = make_eigen_solver(K, M, EPS_GNHEP, solver);
    return solve(eps, std::min(count, number_of_eigenvalues(K, constraints)));
}

}  // namespace soft::linalg
