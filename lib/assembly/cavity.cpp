#include "assembly/cavity.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/error.hpp"
#include "model/cavity_surface.hpp"

namespace soft::assembly {

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
std::vector<Rim> make_rims(const model::Case& input, const DofMap& map, const std::vector<std::vector<model::RimEdge>>& chains,
                           SurfaceTables& tables) {
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
    tables_.push_back(element::make_reference_facet(type));
    return static_cast<int>(tables_.size()) - 1;
}

namespace {

/// int N_a dA over an undeformed face by node, and their sum.
struct FaceWeights {
    std::map<Index, double> node;   // ordered: the sums run in the same order on every rank
    double area = 0;
};

FaceWeights face_weights(const model::Case& input, const std::string& face) {
    const Mesh& mesh = input.mesh;
    SurfaceTables tables;
    FaceWeights weights;
    for (const auto& facet : face_of(mesh, face)) {
        const auto& reference = tables[tables.index_of(mesh::facet_type(mesh, facet))];
        const auto nodes = mesh::facet_nodes(mesh, facet);
        std::vector<double> X(reference.dofs()), share(reference.nodes, 0.0);
        for (int i = 0; i < mesh.dimension; ++i)
            for (int a = 0; a < reference.nodes; ++a) X[i * reference.nodes + a] = mesh.point(nodes[a])[i];
        weights.area += element::facet_area(reference, input.kinematics, X, share);
        for (int a = 0; a < reference.nodes; ++a) weights.node[nodes[a]] += share[a];
    }
    return weights;
}

SparseVector weighted(const std::map<Index, double>& weights, const DofMap& map, const std::array<double, 3>& factor) {
    SparseVector vector;
    for (const auto& [node, weight] : weights)
        for (int i = 0; i < map.dimension; ++i) {
            const auto dof = map.displacement[node * map.dimension + i];
            if (dof < 0 || factor[i] == 0.0) continue;
            vector.dofs.push_back(dof);
            vector.values.push_back(factor[i] * weight);
        }
    return vector;
}

}  // namespace

SparseVector mean_displacement(const model::Case& input, const DofMap& map, const std::string& face,
                               const std::array<double, 3>& direction) {
    const FaceWeights weights = face_weights(input, face);
    SparseVector mean = weighted(weights.node, map, direction);
    for (double& value : mean.values) value /= weights.area;
    return mean;
}

SparseVector face_force(const model::Case& input, const DofMap& map, const std::string& face,
                        const std::array<double, 3>& traction_Pa) {
    return weighted(face_weights(input, face).node, map, traction_Pa);
}

LoadSurface make_load_surface(const model::Case& input, const DofMap& map, const model::PressureLoad& load, int rank,
                              SurfaceTables& tables) {
    LoadSurface surface;
    surface.pressure_Pa = load.pressure_Pa;
    const auto cavity = std::ranges::find(input.cavities, load.target, &model::Cavity::name);
    const bool is_cavity = cavity != input.cavities.end();
    const auto facets = is_cavity && load.sealed ? model::cavity_facets(input, *cavity)
                                                 : face_of(input.mesh, is_cavity ? cavity->wall : load.target);
    if (is_cavity && load.sealed)
        for (const auto& opening : cavity->openings) {
            const auto mean = mean_displacement(input, map, opening.face, opening.direction);
            for (std::size_t i = 0; i < mean.dofs.size(); ++i) {
                surface.plug_force.dofs.push_back(mean.dofs[i]);
                surface.plug_force.values.push_back(opening.area_m2 * input.model_fraction * mean.values[i]);
            }
        }
    surface.facets = own_facets(input.mesh, map, facets, rank, tables);
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

}  // namespace soft::assembly
