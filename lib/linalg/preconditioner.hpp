#pragma once
/// What stands behind the names of model::LinearSettings in PETSc: the preconditioner of a Krylov solver. Internal to the module.
///   factorisations: MUMPS LDL^T or LU, SuperLU_DIST LU, CHOLMOD LL^T, as the preconditioner of flexible GMRES
///   asm_*: PCASM, the restricted additive Schwarz method, one block a rank with one layer of overlap (Cai and Sarkis 1999)
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

/// PETSc options; what the user has given behind -- stays.
void set_defaults(std::initializer_list<Default> defaults);

/// Sets the type and its defaults, which PETSc's options may change afterwards. Throws Error (bad_input, "solver.linear" or
/// "solver.preconditioner") for a library that this PETSc was built without, and for CHOLMOD on more than one rank.
void set_type(PC pc, const model::LinearSettings& settings, Symmetry symmetry);

/// Gives the blocks of an additive Schwarz method their solver: after the first set-up of `pc`, which makes them, and before
/// they are set up themselves. Other types are left alone.
void set_block_type(PC pc, model::Preconditioner preconditioner);

[[nodiscard]] bool is_type(PC pc, PCType type);
[[nodiscard]] bool is_mumps(PC pc);

}  // namespace soft::linalg
