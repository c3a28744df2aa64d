#include "assembly/cavity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "core/error.hpp"

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

/// An edge with its nodes in the direction in which its facet runs round.
struct Edge {
    std::vector<Index> nodes;   // two ends, then the middle node of second-order edges
};

std::vector<Edge> facet_edges(const Mesh& mesh, const Facet& facet) {
    const auto nodes = mesh::facet_nodes(mesh, facet);
    const auto& topology = mesh::topology(mesh::facet_type(mesh, facet));
    std::vector<Edge> edges;
    for (const auto& side : topology.facets) {
        Edge edge;
        for (int a = 0; a < mesh::node_count(side.type); ++a) edge.nodes.push_back(nodes[side.nodes[a]]);
        edges.push_back(std::move(edge));
    }
    return edges;
}

bool on_symmetry_plane(const model::Case& input, const Edge& edge, double tolerance_m) {
    for (int plane = 0; plane < 3; ++plane)
        if (input.symmetry_planes[plane] && std::ranges::all_of(edge.nodes, [&](Index node) {
                return std::abs(input.mesh.point(node)[plane]) <= tolerance_m;
            }))
            return true;
    return false;
}

double mesh_extent(const Mesh& mesh) {
    double extent = 0;
    for (const auto& point : mesh.points)
        for (const double x : point) extent = std::max(extent, std::abs(x));
    return extent;
}

/// Edges that belong to one facet of the surface only and do not lie on a plane of symmetry: the rims of its holes.
std::vector<Edge> free_edges(const model::Case& input, const std::vector<Facet>& surface) {
    std::map<std::pair<Index, Index>, Edge> open;
    for (const auto& facet : surface)
        for (auto& edge : facet_edges(input.mesh, facet)) {
            const auto key = std::minmax(edge.nodes[0], edge.nodes[1]);
            if (const auto twin = open.find(key); twin != open.end())
                open.erase(twin);
            else
                open.emplace(key, std::move(edge));
        }
    // Mesh points are computed to rounding; a cut plane is exact to far better than this.
    const double tolerance_m = 1e-9 * mesh_extent(input.mesh);
    std::vector<Edge> rim;
    for (auto& [key, edge] : open)
        if (!on_symmetry_plane(input, edge, tolerance_m)) rim.push_back(std::move(edge));
    return rim;
}

/// Groups rim edges that share nodes into loops (union-find over the edges' ends).
std::vector<Rim> make_rims(const DofMap& map, const std::vector<Edge>& edges,
                           SurfaceTables& tables) {
    std::map<Index, Index> parent;
    const auto root = [&parent](Index node) {
        while (parent[node] != node) node = parent[node] = parent[parent[node]];
        return node;
    };
    for (const auto& edge : edges) {
        for (const Index node : edge.nodes) parent.try_emplace(node, node);
        for (const Index node : edge.nodes) parent[root(node)] = root(edge.nodes[0]);
    }
    std::map<Index, Rim> rims;
    for (const auto& edge : edges) {
        const auto type = edge.nodes.size() == 3 ? mesh::CellType::line3 : mesh::CellType::line2;
        rims[root(edge.nodes[0])].edges.push_back(make_surface_cell(map, type, edge.nodes, tables));
    }
    std::vector<Rim> list;
    for (auto& [first, rim] : rims) {
        for (const auto& edge : rim.edges) rim.nodes.insert(rim.nodes.end(), edge.nodes.begin(), edge.nodes.end());
        std::ranges::sort(rim.nodes);
        const auto repeated = std::ranges::unique(rim.nodes);
        rim.nodes.erase(repeated.begin(), repeated.end());
        list.push_back(std::move(rim));
    }
    return list;
}

void append(std::vector<Facet>& to, const std::vector<Facet>& from) { to.insert(to.end(), from.begin(), from.end()); }

}  // namespace

int SurfaceTables::index_of(mesh::CellType type) {
    for (std::size_t i = 0; i < tables_.size(); ++i)
        if (tables_[i].type == type) return static_cast<int>(i);
    tables_.push_back(element::make_reference_facet(type));
    return static_cast<int>(tables_.size()) - 1;
}

SparseVector mean_displacement(const model::Case& input, const DofMap& map, const std::string& face,
                               const std::array<double, 3>& direction) {
    const Mesh& mesh = input.mesh;
    SurfaceTables tables;
    std::map<Index, double> weights;   // ordered: the sums run in the same order on every rank
    double area = 0;
    for (const auto& facet : face_of(mesh, face)) {
        const auto& reference = tables[tables.index_of(mesh::facet_type(mesh, facet))];
        const auto nodes = mesh::facet_nodes(mesh, facet);
        std::vector<double> X(reference.dofs()), share(reference.nodes, 0.0);
        for (int i = 0; i < mesh.dimension; ++i)
            for (int a = 0; a < reference.nodes; ++a) X[i * reference.nodes + a] = mesh.point(nodes[a])[i];
        area += element::facet_area(reference, input.kinematics, X, share);
        for (int a = 0; a < reference.nodes; ++a) weights[nodes[a]] += share[a];
    }
    SparseVector vector;
    for (const auto& [node, weight] : weights)
        for (int i = 0; i < mesh.dimension; ++i) {
            const auto dof = map.displacement[node * mesh.dimension + i];
            if (dof < 0 || direction[i] == 0.0) continue;
            vector.dofs.push_back(dof);
            vector.values.push_back(direction[i] * weight / area);
        }
    return vector;
}

LoadSurface make_load_surface(const model::Case& input, const DofMap& map, const model::PressureLoad& load, int rank,
                              SurfaceTables& tables) {
    LoadSurface surface;
    surface.pressure_Pa = load.pressure_Pa;
    const auto cavity = std::ranges::find(input.cavities, load.target, &model::Cavity::name);
    std::vector<Facet> facets = face_of(input.mesh, cavity == input.cavities.end() ? load.target : cavity->wall);
    if (cavity != input.cavities.end() && load.sealed) {
        for (const auto& face : cavity->inner_faces) append(facets, face_of(input.mesh, face));
        for (const auto& opening : cavity->openings) {
            const auto mean = mean_displacement(input, map, opening.face, opening.direction);
            for (std::size_t i = 0; i < mean.dofs.size(); ++i) {
                surface.plug_force.dofs.push_back(mean.dofs[i]);
                surface.plug_force.values.push_back(opening.area_m2 * input.model_fraction * mean.values[i]);
            }
        }
    }
    surface.facets = own_facets(input.mesh, map, facets, rank, tables);
    return surface;
}

EnclosedVolume make_enclosed_volume(const model::Case& input, const DofMap& map, const model::Cavity& cavity, int rank,
                                    SurfaceTables& tables) {
    EnclosedVolume volume;
    std::vector<Facet> facets = face_of(input.mesh, cavity.wall);
    for (const auto& face : cavity.inner_faces) append(facets, face_of(input.mesh, face));
    if (input.mesh.dimension == 3 && rank == 0)
        volume.rims = make_rims(map, free_edges(input, facets), tables);
    volume.facets = own_facets(input.mesh, map, facets, rank, tables);
    volume.symmetry_planes = input.symmetry_planes;
    volume.model_fraction = input.model_fraction;
    return volume;
}

}  // namespace soft::assembly
