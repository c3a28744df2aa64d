#include "model/cavity_surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "core/error.hpp"

namespace soft::model {
namespace {

using mesh::Index;

/// Edges that belong to exactly one facet of the set, in the order of the facets.
std::vector<RimEdge> free_edges(const mesh::Mesh& mesh, std::span<const mesh::Facet> facets) {
    using Key = std::pair<Index, Index>;
    std::map<Key, int> uses;
    const auto key = [](const RimEdge& edge) { return Key{std::min(edge[0], edge[1]), std::max(edge[0], edge[1])}; };
    std::vector<RimEdge> all, free;
    for (const mesh::Facet& facet : facets) {
        const std::vector<Index> nodes = facet_nodes(mesh, facet);
        for (const mesh::FacetTopology& side : mesh::topology(facet_type(mesh, facet)).facets) {
            RimEdge edge;
            for (int i = 0; i < mesh::node_count(side.type); ++i)
                edge.push_back(nodes[static_cast<std::size_t>(side.nodes[static_cast<std::size_t>(i)])]);
            if (edge[0] == edge[1]) continue;  // collapsed onto the axis
            ++uses[key(edge)];
            all.push_back(std::move(edge));
        }
    }
    for (RimEdge& edge : all)
        if (uses[key(edge)] == 1) free.push_back(std::move(edge));
    return free;
}

bool on_symmetry_plane(const Case& model, const RimEdge& edge, double tolerance_m) {
    for (std::size_t d = 0; d < 3; ++d)
        if (model.symmetry_planes[d] && std::all_of(edge.begin(), edge.end(), [&](Index node) {
                return std::abs(model.mesh.point(node)[d]) <= tolerance_m;
            }))
            return true;
    return false;
}

}  // namespace

std::vector<std::vector<RimEdge>> rims(const Case& model, std::span<const mesh::Facet> facets) {
    const double tolerance_m = mesh::plane_tolerance * mesh::extent_m(model.mesh);
    std::vector<RimEdge> edges = free_edges(model.mesh, facets);
    std::erase_if(edges, [&](const RimEdge& edge) { return on_symmetry_plane(model, edge, tolerance_m); });

    // Connected edges get the same label. Relabelling is fast enough: rims have tens of edges, and openings are few.
    std::vector<std::size_t> label(edges.size());
    std::iota(label.begin(), label.end(), std::size_t{0});
    std::map<Index, std::size_t> first_at;  // vertex -> an edge that ends there
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (const Index end : {edges[i][0], edges[i][1]})
            if (const auto [other, is_new] = first_at.emplace(end, i); !is_new) {
                const std::size_t from = std::max(label[i], label[other->second]),
                                  to = std::min(label[i], label[other->second]);
                std::replace(label.begin(), label.end(), from, to);
            }
    std::map<std::size_t, std::vector<RimEdge>> chains;
    for (std::size_t i = 0; i < edges.size(); ++i) chains[label[i]].push_back(std::move(edges[i]));
    std::vector<std::vector<RimEdge>> out;
    for (auto& [_, chain] : chains) out.push_back(std::move(chain));
    return out;
}

std::array<bool, 3> planes_through(const Case& model, std::span<const RimEdge> rim) {
    const double tolerance_m = mesh::plane_tolerance * mesh::extent_m(model.mesh);
    std::array<bool, 3> cut{};
    for (std::size_t d = 0; d < 3; ++d)
        for (const RimEdge& edge : rim)
            for (const Index node : edge)
                cut[d] = cut[d] || (model.symmetry_planes[d] && std::abs(model.mesh.point(node)[d]) <= tolerance_m);
    return cut;
}

std::vector<mesh::Facet> cavity_facets(const Case& model, const Cavity& cavity) {
    std::vector<std::string> faces{cavity.wall};
    faces.insert(faces.end(), cavity.inner_faces.begin(), cavity.inner_faces.end());
    std::set<mesh::Facet> seen;
    std::vector<mesh::Facet> facets;
    for (const std::string& face : faces) {
        const auto found = model.mesh.facet_sets.find(face);
        if (found == model.mesh.facet_sets.end() || found->second.empty())
            throw Error(ExitCode::bad_input, cavity.name, "the mesh has no face '" + face + "'");
        for (const mesh::Facet& facet : found->second)
            if (seen.insert(facet).second) facets.push_back(facet);
    }
    return facets;
}

}  // namespace soft::model
