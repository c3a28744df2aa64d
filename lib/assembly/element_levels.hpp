#pragma once
/// The levels of the multigrid of second-order elements (linalg/multigrid.hpp): which unknowns are displacements, how they follow
/// from those of the vertices, and the mass of the pressures. Tested by assembly/element_levels_test.
#include "assembly/system.hpp"
#include "linalg/linear_solver.hpp"

namespace soft::assembly {

/// Interpolation by the first-order functions of each cell: u at a node of second order = sum over the vertices of the cell of
/// N_v(node) u_v, held and moved components left out. Mass over the initial shear modulus of the cell's region.
/// Throws Error (bad_input, "solver.preconditioner") where the mesh is of first order or no vertex is free.
[[nodiscard]] linalg::ElementLevels make_element_levels(const System& system);

/// Solids of second-order cells with more unknowns than this are solved by multigrid where nothing else is chosen. Measured for one
/// tangent and one right-hand side to 1e-8 (CPU s and GiB, LDL^T : multigrid): bulky, a box of 119k 29 : 11 s, 1.8 : 0.8; slender,
/// the bellows of 446k 51 : 101 s, 4.6 : 3.1. Up to here LDL^T, which knows the stability too, is fast enough or the faster;
/// beyond it a bulky body's factor passes 12 GiB (N^(4/3)).
inline constexpr PetscInt max_factorised = 500000;

/// The settings that so many unknowns of a case are solved with: automatic becomes multigrid, to a tolerance with which Newton's
/// method gains six digits an iteration; what is chosen stays.
[[nodiscard]] model::LinearSettings choose_linear(model::LinearSettings wanted, const model::Case& input,
                                                  PetscInt unknowns);

/// Gives a solver what its preconditioner wants to know of the elements: multigrid the levels, gamg the rigid motions (K gets
/// them). Errors as above.
void equip(linalg::LinearSolver& solver, const System& system, Mat K);

}  // namespace soft::assembly
