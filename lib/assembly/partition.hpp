#pragma once
/// Which rank assembles which cell: the dual graph of the mesh cut by PETSc's partitioner.
#include <vector>

#include <mpi.h>

#include "mesh/mesh.hpp"

namespace soft::assembly {

/// Rank of every cell, the same on all ranks; all zero on one rank.
[[nodiscard]] std::vector<int> partition_cells(const mesh::Mesh& mesh, MPI_Comm comm);

/// The same cut into any number of parts by the ranks there are: what a run on that many ranks would be given.
[[nodiscard]] std::vector<int> partition_cells(const mesh::Mesh& mesh, MPI_Comm comm, int parts);

}  // namespace soft::assembly
