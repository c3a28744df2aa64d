#include "mesh/single_layer.hpp"

#include <algorithm>
#include <set>

namespace soft::mesh {

double single_layer_fraction(const Mesh& mesh, std::span<const std::string> excluded) {
    std::set<Facet> excluded_facets;
    for (const std::string& name : excluded)
        if (const auto facets = mesh.facet_sets.find(name); facets != mesh.facet_sets.end())
            excluded_facets.insert(facets->second.begin(), facets->second.end());
    std::vector<bool> on_boundary(mesh.points.size(), false);
    for (const Facet& facet : boundary_facets(mesh))
        if (!excluded_facets.contains(facet))
            for (const Index node : facet_nodes(mesh, facet)) on_boundary[static_cast<std::size_t>(node)] = true;
    Index single = 0;
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
        const auto vertices =
            mesh.cell_nodes(cell).first(static_cast<std::size_t>(topology(mesh.cell_type(cell)).vertex_count));
        if (std::ranges::all_of(vertices, [&](Index node) { return on_boundary[static_cast<std::size_t>(node)]; }))
            ++single;
    }
    return mesh.cell_count() > 0 ? static_cast<double>(single) / static_cast<double>(mesh.cell_count()) : 0;
}

}  // namespace soft::mesh
