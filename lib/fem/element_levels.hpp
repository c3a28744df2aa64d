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

/// With LinearMethod::automatic, solids of second-order cells with up to this number of unknowns are factorised: LDL^T also provides the
/// inertia. Measured for one tangent and one right-hand side to 1e-8 (CPU s and GiB, LDL^T by MUMPS : multigrid): compact, a box of 119k
/// 29 : 11 s, 1.8 : 0.8; slender, the bellows of 446k 51 : 101 s, 4.6 : 3.1.
inline constexpr PetscInt always_factorised = 500000;
/// A solve by multigrid takes as long as a factorisation with this many flops for each unknown: 0.9e-4 to 2.3e-4 s (above), at 20 GFlop/s.
inline constexpr double flops_of_multigrid = 3e6;
/// Entries of the factor that an int can count, 17 GB.
inline constexpr double most_entries = 2147483647;

/// Larger solids with at most this many flops are factorised as well: fewer than those of multigrid, and few enough for the entries of the
/// factor, as flops >= entries^2 / unknowns.
[[nodiscard]] double most_flops(PetscInt unknowns);

/// Flops of LDL^T by nested dissection, from the graph of the nodes, each with the same share of the unknowns.
[[nodiscard]] double predicted_flops(const mesh::Mesh& mesh, PetscInt unknowns);

/// The linear solver settings for a case with this number of unknowns: automatic becomes multigrid where that is faster, with a tolerance
/// at which Newton's method gains six digits per iteration; explicit choices are kept. Of a general tangent, whose LU takes more than twice
/// the flops, every large solid is solved by multigrid.
[[nodiscard]] model::LinearSettings choose_linear(model::LinearSettings wanted, const model::Case& input,
                                                  PetscInt unknowns, linalg::Symmetry symmetry);

/// Gives a solver the data that its preconditioner needs: the levels for multigrid, the rigid motions for gamg (attached to K).
/// Errors as above.
void configure_preconditioner(linalg::LinearSolver& solver, const System& system, Mat K);

}  // namespace soft::fem
