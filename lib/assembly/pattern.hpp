#pragma once
/// The pattern of a system's matrices: unknowns that share a cell. Counted exactly before anything is stored, for at a million
/// unknowns a hash of the entries would take more memory than the matrix. Tested by assembly/pattern_test.
#include "assembly/dof_map.hpp"

namespace soft::assembly {

/// Zeros at all places of the pattern. Every rank finds its own rows from the whole mesh, without communication.
[[nodiscard]] linalg::Matrix make_zero_matrix(const mesh::Mesh& mesh, const DofMap& map,
                                              std::span<const element::ReferenceCell> references, MPI_Comm comm);

}  // namespace soft::assembly
