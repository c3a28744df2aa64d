#pragma once
/// Assignment of cells to ranks: the dual graph of the mesh, partitioned by PETSc.
#include <vector>

#include <mpi.h>

#include "mesh/mesh.hpp"

namespace soft::fem {

/// Rank of every cell, the same on all ranks; all zero on one rank.
[[nodiscard]] std::vector<int> partition_cells(const mesh::Mesh& mesh, MPI_Comm comm);

/// The same for any number of parts, computed by the present ranks: the partition of a run on that many ranks.
[[nodiscard]] std::vector<int> partition_cells(const mesh::Mesh& mesh, MPI_Comm comm, int parts);

}  // namespace soft::fem
