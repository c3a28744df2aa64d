#include "contact/inverted_wall.hpp"

#include <algorithm>
#include <set>

#include "mesh/cell_map.hpp"
#include "surface/facet_map.hpp"

namespace soft::contact {
namespace {

using mesh::Index;

/// Position and tangents at the mean of the corners of a facet.
surface::FacetMap::Value middle(const mesh::Mesh& mesh, const mesh::Facet& facet) {
    const auto centre = mesh::reference_centre(mesh::facet_type(mesh, facet));
    return surface::facet_map(mesh, facet, mesh.points)({centre[0], centre[1]});
}

/// Cosine between the normals of the two sides of a wall is below this; for facets at an edge or on a curved surface it is above.
constexpr double opposed = -0.5;

bool behind_each_other(const mesh::Mesh& mesh, const std::array<mesh::Facet, 2>& facets) {
    const auto a = middle(mesh, facets[0]), b = middle(mesh, facets[1]);
    const Vector3 m = cross(a.t1, a.t2), n = cross(b.t1, b.t2), between = along(b.x, -1, a.x);
    return dot(m, n) < opposed * norm(m) * norm(n) && dot(m, between) < 0 && dot(n, between) > 0;
}

/// det F has the sign of the determinant of the deformed map. Nodes at which the undeformed cell is degenerate are ignored.
bool has_inverted_node(const mesh::Mesh& undeformed, const mesh::Mesh& deformed, Index cell) {
    const mesh::CellType type = deformed.cell_type(cell);
    return std::ranges::any_of(mesh::topology(type).nodes, [&](const mesh::Point& xi) {
        const auto shapes = mesh::shape_values(type, xi);
        return mesh::map_cell(undeformed, cell, shapes).determinant > 0 &&
               mesh::map_cell(deformed, cell, shapes).determinant <= 0;
    });
}

}  // namespace

bool is_wall_inverted(const mesh::Mesh& mesh, const std::array<mesh::Facet, 2>& facets,
                      std::span<const mesh::Point> positions) {
    return behind_each_other(mesh, facets) && has_inverted_cell(mesh, facets, positions);
}

bool has_inverted_cell(const mesh::Mesh& mesh, std::span<const mesh::Facet> facets,
                       std::span<const mesh::Point> positions) {
    std::set<Index> nodes;
    for (const mesh::Facet& facet : facets)
        for (const Index node : mesh::facet_nodes(mesh, facet)) nodes.insert(node);
    mesh::Mesh deformed = mesh;
    deformed.points.assign(positions.begin(), positions.end());
    for (Index cell = 0; cell < mesh.cell_count(); ++cell)
        if (std::ranges::any_of(mesh.cell_nodes(cell), [&](Index node) { return nodes.contains(node); }) &&
            has_inverted_node(mesh, deformed, cell))
            return true;
    return false;
}

}  // namespace soft::contact
