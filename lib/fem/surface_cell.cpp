#include "fem/surface_cell.hpp"

#include <utility>

namespace soft::fem {

SurfaceCell make_surface_cell(const Discretization& discretization, std::vector<mesh::Index> nodes,
                              const model::ReferenceFacet* reference) {
    SurfaceCell cell{reference, std::move(nodes), {}, {}};
    discretization.dofs.node_dofs(cell.nodes, cell.dofs);
    cell.X = mesh::by_component(discretization.input.mesh.points, cell.nodes, discretization.dofs.dimension);
    return cell;
}

std::vector<SurfaceCell> own_facets(const Discretization& discretization, const std::vector<mesh::Facet>& facets) {
    const auto& mesh = discretization.input.mesh;
    std::vector<SurfaceCell> cells;
    for (const auto& facet : facets)
        if (discretization.dofs.cell_rank[facet.cell] == discretization.rank)
            cells.push_back(make_surface_cell(discretization, mesh::facet_nodes(mesh, facet),
                                              &model::reference_facet(mesh::facet_type(mesh, facet))));
    return cells;
}

SurfaceCell nodes_on_rank_0(const Discretization& discretization, const std::vector<mesh::Index>& nodes) {
    return discretization.rank == 0 ? make_surface_cell(discretization, nodes) : SurfaceCell{};
}

}  // namespace soft::fem
