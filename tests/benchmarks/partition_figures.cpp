// partition_figures CASE PARTS...: statistics of the partition that solve would use on PARTS ranks: unknowns that each rank owns and reads
// from others, and its neighbours. Prints one CSV row per number of parts.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <set>

#include "core/error.hpp"
#include "core/files.hpp"
#include "fem/partition.hpp"
#include "geometry/build.hpp"
#include "io/case_file.hpp"
#include "linalg/session.hpp"

namespace {

using namespace soft;

constexpr int displacements_per_node = 3, pressures_per_hexahedron = 4;

struct Figures {
    std::vector<long> cells, own, ghosts, neighbours;  // [part]; own and ghosts in unknowns
};

/// A node belongs to the lowest part that uses it, as in fem/dof_map.hpp. Ghosts are the nodes of a part's cells that belong to other
/// parts. Pressures of hexahedra belong to the part of their cell; those of wedges (few, at the axis) are ignored.
Figures figures_of(const mesh::Mesh& mesh, const std::vector<int>& part_of_cell, int parts) {
    const auto count = static_cast<std::size_t>(parts);
    Figures figures{std::vector<long>(count), std::vector<long>(count), std::vector<long>(count), {}};
    std::vector<std::vector<int>> users(mesh.points.size());
    for (mesh::Index cell = 0; cell < mesh.cell_count(); ++cell) {
        const int part = part_of_cell[static_cast<std::size_t>(cell)];
        ++figures.cells[static_cast<std::size_t>(part)];
        if (mesh.cell_type(cell) == mesh::CellType::hex27)
            figures.own[static_cast<std::size_t>(part)] += pressures_per_hexahedron;
        for (const auto node : mesh.cell_nodes(cell)) {
            auto& list = users[static_cast<std::size_t>(node)];
            if (std::ranges::find(list, part) == list.end()) list.push_back(part);
        }
    }
    std::vector<std::set<int>> neighbours(count);
    for (const auto& list : users) {
        if (list.empty()) continue;
        const int owner = *std::ranges::min_element(list);
        figures.own[static_cast<std::size_t>(owner)] += displacements_per_node;
        for (const int part : list) {
            if (part == owner) continue;
            figures.ghosts[static_cast<std::size_t>(part)] += displacements_per_node;
            neighbours[static_cast<std::size_t>(part)].insert(owner);
            neighbours[static_cast<std::size_t>(owner)].insert(part);
        }
    }
    for (const auto& of_part : neighbours) figures.neighbours.push_back(static_cast<long>(of_part.size()));
    return figures;
}

double mean(const std::vector<long>& values) {
    double sum = 0;
    for (const long value : values) sum += static_cast<double>(value);
    return sum / static_cast<double>(values.size());
}

void print_row(const mesh::Mesh& mesh, int parts) {
    const auto figures = figures_of(mesh, fem::partition_cells(mesh, MPI_COMM_WORLD, parts), parts);
    const auto largest = [](const std::vector<long>& values) { return *std::ranges::max_element(values); };
    std::printf("%d,%.0f,%ld,%.0f,%ld,%.0f,%ld,%.3f,%.1f,%ld\n", parts, mean(figures.cells), largest(figures.cells),
                mean(figures.own), largest(figures.own), mean(figures.ghosts), largest(figures.ghosts),
                mean(figures.ghosts) / mean(figures.own), mean(figures.neighbours), largest(figures.neighbours));
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc < 3) throw Error(ExitCode::usage, "partition_figures", "arguments are missing", "give CASE PARTS...");
    const linalg::Session session({});
    const auto input = io::read_case_file(core::read_file(argv[1]), argv[1], geometry::rebuild_case).model;
    std::printf(
        "parts,cells,cells_max,own_unknowns,own_max,ghost_unknowns,ghost_max,ghosts_per_own,neighbours,neighbours_max\n");
    for (int i = 2; i < argc; ++i) print_row(input.mesh, std::atoi(argv[i]));
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
