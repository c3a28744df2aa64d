#include "mesh/split.hpp"

#include <algorithm>
#include <stdexcept>

namespace soft::mesh {
namespace {

/// Local corner numbers of a facet of the parent, or of a piece of one.
using Corners = std::vector<int>;

bool has(const Corners& corners, int corner) {
    return std::find(corners.begin(), corners.end(), corner) != corners.end();
}

Corners corners_of(const FacetTopology& facet) {
    return {facet.nodes.begin(), facet.nodes.begin() + topology(facet.type).vertex_count};
}

int smallest(const Corners& corners, std::span<const Index> nodes) {
    return *std::min_element(corners.begin(), corners.end(), [&](int a, int b) { return nodes[a] < nodes[b]; });
}

/// A line or triangle is returned unchanged, a quadrilateral as two triangles of the same orientation.
std::vector<Corners> pieces_of(const Corners& facet, std::span<const Index> nodes) {
    if (facet.size() < 4) return {facet};
    const auto first =
        static_cast<std::size_t>(std::find(facet.begin(), facet.end(), smallest(facet, nodes)) - facet.begin());
    const auto at = [&](std::size_t k) { return facet[(first + k) % 4]; };
    return {{at(0), at(1), at(2)}, {at(0), at(2), at(3)}};
}

/// Positively oriented simplices (corners) that connect the cell corner with the smallest number to the pieces of the facets that
/// do not contain it.
std::vector<Corners> simplices_of(const CellTopology& cell, std::span<const Index> nodes) {
    Corners all(static_cast<std::size_t>(cell.vertex_count));
    for (int i = 0; i < cell.vertex_count; ++i) all[i] = i;
    const int apex = smallest(all, nodes);
    std::vector<Corners> simplices;
    for (const FacetTopology& facet : cell.facets) {
        const Corners corners = corners_of(facet);
        if (has(corners, apex)) continue;
        for (const Corners& piece : pieces_of(corners, nodes)) {
            // The piece is oriented out of the cell, away from the apex; the base of a tetrahedron must be oriented towards it.
            if (cell.dimension == 2)
                simplices.push_back({piece[0], piece[1], apex});
            else
                simplices.push_back({piece[0], piece[2], piece[1], apex});
        }
    }
    return simplices;
}

/// The node of the parent at the midpoint of two of its corners (edge, face or cell centre).
int node_between(const CellTopology& cell, int a, int b) {
    std::array<double, 3> middle{};
    for (std::size_t d = 0; d < 3; ++d) middle[d] = 0.5 * (cell.nodes[a][d] + cell.nodes[b][d]);
    const auto found = std::find(cell.nodes.begin(), cell.nodes.end(), middle);
    if (found == cell.nodes.end()) throw std::logic_error("split: the cell has no node between two of its corners");
    return static_cast<int>(found - cell.nodes.begin());
}

CellType simplex_type(const CellTopology& cell) {
    if (cell.dimension == 2) return cell.order == 1 ? CellType::triangle3 : CellType::triangle6;
    return cell.order == 1 ? CellType::tet4 : CellType::tet10;
}

std::vector<Index> simplex_nodes(const CellTopology& cell, std::span<const Index> nodes, const Corners& corners) {
    std::vector<Index> result;
    for (const int corner : corners) result.push_back(nodes[corner]);
    if (cell.order == 1) return result;
    // The mid nodes follow the corners in the order of the simplex type's reference nodes.
    const CellTopology& simplex = topology(simplex_type(cell));
    for (std::size_t m = corners.size(); m < simplex.nodes.size(); ++m) {
        Corners ends;
        for (std::size_t i = 0; i < corners.size(); ++i)
            for (std::size_t j = i + 1; j < corners.size(); ++j)
                if (node_between(simplex, static_cast<int>(i), static_cast<int>(j)) == static_cast<int>(m))
                    ends = {corners[i], corners[j]};
        result.push_back(nodes[node_between(cell, ends.at(0), ends.at(1))]);
    }
    return result;
}

/// Appends the facets of the cells [first, last) whose corners all belong to `parent`.
void append_child_facets(const Mesh& split, Index first, Index last, const std::vector<Index>& parent,
                         std::vector<Facet>& out) {
    for (Index cell = first; cell < last; ++cell) {
        const auto nodes = split.cell_nodes(cell);
        int local = 0;
        for (const FacetTopology& side : topology(split.cell_type(cell)).facets) {
            const Corners corners = corners_of(side);
            if (std::all_of(corners.begin(), corners.end(),
                            [&](int c) { return std::find(parent.begin(), parent.end(), nodes[c]) != parent.end(); }))
                out.push_back({cell, local});
            ++local;
        }
    }
}

}  // namespace

Mesh split_into_simplices(const Mesh& mesh) {
    Mesh split;
    split.dimension = mesh.dimension;
    split.points = mesh.points;
    split.region_names = mesh.region_names;
    split.point_sets = mesh.point_sets;
    std::vector<Index> first_of;
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        const CellTopology& cell = topology(mesh.cell_type(c));
        const auto nodes = mesh.cell_nodes(c);
        const std::int32_t region = mesh.cell_regions[static_cast<std::size_t>(c)];
        first_of.push_back(split.cell_count());
        if (cell.type == simplex_type(cell)) {
            add_cell(split, cell.type, nodes, region);
            continue;
        }
        for (const Corners& simplex : simplices_of(cell, nodes))
            add_cell(split, simplex_type(cell), simplex_nodes(cell, nodes, simplex), region);
    }
    first_of.push_back(split.cell_count());
    for (const auto& [name, facets] : mesh.facet_sets) {
        auto& set = split.facet_sets[name];
        for (const Facet& facet : facets) {
            const auto c = static_cast<std::size_t>(facet.cell);
            append_child_facets(split, first_of[c], first_of[c + 1], facet_corners(mesh, facet), set);
        }
    }
    return split;
}

}  // namespace soft::mesh
