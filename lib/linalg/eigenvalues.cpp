#include "linalg/eigenvalues.hpp"

#include <slepceps.h>

#include <algorithm>
#include <cmath>
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

/// All converged eigenvalues in ascending order; empty where the method or its linear solver fails.
std::vector<double> solve(EPS eps, PetscInt wanted) {
    SOFT_PETSC(EPSSetDimensions(eps, wanted, PETSC_DEFAULT, PETSC_DEFAULT));
    const PetscErrorCode code = EPSSolve(eps);
    if (code == PETSC_ERR_NOT_CONVERGED) return {};
    check(code, "EPSSolve(eps)");
    PetscInt converged = 0;
    SOFT_PETSC(EPSGetConverged(eps, &converged));
    std::vector<double> eigenvalues;
    for (PetscInt i = 0; i < converged; ++i) {
        double value = 0;
        SOFT_PETSC(EPSGetEigenvalue(eps, i, &value, nullptr));
        eigenvalues.push_back(value);
    }
    const auto size = [](double value) { return std::abs(value); };
    const double smallest = eigenvalues.empty() ? 0.0 : size(*std::ranges::min_element(eigenvalues, {}, size));
    std::erase_if(eigenvalues, [&](double value) { return !(size(value) <= infinite * smallest); });
    std::ranges::sort(eigenvalues);
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
    start_slepc();
    LinearSolver solver(K, Symmetry::symmetric, {.method = LinearMethod::mumps_ldlt, .tolerance = inverse_tolerance});
    EigenSolver eps;
    SOFT_PETSC(EPSCreate(PetscObjectComm(reinterpret_cast<PetscObject>(K)), eps.out()));
    SOFT_PETSC(EPSSetOperators(eps, K, M));
    SOFT_PETSC(EPSSetProblemType(eps, EPS_GHEP));
    SOFT_PETSC(EPSSetType(eps, EPSKRYLOVSCHUR));
    SOFT_PETSC(EPSSetWhichEigenpairs(eps, EPS_TARGET_MAGNITUDE));
    SOFT_PETSC(EPSSetTarget(eps, 0.0));
    SOFT_PETSC(EPSSetTolerances(eps, eigenvalue_tolerance, PETSC_DEFAULT));
    ST inverse = nullptr;
    SOFT_PETSC(EPSGetST(eps, &inverse));
    SOFT_PETSC(STSetType(inverse, STSINVERT));
    SOFT_PETSC(STSetKSP(inverse, solver.ksp()));
    SOFT_PETSC(EPSSetFromOptions(eps));
    PetscInt size = 0;
    SOFT_PETSC(MatGetSize(K, &size, nullptr));
    const PetscInt last = std::min(size - constraints, max_pairs);
    for (PetscInt wanted = count;; wanted = std::min(2 * wanted, last)) {
        std::vector<double> found = solve(eps, wanted);
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

}  // namespace soft::linalg
