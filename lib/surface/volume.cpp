#include "surface/volume.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>

#include "core/error.hpp"
#include "surface/facet_map.hpp"

namespace soft::surface {
namespace {

using mesh::Index;
using mesh::Point;

/// The facet's share of the enclosed volume, see the header.
double facet_volume_m3(model::Kinematics kinematics, const FacetMap& map) {
    double sum = 0;
    for (const auto& [xi, weight] : facet_rule(mesh::topology(map.type).shape)) {
        const auto [x, t1, t2] = map(xi);
        switch (kinematics) {
            case model::Kinematics::axisymmetric: sum += weight * std::numbers::pi * x[1] * x[1] * t1[0]; break;
            case model::Kinematics::plane_strain: sum -= weight * (x[0] * t1[1] - x[1] * t1[0]) / 2; break;
            case model::Kinematics::solid: sum -= weight * dot(x, cross(t1, t2)) / 3; break;
        }
    }
    return sum;
}

/// The share of one edge of a rim in the cone that closes it.
double cap_volume_m3(const RimEdge& edge, const Point& apex, std::span<const Point> positions) {
    FacetMap map{edge.size() == 3 ? mesh::CellType::line3 : mesh::CellType::line2, {}};
    for (std::size_t i = 0; i < edge.size(); ++i) map.nodes[i] = positions[static_cast<std::size_t>(edge[i])];
    double sum = 0;
    for (const auto& [xi, weight] : facet_rule(mesh::Shape::line)) {
        const auto [y, tangent, unused] = map(xi);
        sum += weight * dot(apex, cross(y, tangent)) / 6;
    }
    return sum;
}

/// Edges that one facet of the set has alone, in the order of the facets.
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

bool on_symmetry_plane(const model::Case& model, const RimEdge& edge, double tolerance_m) {
    for (std::size_t d = 0; d < 3; ++d)
        if (model.symmetry_planes[d] && std::all_of(edge.begin(), edge.end(), [&](Index node) {
                return std::abs(model.mesh.point(node)[d]) <= tolerance_m;
            }))
            return true;
    return false;
}

/// Mean of the rim's nodes, moved onto the symmetry planes (where the mirrored rim's mean lies).
Point apex(const model::Case& model, const std::vector<RimEdge>& rim, std::span<const Point> positions) {
    std::set<Index> nodes;
    for (const RimEdge& edge : rim) nodes.insert(edge.begin(), edge.end());
    Point mean{};
    for (const Index node : nodes)
        for (std::size_t d = 0; d < 3; ++d)
            mean[d] += positions[static_cast<std::size_t>(node)][d] / static_cast<double>(nodes.size());
    for (std::size_t d = 0; d < 3; ++d)
        if (model.symmetry_planes[d]) mean[d] = 0;
    return mean;
}

}  // namespace

double extent_m(const mesh::Mesh& mesh) {
    double largest = 0;
    for (std::size_t d = 0; d < 3 && !mesh.points.empty(); ++d) {
        const auto [low, high] = std::minmax_element(mesh.points.begin(), mesh.points.end(),
                                                     [d](const Point& a, const Point& b) { return a[d] < b[d]; });
        largest = std::max(largest, (*high)[d] - (*low)[d]);
    }
    return largest;
}

std::vector<std::vector<RimEdge>> rims(const model::Case& model, std::span<const mesh::Facet> facets) {
    const double tolerance_m = plane_tolerance * extent_m(model.mesh);
    std::vector<RimEdge> edges = free_edges(model.mesh, facets);
    std::erase_if(edges, [&](const RimEdge& edge) { return on_symmetry_plane(model, edge, tolerance_m); });

    // chains grow by relabelling: rims have tens of edges, openings are few
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

double enclosed_volume_m3(const model::Case& model, std::span<const mesh::Facet> facets,
                          std::span<const Point> positions) {
    double volume = 0;
    for (const mesh::Facet& facet : facets)
        volume += facet_volume_m3(model.kinematics, facet_map(model.mesh, facet, positions));
    if (model.kinematics == model::Kinematics::solid)
        for (const auto& rim : rims(model, facets)) {
            const Point c = apex(model, rim, positions);
            for (const RimEdge& edge : rim) volume += cap_volume_m3(edge, c, positions);
        }
    return volume / model.model_fraction;
}

std::vector<mesh::Facet> cavity_facets(const model::Case& model, const model::Cavity& cavity) {
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

}  // namespace soft::surface
