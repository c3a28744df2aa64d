#pragma once
/// Two-level preconditioner for tangents of second-order elements, with or without pressure unknowns:
///   K = [A B^T; B -C],   A_g = A + B^T (C + M_g)^-1 B,   M_g = M / (gamma mu)
/// M is the mass matrix of the pressures. A discontinuous pressure is eliminated cell by cell from K with M_g added to C. The result
/// is the tangent of a solid with bulk modulus gamma mu: it is cheap because A_g has the pattern of A, and it does not lock as with a
/// large bulk modulus. A_g^-1 is approximated by a V-cycle: Gauss-Seidel on all second-order nodes, a direct solve on the vertices
/// with first-order shape functions. A continuous pressure (at vertices) is eliminated afterwards, with Schur complement
/// C + diag M / mu. No near-nullspace is needed: the vertex space contains the rigid body modes.
/// Sources: regularised saddle point, Benzi, Golub and Liesen, Acta Numerica 14 (2005) 10 and 12; intermediate bulk modulus for
/// mesh independence, Fortin and Glowinski, Augmented Lagrangian Methods (1983); first order as the coarse level of second order,
/// Shaidurov, Multigrid Methods for Finite Elements (1995). Tested by linalg/multigrid_test, solver/linear_methods_test.
#include <memory>
#include <vector>

#include "linalg/petsc.hpp"

namespace soft::linalg {

/// Pressures that are eliminated together, in the order of the unknowns.
struct PressureBlock {
    enum class Kind { of_cell, of_vertex };
    Kind kind = Kind::of_cell;
    int size = 1;              ///< number of consecutive unknowns; 1 for a vertex
    std::vector<double> mass;  ///< [size x size], divided by the shear modulus, in the scale of the pressure unknowns
};

/// Structure of the unknowns that the preconditioner needs in addition to the matrix.
struct ElementLevels {
    IndexSet displacements, pressures;  ///< of this rank, ascending; together all its unknowns
    Matrix interpolation;  ///< displacements (numbered as in the index set, rank by rank) x vertex displacements
    std::vector<PressureBlock> blocks;  ///< of this rank; they cover `pressures`
};

/// The preconditioner. Its parts can be tuned by PETSc options with the prefix multigrid_ (multigrid_mg_levels_, multigrid_mg_coarse_).
class Multigrid {
public:
    explicit Multigrid(ElementLevels levels);
    ~Multigrid();
    Multigrid(const Multigrid&) = delete;
    Multigrid& operator=(const Multigrid&) = delete;

    /// Turns `pc` into a PCSHELL that calls this object, which must outlive it. To be called again when K has another pattern.
    void attach(PC pc);

private:
    class Parts;
    static PetscErrorCode set_up(PC pc);
    static PetscErrorCode apply(PC pc, Vec from, Vec to);
    ElementLevels levels_;
    std::unique_ptr<Parts> parts_;
};

}  // namespace soft::linalg
