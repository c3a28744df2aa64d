#include "contact/features.hpp"

#include <algorithm>

namespace soft::contact {

namespace {

struct Edge {
    std::array<std::size_t, 2> corners;  // ascending
    std::size_t facet, k;                // the first that has it
    int facets = 0;
    Vector3 normal{};
};

struct Corner {
    std::size_t number, facet, k;
    int facets = 0, edges = 0;
    Vector3 normal{};
};

/// The element with this key, appended if it is new.
template <class Element, class Key>
Element& element_of(std::vector<Element>& list, Key Element::*key, const Element& made) {
    const auto known = std::ranges::find(list, made.*key, key);
    return known != list.end() ? *known : list.emplace_back(made);
}

/// Gives facets that are connected by corners the same group.
void find_groups(const ContactSurface& surface, std::vector<Feature>& facets) {
    const auto share_a_corner = [&](const Feature& a, const Feature& b) {
        const auto &ours = surface.entries()[a.facet].corners, &theirs = surface.entries()[b.facet].corners;
        return std::ranges::find_first_of(ours, theirs) != ours.end();
    };
    for (std::size_t i = 0; i < facets.size(); ++i) facets[i].group = i;
    for (std::size_t i = 0; i < facets.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            if (facets[i].group == facets[j].group || !share_a_corner(facets[i], facets[j])) continue;
            const std::size_t from = facets[j].group, to = facets[i].group;
            for (Feature& facet : facets)
                if (facet.group == from) facet.group = to;
        }
}

std::size_t group_of(const std::vector<Feature>& features, std::size_t facet) {
    return std::ranges::find(features, facet, &Feature::facet)->group;
}

/// The normal of the edge or corner on which the closest point of a feature lies.
Vector3 boundary_normal(const ContactSurface& surface, std::span<const Patch> patches, const Feature& feature,
                        std::span<const Edge> edges, std::span<const Corner> corners) {
    const auto& numbers = surface.entries()[feature.facet].corners;
    const mesh::CellType type = patches[feature.facet].type;
    if (feature.closest.free == 1) {
        const auto [first, last] = edge_corners(type, feature.closest.edge);
        std::array<std::size_t, 2> key{numbers[first], numbers[last]};
        std::ranges::sort(key);
        return std::ranges::find(edges, key, &Edge::corners)->normal;
    }
    const auto& nodes = mesh::topology(type).nodes;
    std::size_t corner = 0;
    for (std::size_t k = 0; k < numbers.size(); ++k)
        if (nodes[k][0] == feature.closest.xi[0] && nodes[k][1] == feature.closest.xi[1]) corner = k;
    return std::ranges::find(corners, numbers[corner], &Corner::number)->normal;
}

}  // namespace

std::vector<Feature> features_near(const ContactSurface& surface, std::span<const Patch> patches,
                                   std::span<const NearFacet> facets, const mesh::Point& x) {
    std::vector<Feature> features;
    std::vector<Edge> edges;
    std::vector<Corner> corners;
    for (const auto& [j, closest] : facets) {
        const auto& map = patches[j];
        const auto& numbers = surface.entries()[j].corners;
        Feature facet{Feature::Kind::facet, j, 0, closest};
        facet.normal = unit_normal(map, facet.closest.xi);
        features.push_back(facet);
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            const auto& nodes = mesh::topology(map.type).nodes;
            Corner& corner = element_of(corners, &Corner::number, Corner{numbers[k], j, k});
            ++corner.facets;
            corner.normal = along(corner.normal, 1, unit_normal(map, {nodes[k][0], nodes[k][1]}));
            if (mesh::dimension(map.type) < 2) continue;
            const auto [first, last] = edge_corners(map.type, k);
            std::array<std::size_t, 2> key{numbers[first], numbers[last]};
            std::ranges::sort(key);
            Edge& edge = element_of(edges, &Edge::corners, Edge{key, j, k});
            ++edge.facets;
            edge.normal = along(edge.normal, 1, unit_normal(map, closest_on_edge(map, k, x).xi));
        }
    }
    find_groups(surface, features);
    const auto closest = std::ranges::min_element(features, {}, [](const Feature& f) { return f.closest.distance_m; });
    if (closest != features.end()) closest->is_closest = true;
    // A facet whose closest point is on its boundary lies on the same side as that edge or corner.
    for (Feature& facet : features)
        if (!facet.closest.is_interior) facet.normal = boundary_normal(surface, patches, facet, edges, corners);
    for (const Edge& edge : edges) {
        if (edge.facets < 2) continue;
        for (Corner& corner : corners)
            if (std::ranges::find(edge.corners, corner.number) != edge.corners.end()) ++corner.edges;
        features.push_back({Feature::Kind::edge, edge.facet, edge.k, closest_on_edge(patches[edge.facet], edge.k, x),
                            1.0 - edge.facets, edge.normal, false, group_of(features, edge.facet)});
        auto& feature = features.back();
        if (feature.closest.free == 0) feature.normal = boundary_normal(surface, patches, feature, edges, corners);
    }
    for (const Corner& corner : corners)
        if (const double coefficient = 1 - corner.facets + corner.edges; coefficient != 0)
            features.push_back({Feature::Kind::corner, corner.facet, corner.k,
                                at_corner(patches[corner.facet], corner.k, x), coefficient, corner.normal, false,
                                group_of(features, corner.facet)});
    return features;
}

}  // namespace soft::contact
