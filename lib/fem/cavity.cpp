#include "fem/cavity.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/error.hpp"
#include "model/cavity_surface.hpp"

namespace soft::fem {

namespace {

using mesh::Facet;
using mesh::Index;
using mesh::Mesh;

const std::vector<Facet>& face_of(const Mesh& mesh, const std::string& name) {
    const auto found = mesh.facet_sets.find(name);
    if (found == mesh.facet_sets.end() || found->second.empty())
        throw Error(ExitCode::bad_input, "loads", "no face is called '" + name + "'");
    return found->second;
}

SurfaceCell make_surface_cell(const DofMap& map, mesh::CellType type, std::vector<Index> nodes, SurfaceTables& tables) {
    SurfaceCell cell;
    cell.reference = tables.index_of(type);
    map.node_dofs(nodes, cell.dofs);
    cell.nodes = std::move(nodes);
    return cell;
}

std::vector<SurfaceCell> own_facets(const Mesh& mesh, const DofMap& map, const std::vector<Facet>& facets, int rank,
                                    SurfaceTables& tables) {
    std::vector<SurfaceCell> cells;
    for (const auto& facet : facets)
        if (map.cell_rank[facet.cell] == rank)
            cells.push_back(
                make_surface_cell(map, mesh::facet_type(mesh, facet), mesh::facet_nodes(mesh, facet), tables));
    return cells;
}

/// The rims of a surface with their unknowns.
std::vector<Rim> make_rims(const model::Case& input, const DofMap& map,
                           const std::vector<std::vector<model::RimEdge>>& chains, SurfaceTables& tables) {
    std::vector<Rim> rims;
    for (const auto& chain : chains) {
        Rim& rim = rims.emplace_back();
        std::set<Index> nodes;
        for (const auto& edge : chain) {
            const auto type = edge.size() == 3 ? mesh::CellType::line3 : mesh::CellType::line2;
            rim.edges.push_back(make_surface_cell(map, type, edge, tables));
            nodes.insert(edge.begin(), edge.end());
        }
        rim.nodes.assign(nodes.begin(), nodes.end());
        // Nodes of a cut lie on its plane exactly.
        for (int i = 0; i < 3; ++i)
            rim.on_plane[i] = input.symmetry_planes[i] && std::ranges::any_of(rim.nodes, [&](Index node) {
                                  return input.mesh.point(node)[i] == 0.0;
                              });
    }
    return rims;
}

}  // namespace

int SurfaceTables::index_of(mesh::CellType type) {
    for (std::size_t i = 0; i < tables_.size(); ++i)
        if (tables_[i].type == type) return static_cast<int>(i);
    tables_.push_back(fem::make_reference_facet(type));
    return static_cast<int>(tables_.size()) - 1;
}

std::vector<SurfaceCell> face_cells(const model::Case& input, const DofMap& map, const std::string& face, int rank,
                                    SurfaceTables& tables) {
    return own_facets(input.mesh, map, face_of(input.mesh, face), rank, tables);
}

LoadSurface make_load_surface(const model::Case& input, const DofMap& map, const model::PressureLoad& load, int rank,
                              SurfaceTables& tables) {
    LoadSurface surface;
    surface.plug_force = on_unknowns(plug_force(input, load), map);
    for (const auto& target : load.targets) {
        const auto cavity = std::ranges::find(input.cavities, target, &model::Cavity::name);
        const bool is_cavity = cavity != input.cavities.end();
        const auto facets = is_cavity && load.sealed ? model::cavity_facets(input, *cavity)
                                                     : face_of(input.mesh, is_cavity ? cavity->wall : target);
        for (auto& facet : own_facets(input.mesh, map, facets, rank, tables))
            surface.facets.push_back(std::move(facet));
    }
    return surface;
}

EnclosedVolume make_enclosed_volume(const model::Case& input, const DofMap& map, const model::Cavity& cavity, int rank,
                                    SurfaceTables& tables) {
    EnclosedVolume volume;
    const std::vector<Facet> facets = model::cavity_facets(input, cavity);
    if (input.mesh.dimension == 3 && rank == 0) volume.rims = make_rims(input, map, model::rims(input, facets), tables);
    volume.facets = own_facets(input.mesh, map, facets, rank, tables);
    volume.model_fraction = input.model_fraction;
    return volume;
}

}  // namespace soft::fem
