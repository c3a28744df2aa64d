#include "fem/dof_map.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "core/error.hpp"
#include "fem/partition.hpp"

namespace soft::fem {

namespace {

constexpr PetscInt unnumbered = std::numeric_limits<PetscInt>::min(), is_free = unnumbered + 1;

/// Calls visit(node) for every node of a face.
template <class Visit>
void for_each_node(const mesh::Mesh& mesh, const std::string& face, const std::string& key, Visit&& visit) {
    const auto set = mesh.facet_sets.find(face);
    if (set == mesh.facet_sets.end()) throw Error(ExitCode::bad_input, key, "no face is called '" + face + "'");
    for (const auto& facet : set->second)
        for (const auto node : mesh::facet_nodes(mesh, facet)) visit(node);
}

/// For every component: is_free, or its negative index.
std::vector<PetscInt> fixed_components(const model::Case& input) {
    const auto& mesh = input.mesh;
    std::vector<PetscInt> fixed(mesh.points.size() * mesh.dimension, is_free);
    for (const auto& support : input.supports)
        for_each_node(mesh, support.face, "supports", [&](mesh::Index node) {
            for (int i = 0; i < mesh.dimension; ++i)
                if (support.fixed[i]) fixed[node * mesh.dimension + i] = -1;
        });
    for (std::size_t m = 0; m < input.motions.size(); ++m) {
        const auto& motion = input.motions[m];
        if (model::moves_obstacle(input, motion)) continue;
        const std::string key = "loads." + motion.face;
        for_each_node(mesh, motion.face, key, [&](mesh::Index node) {
            for (int i = 0; i < mesh.dimension; ++i) {
                const auto& value = motion.displacement_m[i];
                if (!value) continue;
                PetscInt& number = fixed[node * mesh.dimension + i];
                const int slot = number == is_free ? -1 : motion_slot(number), other = slot / 3;
                if (number == -1 && *value != 0.0)
                    throw Error(ExitCode::bad_input, key,
                                std::string("over-constrained: the supports fix some of its nodes along ") + "xyz"[i] +
                                    ", where it prescribes a displacement",
                                "remove this direction from supports, or fix another face");
                if (slot >= 0 && static_cast<std::size_t>(other) != m &&
                    input.motions[other].displacement_m[i] != value)
                    throw Error(ExitCode::bad_input, key,
                                "over-constrained: nodes that it shares with the face '" + input.motions[other].face +
                                    "' have two different prescribed displacements",
                                "prescribe the same displacement for both");
                if (number == is_free) number = -2 - static_cast<PetscInt>(3 * m + i);
            }
        });
    }
    return fixed;
}

/// The lowest rank that uses a node, and the lowest that uses it as a vertex of a Taylor-Hood cell of a region (DofMap::vertex_index).
struct Owners {
    std::vector<int> node, vertex;
};

Owners find_owners(const mesh::Mesh& mesh, std::span<const fem::ReferenceCell> references,
                   const std::vector<int>& cell_rank) {
    Owners owners;
    owners.node.assign(mesh.points.size(), std::numeric_limits<int>::max());
    owners.vertex.assign(mesh.points.size() * DofMap::region_count(mesh), std::numeric_limits<int>::max());
    for (mesh::Index cell = 0; cell < mesh.cell_count(); ++cell) {
        const auto& reference = reference_of(references, mesh.cell_type(cell));
        const auto nodes = mesh.cell_nodes(cell);
        for (const auto node : nodes) owners.node[node] = std::min(owners.node[node], cell_rank[cell]);
        if (reference.pressure == fem::PressureSpace::continuous_vertex)
            for (int v = 0; v < reference.pressure_dofs; ++v) {
                int& owner = owners.vertex[DofMap::vertex_index(mesh, cell, nodes[v])];
                owner = std::min(owner, cell_rank[cell]);
            }
    }
    return owners;
}

/// Numbers the unknowns of one cell's nodes and pressures, in the cell's order, so that neighbours in space have close indices.
void number_cell(const model::Case& input, mesh::Index cell, const fem::ReferenceCell& reference,
                 const std::vector<PetscInt>& fixed, const Owners& owners, int rank, PetscInt& next, DofMap& map) {
    const auto nodes = input.mesh.cell_nodes(cell);
    for (const auto node : nodes) {
        if (owners.node[node] != rank) continue;
        for (int i = 0; i < map.dimension; ++i) {
            auto& number = map.displacement[node * map.dimension + i];
            if (number != unnumbered) continue;
            const PetscInt constraint = fixed[node * map.dimension + i];
            number = constraint == is_free ? next++ : constraint;
        }
    }
    if (reference.pressure == fem::PressureSpace::discontinuous_linear) {
        map.cell_pressure[cell] = next;
        next += reference.pressure_dofs;
        map.pressures += reference.pressure_dofs;
    }
    if (reference.pressure == fem::PressureSpace::continuous_vertex)
        for (int v = 0; v < reference.pressure_dofs; ++v) {
            const std::size_t vertex = DofMap::vertex_index(input.mesh, cell, nodes[v]);
            auto& number = map.vertex_pressure[vertex];
            if (owners.vertex[vertex] != rank || number >= 0) continue;
            number = next++;
            ++map.pressures;
        }
}

}  // namespace

const fem::ReferenceCell& reference_of(std::span<const fem::ReferenceCell> references, mesh::CellType type) {
    for (const auto& reference : references)
        if (reference.type == type) return reference;
    throw std::logic_error("reference_of: cell type without element");
}

DofMap make_dof_map(const model::Case& input, std::span<const fem::ReferenceCell> references, double pressure_scale_Pa,
                    MPI_Comm comm, std::span<const int> cell_rank) {
    const auto& mesh = input.mesh;
    int size = 1, my_rank = 0;
    MPI_Comm_size(comm, &size);
    MPI_Comm_rank(comm, &my_rank);
    DofMap map;
    map.dimension = mesh.dimension;
    map.pressure_scale_Pa = pressure_scale_Pa;
    map.displacement.assign(mesh.points.size() * mesh.dimension, unnumbered);
    map.vertex_pressure.assign(mesh.points.size() * DofMap::region_count(mesh), -1);
    map.cell_pressure.assign(mesh.cell_types.size(), -1);
    map.cell_rank =
        cell_rank.empty() ? partition_cells(mesh, comm) : std::vector<int>(cell_rank.begin(), cell_rank.end());
    const auto fixed = fixed_components(input);

    const Owners owners = find_owners(mesh, references, map.cell_rank);
    PetscInt next = 0;
    for (int rank = 0; rank < size; ++rank) {
        const PetscInt first = next;
        for (mesh::Index cell = 0; cell < mesh.cell_count(); ++cell)
            if (map.cell_rank[cell] == rank)
                number_cell(input, cell, reference_of(references, mesh.cell_type(cell)), fixed, owners, rank, next,
                            map);
        if (rank == my_rank) {
            map.begin = first;
            map.end = next;
        }
    }
    map.total = next;
    std::ranges::replace(map.displacement, unnumbered, PetscInt{-1});  // points that no cell uses
    return map;
}

void DofMap::cell_dofs(const mesh::Mesh& mesh, mesh::Index cell, const fem::ReferenceCell& reference,
                       std::vector<PetscInt>& out) const {
    const auto nodes = mesh.cell_nodes(cell);
    node_dofs(nodes, out);
    if (reference.pressure == fem::PressureSpace::discontinuous_linear)
        for (int s = 0; s < reference.pressure_dofs; ++s) out.push_back(cell_pressure[cell] + s);
    if (reference.pressure == fem::PressureSpace::continuous_vertex)
        for (int v = 0; v < reference.pressure_dofs; ++v)
            out.push_back(vertex_pressure[vertex_index(mesh, cell, nodes[v])]);
}

void DofMap::node_dofs(std::span<const mesh::Index> nodes, std::vector<PetscInt>& out) const {
    out.clear();
    for (int i = 0; i < dimension; ++i)
        for (const auto node : nodes) out.push_back(displacement[node * dimension + i]);
}

}  // namespace soft::fem
