#include "fem/partition.hpp"

#include <petscmat.h>

#include <algorithm>
#include <map>

#include "linalg/petsc.hpp"

namespace soft::fem {

namespace {

/// Neighbours across facets (the sorted vertices of a facet identify it).
std::vector<std::vector<PetscInt>> dual_graph(const mesh::Mesh& mesh) {
    std::vector<std::vector<PetscInt>> neighbours(mesh.cell_types.size());
    std::map<std::vector<mesh::Index>, mesh::Index> open;
    for (mesh::Index cell = 0; cell < mesh.cell_count(); ++cell) {
        const auto nodes = mesh.cell_nodes(cell);
        for (const auto& facet : mesh::topology(mesh.cell_type(cell)).facets) {
            std::vector<mesh::Index> key;
            for (int v = 0; v < mesh::topology(facet.type).vertex_count; ++v) key.push_back(nodes[facet.nodes[v]]);
            std::ranges::sort(key);
            const auto [other, is_new] = open.try_emplace(std::move(key), cell);
            if (is_new) continue;
            neighbours[cell].push_back(static_cast<PetscInt>(other->second));
            neighbours[other->second].push_back(static_cast<PetscInt>(cell));
        }
    }
    for (auto& list : neighbours) std::ranges::sort(list);
    return neighbours;
}

/// Allocates memory that PETSc will free. Its macro has old-style casts.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
void allocate(PetscInt count, PetscInt** memory) { SOFT_PETSC(PetscMalloc1(count, memory)); }
#pragma GCC diagnostic pop

}  // namespace

std::vector<int> partition_cells(const mesh::Mesh& mesh, MPI_Comm comm) {
    int size = 1;
    MPI_Comm_size(comm, &size);
    return partition_cells(mesh, comm, size);
}

std::vector<int> partition_cells(const mesh::Mesh& mesh, MPI_Comm comm, int parts) {
    int size = 1, rank = 0;
    MPI_Comm_size(comm, &size);
    MPI_Comm_rank(comm, &rank);
    std::vector<int> ranks(mesh.cell_types.size(), 0);
    if (parts == 1) return ranks;

    const auto graph = dual_graph(mesh);
    const auto total = static_cast<PetscInt>(graph.size());
    const PetscInt begin = total * rank / size, end = total * (rank + 1) / size;
    PetscInt *rows = nullptr, *columns = nullptr;  // the matrix takes ownership
    allocate(end - begin + 1, &rows);
    rows[0] = 0;
    for (PetscInt c = begin; c < end; ++c)
        rows[c - begin + 1] = rows[c - begin] + static_cast<PetscInt>(graph[c].size());
    allocate(rows[end - begin], &columns);
    for (PetscInt c = begin; c < end; ++c) std::ranges::copy(graph[c], columns + rows[c - begin]);

    linalg::Matrix adjacency;
    SOFT_PETSC(MatCreateMPIAdj(comm, end - begin, total, rows, columns, nullptr, adjacency.out()));
    linalg::Owned<MatPartitioning, MatPartitioningDestroy> partitioning;
    SOFT_PETSC(MatPartitioningCreate(comm, partitioning.out()));
    SOFT_PETSC(MatPartitioningSetAdjacency(partitioning, adjacency));
    SOFT_PETSC(MatPartitioningSetType(partitioning, MATPARTITIONINGPTSCOTCH));
    SOFT_PETSC(MatPartitioningSetNParts(partitioning, parts));
    SOFT_PETSC(MatPartitioningSetFromOptions(partitioning));
    linalg::IndexSet mine, all;
    SOFT_PETSC(MatPartitioningApply(partitioning, mine.out()));
    SOFT_PETSC(ISAllGather(mine, all.out()));
    const PetscInt* values = nullptr;
    SOFT_PETSC(ISGetIndices(all, &values));
    for (std::size_t c = 0; c < ranks.size(); ++c) ranks[c] = static_cast<int>(values[c]);
    SOFT_PETSC(ISRestoreIndices(all, &values));
    return ranks;
}

}  // namespace soft::fem
