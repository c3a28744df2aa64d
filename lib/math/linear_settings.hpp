#pragma once
/// Choice of the solver for linear systems, as plain data: set by a design (model/settings.hpp), used by linalg/linear_solver.hpp.

namespace soft {

/// Solution of the linear systems in Newton's method.
///   automatic: LDL^T; LU if the tangent is not symmetric enough (linalg/linear_solver.hpp); krylov with multigrid if a solid is too
///       large to factorise (fem/element_levels.hpp)
///   mumps_ldlt, mumps_lu, superlu_dist, cholmod: that factorisation; cholmod requires a positive definite tangent and one rank
///   krylov: flexible GMRES on the assembled tangent         jacobian_free: flexible GMRES on finite differences of the residual
enum class LinearMethod { automatic, mumps_ldlt, mumps_lu, superlu_dist, cholmod, krylov, jacobian_free };

/// Preconditioner of the two Krylov methods. asm_*: additive Schwarz, one block per rank, solved by LU, ILU(0) or a BoomerAMG cycle.
/// gamg: smoothed aggregation with the rigid body modes as near-nullspace. multigrid: p-multigrid from second-order to first-order
/// cells, for mixed and displacement formulations (linalg/multigrid.hpp).
enum class Preconditioner { lu, asm_lu, asm_ilu, asm_boomeramg, boomeramg, gamg, multigrid, jacobi, none };

struct LinearSettings {
    LinearMethod method = LinearMethod::automatic;
    Preconditioner preconditioner = Preconditioner::asm_lu;
    double tolerance = 1e-8;   ///< residual of a linear solve relative to its right-hand side
    int iteration_limit = 40;  ///< a Krylov method that reaches it returns its best correction
};

}  // namespace soft
