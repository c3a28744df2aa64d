#pragma once
/// A case on finite elements: the element tables, the laws, the numbering of the unknowns and the cells that this rank integrates. All
/// parts of a System read it; it does not change. Tested by fem/system_test.
#include <span>
#include <vector>

#include "fem/dof_map.hpp"
#include "linalg/petsc.hpp"
#include "model/rubber.hpp"

namespace soft::fem {

using material::AnyRubber;

/// Cells of one type and one material.
struct CellGroup {
    const ReferenceCell* reference;
    const AnyRubber* rubber;
    std::vector<mesh::Index> cells;
    std::vector<PetscInt> dofs;  ///< [cell][unknown], negative for fixed and prescribed components

    [[nodiscard]] std::span<const PetscInt> dofs_of(std::size_t cell) const {
        const auto size = static_cast<std::size_t>(reference->dofs());
        return {&dofs[cell * size], size};
    }
};

/// Entries of a vector of unknowns that every rank knows; those of prescribed components keep their negative index.
struct SparseVector {
    std::vector<PetscInt> dofs;
    std::vector<double> values;
};

struct Discretization {
    /// Throws Error (bad_input) for a case without cells or free nodes, a region without material, and a material that the formulation,
    /// the kinematics or the symmetry planes do not support (location materials/<region>). The case must outlive this object.
    /// `cell_rank`: of a case with the same cells, for the same numbering of the unknowns; a new partition may differ.
    Discretization(const model::Case& input, MPI_Comm comm, std::span<const int> cell_rank = {});
    Discretization(const Discretization&) = delete;
    Discretization& operator=(const Discretization&) = delete;

    const model::Case& input;
    MPI_Comm comm;
    int rank = 0;
    std::vector<ReferenceCell> references;  ///< of the cell types present
    std::vector<AnyRubber> rubbers;         ///< by region
    DofMap dofs;
    std::vector<CellGroup> groups;  ///< this rank's cells

    [[nodiscard]] linalg::Vector make_vector() const;  ///< of unknowns, zero
    [[nodiscard]] linalg::Vector make_vector(const SparseVector& entries) const;
    /// Change of a prescribed component per level of its motion; 0 for any other index.
    [[nodiscard]] double moved_by(PetscInt dof) const;
};

/// The law of a material. Throws Error (bad_input, location materials/<region>/<constant>) for an unknown law, a missing constant, one
/// outside its range, or a law that the formulation does not support.
[[nodiscard]] AnyRubber make_rubber(const model::Material& material, model::Formulation formulation);

/// By region. Throws Error (bad_input, location materials/<region>) for a material without density.
[[nodiscard]] std::vector<double> densities_kg_m3(const model::Case& input);

}  // namespace soft::fem
