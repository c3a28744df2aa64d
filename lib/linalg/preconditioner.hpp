#pragma once
/// Sets the PETSc preconditioner that LinearSettings names. Internal to the module.
///   factorisations: MUMPS LDL^T or LU, SuperLU_DIST LU, CHOLMOD LL^T, as the preconditioner of flexible GMRES
///   asm_*: PCASM, the restricted additive Schwarz method, one block per rank with one layer of overlap (Cai and Sarkis 1999)
///   boomeramg: hypre (Henson and Yang 2002)       gamg: PETSc's smoothed aggregation (Vanek, Mandel and Brezina 1996)
///   multigrid: linalg/multigrid.hpp, which LinearSolver::set_levels attaches
/// Tested by linalg/linear_solver_test and solver/linear_methods_test.
#include <initializer_list>

#include "linalg/linear_solver.hpp"

namespace soft::linalg {

struct Default {
    const char* option;
    const char* value;
};

/// Sets PETSc options unless the user has set them after --.
void set_defaults(std::initializer_list<Default> defaults);

/// Sets the type and its defaults, which PETSc options may override. Throws Error (bad_input, "solver.linear" or
/// "solver.preconditioner") for a library that PETSc was built without, and for CHOLMOD on more than one rank.
void set_type(PC pc, const LinearSettings& settings, Symmetry symmetry);

/// Sets the block solvers of an additive Schwarz method. Call after the first set-up of `pc`, which creates the blocks, and before
/// the blocks are set up. Does nothing for other types.
void set_block_type(PC pc, Preconditioner preconditioner);

[[nodiscard]] bool is_type(PC pc, PCType type);
[[nodiscard]] bool is_mumps(PC pc);

}  // namespace soft::linalg
