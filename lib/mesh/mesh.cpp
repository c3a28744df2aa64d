#include "mesh/mesh.hpp"

#include <algorithm>
#include <limits>

namespace soft::mesh {
namespace {

/// The corners of a facet in ascending order, so that the two cells that share the facet have the same key.
using CornerKey = std::array<Index, 4>;

CornerKey corner_key(std::span<const Index> cell, const FacetTopology& facet) {
    CornerKey key;
    key.fill(std::numeric_limits<Index>::max());
    const int corners = topology(facet.type).vertex_count;
    for (int i = 0; i < corners; ++i) key[i] = cell[facet.nodes[i]];
    std::sort(key.begin(), key.end());  // unused entries stay last
    return key;
}

const FacetTopology& facet_topology(const Mesh& mesh, const Facet& facet) {
    return topology(mesh.cell_type(facet.cell)).facets[static_cast<std::size_t>(facet.local)];
}

}  // namespace

std::vector<Index> facet_nodes(const Mesh& mesh, const Facet& facet) {
    const FacetTopology& side = facet_topology(mesh, facet);
    const auto cell = mesh.cell_nodes(facet.cell);
    std::vector<Index> nodes(static_cast<std::size_t>(node_count(side.type)));
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i] = cell[side.nodes[i]];
    return nodes;
}

CellType facet_type(const Mesh& mesh, const Facet& facet) { return facet_topology(mesh, facet).type; }

std::vector<Index> facet_corners(const Mesh& mesh, const Facet& facet) {
    std::vector<Index> nodes = facet_nodes(mesh, facet);
    nodes.resize(static_cast<std::size_t>(topology(facet_type(mesh, facet)).vertex_count));
    return nodes;
}

std::vector<Index> drop_unused_points(Mesh& mesh) {
    constexpr Index unused = -1;
    std::vector<Index> numbers(mesh.points.size(), unused);
    const auto at = [](Index point) { return static_cast<std::size_t>(point); };
    for (const Index node : mesh.connectivity) numbers[at(node)] = node;
    std::vector<Point> kept;
    for (std::size_t p = 0; p < numbers.size(); ++p) {
        if (numbers[p] == unused) continue;
        numbers[p] = static_cast<Index>(kept.size());
        kept.push_back(mesh.points[p]);
    }
    mesh.points = std::move(kept);
    for (Index& node : mesh.connectivity) node = numbers[at(node)];
    for (auto& [name, points] : mesh.point_sets) {
        for (Index& point : points) point = numbers[at(point)];
        std::erase(points, unused);
    }
    return numbers;
}

std::int32_t region_number(Mesh& mesh, const std::string& name) {
    auto found = std::ranges::find(mesh.region_names, name);
    if (found == mesh.region_names.end()) found = mesh.region_names.insert(found, name);
    return static_cast<std::int32_t>(found - mesh.region_names.begin());
}

const std::string& region_name(const Mesh& mesh, Index cell) {
    return mesh.region_names[static_cast<std::size_t>(mesh.cell_regions[static_cast<std::size_t>(cell)])];
}

std::vector<Facet> boundary_facets(const Mesh& mesh) {
    struct Side {
        CornerKey key;
        Facet facet;
    };
    std::vector<Side> sides;
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        int local = 0;
        for (const FacetTopology& facet : topology(mesh.cell_type(c)).facets)
            sides.push_back({corner_key(mesh.cell_nodes(c), facet), {c, local++}});
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.key < b.key; });
    std::vector<Facet> boundary;
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t end = i + 1;
        while (end < sides.size() && sides[end].key == sides[i].key) ++end;
        if (end == i + 1) boundary.push_back(sides[i].facet);
        i = end;
    }
    std::sort(boundary.begin(), boundary.end());
    return boundary;
}

double extent_m(const Mesh& mesh) {
    double largest = 0;
    for (std::size_t d = 0; d < 3 && !mesh.points.empty(); ++d) {
        const auto [low, high] = std::minmax_element(mesh.points.begin(), mesh.points.end(),
                                                     [d](const Point& a, const Point& b) { return a[d] < b[d]; });
        largest = std::max(largest, (*high)[d] - (*low)[d]);
    }
    return largest;
}

std::vector<double> by_component(std::span<const Point> points, std::span<const Index> nodes, int dimension) {
    std::vector<double> x;
    x.reserve(nodes.size() * static_cast<std::size_t>(dimension));
    for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i)
        for (const Index node : nodes) x.push_back(points[static_cast<std::size_t>(node)][i]);
    return x;
}

void add_cell(Mesh& mesh, CellType type, std::span<const Index> nodes, std::int32_t region) {
    mesh.cell_types.push_back(type);
    mesh.connectivity.insert(mesh.connectivity.end(), nodes.begin(), nodes.end());
    mesh.offsets.push_back(static_cast<Index>(mesh.connectivity.size()));
    mesh.cell_regions.push_back(region);
}

}  // namespace soft::mesh
