#include "fem/element_levels.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "fem/near_nullspace.hpp"
#include "fem/pressure_mass.hpp"
#include "linalg/multifrontal.hpp"
#include "mesh/shape.hpp"

namespace soft::fem {

namespace {

using mesh::Index;

/// For LinearMethod::automatic: relative tolerance of the linear solve, and twice the iterations to 1e-8 on the worst mesh measured.
constexpr double newton_gain = 1e-6;
constexpr int max_iterations = 200;

/// Interpolation of a node from vertices; a vertex is its own only vertex.
struct Weights {
    int count = 0;
    std::array<Index, 8> vertices{};
    std::array<double, 8> values{};
};

std::vector<Weights> weights_of_nodes(const mesh::Mesh& mesh) {
    std::vector<Weights> all(mesh.points.size());
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
        const auto nodes = mesh.cell_nodes(cell);
        const auto& topology = mesh::topology(mesh.cell_type(cell));
        for (std::size_t a = 0; a < nodes.size(); ++a) {
            Weights& weights = all[static_cast<std::size_t>(nodes[a])];
            if (weights.count > 0) continue;
            const auto values = mesh::vertex_values(topology.type, topology.nodes[a]);
            for (std::size_t v = 0; v < values.size(); ++v) {
                if (values[v] == 0.0) continue;
                weights.vertices[static_cast<std::size_t>(weights.count)] = nodes[v];
                weights.values[static_cast<std::size_t>(weights.count++)] = values[v];
            }
        }
    }
    return all;
}

/// Indices among the marked unknowns, in their order; -1 for the others. Those of lower ranks come first.
struct Numbering {
    std::vector<PetscInt> number;
    PetscInt begin = 0, end = 0, total = 0;
};

Numbering number_marked(const std::vector<char>& marked, const DofMap& map) {
    Numbering numbering;
    numbering.number.assign(marked.size(), -1);
    for (std::size_t dof = 0; dof < marked.size(); ++dof) {
        if (static_cast<PetscInt>(dof) == map.begin) numbering.begin = numbering.total;
        if (marked[dof] != 0) numbering.number[dof] = numbering.total++;
        if (static_cast<PetscInt>(dof) + 1 == map.end) numbering.end = numbering.total;
    }
    return numbering;
}

linalg::Matrix make_interpolation(const System& system, const Numbering& fine, const Numbering& coarse,
                                  const std::vector<Weights>& weights) {
    const DofMap& map = system.dofs();
    linalg::Matrix P;
    SOFT_PETSC(MatCreate(system.comm(), P.out()));
    SOFT_PETSC(MatSetType(P, MATAIJ));
    SOFT_PETSC(MatSetSizes(P, fine.end - fine.begin, coarse.end - coarse.begin, fine.total, coarse.total));
    SOFT_PETSC(MatSeqAIJSetPreallocation(P, 8, nullptr));
    SOFT_PETSC(MatMPIAIJSetPreallocation(P, 8, nullptr, 8, nullptr));
    for (std::size_t node = 0; node < weights.size(); ++node)
        for (int i = 0; i < map.dimension; ++i) {
            const PetscInt dof =
                map.displacement[node * static_cast<std::size_t>(map.dimension) + static_cast<std::size_t>(i)];
            if (dof < map.begin || dof >= map.end) continue;
            for (int v = 0; v < weights[node].count; ++v) {
                const PetscInt vertex = map.displacement[weights[node].vertices[v] * map.dimension + i];
                if (vertex < 0) continue;
                SOFT_PETSC(
                    MatSetValue(P, fine.number[dof], coarse.number[vertex], weights[node].values[v], INSERT_VALUES));
            }
        }
    linalg::assemble(P);
    return P;
}

linalg::IndexSet own_marked(const System& system, const std::vector<char>& marked, char kind) {
    const DofMap& map = system.dofs();
    std::vector<PetscInt> own;
    for (PetscInt dof = map.begin; dof < map.end; ++dof)
        if (marked[static_cast<std::size_t>(dof)] == kind) own.push_back(dof);
    linalg::IndexSet set;
    SOFT_PETSC(
        ISCreateGeneral(system.comm(), static_cast<PetscInt>(own.size()), own.data(), PETSC_COPY_VALUES, set.out()));
    return set;
}

/// A block and its first unknown.
struct PlacedBlock {
    PetscInt first;
    linalg::PressureBlock block;
};

/// The blocks of this rank, in the order of the unknowns. A vertex gets the contributions of all its cells, also of other ranks.
std::vector<linalg::PressureBlock> pressure_blocks(const System& system) {
    using linalg::PressureBlock;
    const model::Case& input = system.input();
    const DofMap& map = system.dofs();
    std::vector<double> modulus_Pa, of_vertex(map.vertex_pressure.size(), 0.0);
    for (const auto& rubber : system.discretization().rubbers)
        modulus_Pa.push_back(material::initial_shear_modulus_Pa(rubber));
    std::vector<PlacedBlock> placed;
    const auto is_own = [&](PetscInt dof) { return dof >= map.begin && dof < map.end; };
    for (Index cell = 0; cell < input.mesh.cell_count(); ++cell) {
        const auto& reference = reference_of(system.discretization().references, input.mesh.cell_type(cell));
        const bool discontinuous = reference.pressure == fem::PressureSpace::discontinuous_linear;
        if (reference.pressure_dofs == 0 || (discontinuous && !is_own(map.cell_pressure[cell]))) continue;
        const auto nodes = input.mesh.cell_nodes(cell);
        const auto X = mesh::by_component(input.mesh.points, nodes, map.dimension);
        auto mass = fem::pressure_mass(reference, input.kinematics, X, map.pressure_scale_Pa);
        for (double& m : mass) m /= modulus_Pa[input.mesh.cell_regions[cell]];
        if (discontinuous)
            placed.push_back(
                {map.cell_pressure[cell], {PressureBlock::Kind::of_cell, reference.pressure_dofs, std::move(mass)}});
        else
            for (int v = 0; v < reference.pressure_dofs; ++v)
                of_vertex[DofMap::vertex_index(input.mesh, cell, nodes[v])] += mass[v * (reference.pressure_dofs + 1)];
    }
    for (std::size_t vertex = 0; vertex < of_vertex.size(); ++vertex)
        if (is_own(map.vertex_pressure[vertex]))
            placed.push_back({map.vertex_pressure[vertex], {PressureBlock::Kind::of_vertex, 1, {of_vertex[vertex]}}});
    std::ranges::sort(placed, {}, &PlacedBlock::first);
    std::vector<PressureBlock> blocks;
    for (auto& [first, block] : placed) blocks.push_back(std::move(block));
    return blocks;
}

}  // namespace

linalg::ElementLevels make_element_levels(const System& system) {
    const auto& mesh = system.input().mesh;
    const DofMap& map = system.dofs();
    const auto weights = weights_of_nodes(mesh);
    std::vector<char> displacement(static_cast<std::size_t>(map.total), 0), vertex = displacement;
    for (std::size_t node = 0; node < weights.size(); ++node)
        for (int i = 0; i < map.dimension; ++i) {
            const PetscInt dof = map.displacement[node * map.dimension + i];
            if (dof < 0) continue;
            displacement[dof] = 1;
            vertex[dof] = weights[node].count == 1;
        }
    const Numbering fine = number_marked(displacement, map), coarse = number_marked(vertex, map);
    if (coarse.total == 0 || coarse.total == fine.total)
        throw Error(ExitCode::bad_input, "solver.preconditioner",
                    coarse.total == 0 ? "multigrid needs free vertices" : "multigrid supports only second-order cells",
                    "use gamg, or linear: auto");
    linalg::ElementLevels levels;
    levels.displacements = own_marked(system, displacement, 1);
    levels.pressures = own_marked(system, displacement, 0);
    levels.interpolation = make_interpolation(system, fine, coarse, weights);
    levels.blocks = pressure_blocks(system);
    return levels;
}

double most_flops(PetscInt unknowns) {
    const double n = unknowns;
    return std::min(flops_of_multigrid * n, most_entries * most_entries / n);
}

double predicted_flops(const mesh::Mesh& mesh, PetscInt unknowns) {
    std::vector<PetscInt> rows, columns;
    constexpr std::size_t most_nodes = 27;  // of a cell
    rows.reserve(most_nodes * mesh.connectivity.size());
    columns.reserve(most_nodes * mesh.connectivity.size());
    for (Index cell = 0; cell < mesh.cell_count(); ++cell)
        for (const Index a : mesh.cell_nodes(cell))
            for (const Index b : mesh.cell_nodes(cell)) {
                rows.push_back(static_cast<PetscInt>(a));
                columns.push_back(static_cast<PetscInt>(b));
            }
    const auto nodes = static_cast<PetscInt>(mesh.points.size());
    linalg::Matrix graph;
    SOFT_PETSC(MatCreate(PETSC_COMM_SELF, graph.out()));
    SOFT_PETSC(MatSetSizes(graph, nodes, nodes, nodes, nodes));
    SOFT_PETSC(MatSetType(graph, MATSEQAIJ));
    SOFT_PETSC(MatSetPreallocationCOO(graph, static_cast<PetscCount>(rows.size()), rows.data(), columns.data()));
    return linalg::Multifrontal(graph).flops() * std::pow(static_cast<double>(unknowns) / nodes, 3.0);
}

model::LinearSettings choose_linear(model::LinearSettings wanted, const model::Case& input, PetscInt unknowns,
                                    linalg::Symmetry symmetry) {
    const bool second_order =
        std::ranges::all_of(input.mesh.cell_types, [](mesh::CellType type) { return mesh::topology(type).order == 2; });
    const bool large = unknowns > always_factorised && input.mesh.dimension == 3 && second_order;
    if (wanted.method != model::LinearMethod::automatic || !large) return wanted;
    if (symmetry == linalg::Symmetry::symmetric && predicted_flops(input.mesh, unknowns) <= most_flops(unknowns))
        return wanted;
    return {model::LinearMethod::krylov, model::Preconditioner::multigrid, newton_gain, max_iterations};
}

void configure_preconditioner(linalg::LinearSolver& solver, const System& system, Mat K) {
    if (!solver.is_krylov()) return;
    if (solver.settings().preconditioner == model::Preconditioner::gamg) attach_rigid_motions(system, K);
    if (solver.settings().preconditioner == model::Preconditioner::multigrid)
        solver.set_levels(make_element_levels(system));
}

}  // namespace soft::fem
