#pragma once
/// Lowest eigenvalues of K x = lambda M x by SLEPc's Krylov-Schur method with shift-and-invert at 0 (Stewart, SIAM J. Matrix Anal. Appl.
/// 23 (2001) 601; Ericsson and Ruhe, Math. Comp. 35 (1980) 1251) and LDL^T by MUMPS. A Krylov method may miss a copy of a multiple
/// eigenvalue, and the pairs nearest to 0 may not include a far negative one: the result is checked by Sylvester's law of inertia, which
/// gives the number of eigenvalues below a shift, and the search is repeated with more pairs where it does not agree.
/// Tested by linalg/eigenvalues_test, solver/natural_frequencies_test.
#include <complex>

#include "linalg/petsc.hpp"

namespace soft::linalg {

/// The `count` lowest finite eigenvalues in ascending order. K: symmetric, may be indefinite. M: symmetric, positive semidefinite, with the
/// pattern of K; zero in the rows of `constraints` unknowns (pressures), each of which contributes one negative pivot to K. `count` is at
/// most the number of the other unknowns. Empty if the method does not converge. Collective, the same result on every rank.
[[nodiscard]] std::vector<double> lowest_eigenvalues(Mat K, Mat M, PetscInt count, PetscInt constraints);

/// Of an unsymmetric K, with LU by MUMPS: at least `count` of the finite eigenvalues nearest to 0, or all that there are, in no order; complex ones
/// with their conjugates. One of several equal ones may be missing. Empty if the method does not converge.
[[nodiscard]] std::vector<std::complex<double>> nearest_eigenvalues(Mat K, Mat M, PetscInt count, PetscInt constraints);

}  // namespace soft::linalg
