#pragma once
/// Numbering of the unknowns: free displacement components of all nodes and the pressures of mixed cells. Fixed
/// components have the index -1, prescribed ones (model::Motion) -2 - slot with slot = 3 x motion + component; PETSc ignores
/// both on insertion. Every rank builds the same map from the whole mesh (it is cheap), owns a contiguous range of unknowns and
/// assembles its own cells.
/// A pressure unknown is p / pressure_scale, with pressure_scale = shear modulus / cell size, so that the force rows and the
/// volume rows have entries of similar size and one norm is meaningful for both.
/// Tested by fem/system_test.
#include <algorithm>
#include <span>
#include <vector>

#include "fem/reference_cell.hpp"
#include "linalg/petsc.hpp"
#include "model/case.hpp"

namespace soft::fem {

struct DofMap {
    int dimension = 3;
    PetscInt total = 0;           ///< unknowns on all ranks
    PetscInt begin = 0, end = 0;  ///< this rank's range
    PetscInt pressures = 0;       ///< pressure unknowns on all ranks
    double pressure_scale_Pa = 1;
    std::vector<PetscInt> displacement;  ///< [node x dimension + component], negative if fixed or prescribed
    /// [vertex_index], -1 for a node without pressure. Continuous within a region: at an interface the pressure jumps.
    std::vector<PetscInt> vertex_pressure;
    std::vector<PetscInt> cell_pressure;  ///< [cell] first of its discontinuous pressures, -1 if it has none
    std::vector<int> cell_rank;           ///< [cell] the rank that assembles it

    [[nodiscard]] static std::size_t region_count(const mesh::Mesh& mesh) {
        return std::max<std::size_t>(1, mesh.region_names.size());
    }
    /// Index of a node as a vertex of a cell, by node and region.
    [[nodiscard]] static std::size_t vertex_index(const mesh::Mesh& mesh, mesh::Index cell, mesh::Index node) {
        return static_cast<std::size_t>(node) * region_count(mesh) +
               static_cast<std::size_t>(mesh.cell_regions[static_cast<std::size_t>(cell)]);
    }
    /// The unknowns of a cell, component by component, then pressures: the order of fem/solid_kernel.hpp.
    void cell_dofs(const mesh::Mesh& mesh, mesh::Index cell, const fem::ReferenceCell& reference,
                   std::vector<PetscInt>& out) const;
    /// The displacement unknowns of a list of nodes, component by component.
    void node_dofs(std::span<const mesh::Index> nodes, std::vector<PetscInt>& out) const;
};

/// Slot of a prescribed component's index, -1 for any other index.
[[nodiscard]] constexpr int motion_slot(PetscInt number) noexcept {
    return number <= -2 ? static_cast<int>(-2 - number) : -1;
}

/// Throws Error (bad_input) for a face that the mesh does not have and for a component that is both fixed and prescribed, or
/// prescribed twice.
/// `cell_rank`: the rank of each cell, empty for a new partition. `references` gives the element of each cell type present (index: mesh::CellType's value).
[[nodiscard]] DofMap make_dof_map(const model::Case& input, std::span<const fem::ReferenceCell> references,
                                  double pressure_scale_Pa, MPI_Comm comm, std::span<const int> cell_rank = {});

/// The element of a cell type. Throws std::logic_error if it is not among them.
[[nodiscard]] const fem::ReferenceCell& reference_of(std::span<const fem::ReferenceCell> references,
                                                     mesh::CellType type);

}  // namespace soft::fem
