#include "fem/surface_cell.hpp"

#include <utility>

namespace soft::fem {

SurfaceCell make_surface_cell(const Discretization& fe, std::vector<mesh::Index> nodes,
                              const model::ReferenceFacet* reference) {
    SurfaceCell cell{reference, std::move(nodes), {}, {}};
    fe.dofs.node_dofs(cell.nodes, cell.dofs);
    cell.X = mesh::by_component(fe.input.mesh.points, cell.nodes, fe.dofs.dimension);
    return cell;
}

std::vector<SurfaceCell> own_facets(const Discretization& fe, const std::vector<mesh::Facet>& facets) {
    const auto& mesh = fe.input.mesh;
    std::vector<SurfaceCell> cells;
    for (const auto& facet : facets)
        if (fe.dofs.cell_rank[facet.cell] == fe.rank)
            cells.push_back(make_surface_cell(fe, mesh::facet_nodes(mesh, facet),
                                              &model::reference_facet(mesh::facet_type(mesh, facet))));
    return cells;
}

SurfaceCell nodes_on_rank_0(const Discretization& fe, const std::vector<mesh::Index>& nodes) {
    return fe.rank == 0 ? make_surface_cell(fe, nodes) : SurfaceCell{};
}

}  // namespace soft::fem
