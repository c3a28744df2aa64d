#pragma once
/// The levels of the multigrid for second-order elements (linalg/multigrid.hpp): the displacement unknowns, their interpolation
/// from those of the vertices, and the pressure mass matrix. Tested by fem/element_levels_test.
#include "fem/system.hpp"
#include "linalg/linear_solver.hpp"

namespace soft::fem {

/// Interpolation by the first-order functions of each cell: u at a second-order node = sum over the vertices of the cell of
/// N_v(node) u_v, without fixed and prescribed components. The mass is divided by the initial shear modulus of the cell's region.
/// Throws Error (bad_input, "solver.preconditioner") for a first-order mesh or if no vertex is free.
[[nodiscard]] linalg::ElementLevels make_element_levels(const System& system);

/// With LinearMethod::automatic, solids of second-order cells with more unknowns than this are solved by multigrid. Measured for one
/// tangent and one right-hand side to 1e-8 (CPU s and GiB, LDL^T : multigrid): compact, a box of 119k 29 : 11 s, 1.8 : 0.8; slender,
/// the bellows of 446k 51 : 101 s, 4.6 : 3.1. Up to this limit LDL^T, which also provides the inertia, is fast enough or faster;
/// beyond it the factor of a compact body exceeds 12 GiB (N^(4/3)).
inline constexpr PetscInt max_factorised = 500000;

/// The linear solver settings for a case with this number of unknowns: automatic becomes multigrid for large solids, with a tolerance
/// at which Newton's method gains six digits per iteration; explicit choices are kept.
[[nodiscard]] model::LinearSettings choose_linear(model::LinearSettings wanted, const model::Case& input,
                                                  PetscInt unknowns);

/// Gives a solver the data that its preconditioner needs: the levels for multigrid, the rigid motions for gamg (attached to K).
/// Errors as above.
void configure_preconditioner(linalg::LinearSolver& solver, const System& system, Mat K);

}  // namespace soft::fem
