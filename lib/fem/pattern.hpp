#pragma once
/// The sparsity pattern of a system's matrices: unknowns that share a cell, and those that contact couples. It is counted exactly before allocation: with a million
/// unknowns a hash table of the entries would take more memory than the matrix. Tested by fem/pattern_test.
#include "fem/dof_map.hpp"

namespace soft::fem {

/// A matrix with zeros at all entries of the pattern; `couplings`: further groups of unknowns that are coupled like those of a cell. Every rank computes its own rows from the whole mesh, without communication.
[[nodiscard]] linalg::Matrix make_zero_matrix(const mesh::Mesh& mesh, const DofMap& map,
                                              std::span<const fem::ReferenceCell> references,
                                              std::span<const std::vector<PetscInt>> couplings, MPI_Comm comm);

}  // namespace soft::fem
