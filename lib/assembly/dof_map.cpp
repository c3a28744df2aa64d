#include "assembly/dof_map.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "assembly/partition.hpp"
#include "core/error.hpp"

namespace soft::assembly {

namespace {

std::vector<char> held_components(const model::Case& input) {
    const auto& mesh = input.mesh;
    std::vector<char> held(mesh.points.size() * mesh.dimension, 0);
    for (const auto& support : input.supports) {
        const auto set = mesh.facet_sets.find(support.face);
        if (set == mesh.facet_sets.end())
            throw Error(ExitCode::bad_input, "supports", "no face is called '" + support.face + "'");
        for (const auto& facet : set->second)
            for (const auto node : mesh::facet_nodes(mesh, facet))
                for (int i = 0; i < mesh.dimension; ++i)
                    if (support.fixed[i]) held[node * mesh.dimension + i] = 1;
    }
    return held;
}

/// Lowest rank that uses a node, and lowest that uses it as a vertex of a Taylor-Hood cell.
struct Owners {
    std::vector<int> node, vertex;
};

Owners find_owners(const mesh::Mesh& mesh, std::span<const element::ReferenceCell> references,
                   const std::vector<int>& cell_rank) {
    Owners owners;
    owners.node.assign(mesh.points.size(), std::numeric_limits<int>::max());
    owners.vertex = owners.node;
    for (mesh::Index cell = 0; cell < mesh.cell_count(); ++cell) {
        const auto& reference = reference_of(references, mesh.cell_type(cell));
        const auto nodes = mesh.cell_nodes(cell);
        for (const auto node : nodes) owners.node[node] = std::min(owners.node[node], cell_rank[cell]);
        if (reference.pressure == element::PressureSpace::continuous_vertex)
            for (int v = 0; v < reference.pressure_dofs; ++v)
                owners.vertex[nodes[v]] = std::min(owners.vertex[nodes[v]], cell_rank[cell]);
    }
    return owners;
}

/// Gives unknowns to one cell's nodes and pressures, in the cell's order: neighbours in space become neighbours in number.
void number_cell(const model::Case& input, mesh::Index cell, const element::ReferenceCell& reference,
                 const std::vector<char>& held, const Owners& owners, int rank, PetscInt& next, DofMap& map) {
    constexpr PetscInt unnumbered = -2;
    const auto nodes = input.mesh.cell_nodes(cell);
    for (const auto node : nodes) {
        if (owners.node[node] != rank) continue;
        for (int i = 0; i < map.dimension; ++i) {
            auto& number = map.displacement[node * map.dimension + i];
            if (number == unnumbered) number = held[node * map.dimension + i] ? -1 : next++;
        }
    }
    if (reference.pressure == element::PressureSpace::discontinuous_linear) {
        map.cell_pressure[cell] = next;
        next += reference.pressure_dofs;
        map.pressures += reference.pressure_dofs;
    }
    if (reference.pressure == element::PressureSpace::continuous_vertex)
        for (int v = 0; v < reference.pressure_dofs; ++v) {
            auto& number = map.vertex_pressure[nodes[v]];
            if (owners.vertex[nodes[v]] != rank || number >= 0) continue;
            number = next++;
            ++map.pressures;
        }
}

}  // namespace

const element::ReferenceCell& reference_of(std::span<const element::ReferenceCell> references, mesh::CellType type) {
    for (const auto& reference : references)
        if (reference.type == type) return reference;
    throw std::logic_error("reference_of: cell type without element");
}

DofMap make_dof_map(const model::Case& input, std::span<const element::ReferenceCell> references,
                    double pressure_scale_Pa, MPI_Comm comm) {
    const auto& mesh = input.mesh;
    int size = 1, my_rank = 0;
    MPI_Comm_size(comm, &size);
    MPI_Comm_rank(comm, &my_rank);
    DofMap map;
    map.dimension = mesh.dimension;
    map.pressure_scale_Pa = pressure_scale_Pa;
    map.displacement.assign(mesh.points.size() * mesh.dimension, -2);
    map.vertex_pressure.assign(mesh.points.size(), -1);
    map.cell_pressure.assign(mesh.cell_types.size(), -1);
    map.cell_rank = partition_cells(mesh, comm);
    const auto held = held_components(input);

    const Owners owners = find_owners(mesh, references, map.cell_rank);
    PetscInt next = 0;
    for (int rank = 0; rank < size; ++rank) {
        const PetscInt first = next;
        for (mesh::Index cell = 0; cell < mesh.cell_count(); ++cell)
            if (map.cell_rank[cell] == rank)
                number_cell(input, cell, reference_of(references, mesh.cell_type(cell)), held, owners, rank, next, map);
        if (rank == my_rank) {
            map.begin = first;
            map.end = next;
        }
    }
    map.total = next;
    std::ranges::replace(map.displacement, PetscInt{-2}, PetscInt{-1});   // points no cell uses
    return map;
}

void DofMap::cell_dofs(const mesh::Mesh& mesh, mesh::Index cell, const element::ReferenceCell& reference,
                       std::vector<PetscInt>& out) const {
    const auto nodes = mesh.cell_nodes(cell);
    node_dofs(nodes, out);
    if (reference.pressure == element::PressureSpace::discontinuous_linear)
        for (int s = 0; s < reference.pressure_dofs; ++s) out.push_back(cell_pressure[cell] + s);
    if (reference.pressure == element::PressureSpace::continuous_vertex)
        for (int v = 0; v < reference.pressure_dofs; ++v) out.push_back(vertex_pressure[nodes[v]]);
}

void DofMap::node_dofs(std::span<const mesh::Index> nodes, std::vector<PetscInt>& out) const {
    out.clear();
    for (int i = 0; i < dimension; ++i)
        for (const auto node : nodes) out.push_back(displacement[node * dimension + i]);
}

}  // namespace soft::assembly
