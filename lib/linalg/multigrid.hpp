#pragma once
/// Two-level preconditioner of the tangents of second-order elements, with pressure unknowns or without:
///   K = [A B^T; B -C],   A_g = A + B^T (C + M_g)^-1 B,   M_g = M / (gamma mu)
/// with M the mass matrix of the pressures. A discontinuous pressure is eliminated cell by cell from K with M_g added to C, which
/// makes a solid of bulk modulus gamma mu: cheap, for A_g has the pattern of A, and without the locking of a large bulk modulus.
/// A_g^-1 is a V-cycle: Gauss-Seidel on the second-order nodes, a direct solution on the vertices, whose functions are those of
/// first order. A continuous pressure (of vertices) is eliminated after it, its Schur complement C + diag M / mu.
/// No near-nullspace is needed: the vertices carry the rigid motions.
/// Sources: the regularised saddle point, Benzi, Golub and Liesen, Acta Numerica 14 (2005) 10 and 12; the bulk modulus between
/// that makes it independent of the mesh, Fortin and Glowinski, Augmented Lagrangian Methods (1983); second order by way of first,
/// Shaidurov, Multigrid Methods for Finite Elements (1995). Tested by linalg/multigrid_test, solver/linear_methods_test.
#include <memory>
#include <vector>

#include "linalg/petsc.hpp"

namespace soft::linalg {

/// Pressures that are eliminated together, in the order of the unknowns.
struct PressureBlock {
    enum class Kind { of_cell, of_vertex };
    Kind kind = Kind::of_cell;
    int size = 1;              ///< consecutive unknowns; a vertex has 1
    std::vector<double> mass;  ///< [size x size], over the shear modulus, in the scale of the pressure unknowns
};

/// What the preconditioner must know of the unknowns beside their matrix.
struct ElementLevels {
    IndexSet displacements, pressures;  ///< this rank's, ascending; together all of its unknowns
    Matrix interpolation;  ///< displacements (numbered as in the index set, rank after rank) x those of vertices
    std::vector<PressureBlock> blocks;  ///< this rank's, they cover `pressures`
};

/// The preconditioner itself; what it is made of can be tuned by PETSc's options with the prefix multigrid_ (multigrid_mg_levels_,
/// multigrid_mg_coarse_).
class Multigrid {
public:
    explicit Multigrid(ElementLevels levels);
    ~Multigrid();
    Multigrid(const Multigrid&) = delete;
    Multigrid& operator=(const Multigrid&) = delete;

    /// Makes `pc`, a PCSHELL, call this, which has to outlive it.
    void attach(PC pc);

private:
    class Parts;
    static PetscErrorCode set_up(PC pc);
    static PetscErrorCode apply(PC pc, Vec from, Vec to);
    std::unique_ptr<Parts> parts_;
};

}  // namespace soft::linalg
