#include "contact/hinges.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "surface/facet_map.hpp"

namespace soft::contact {
namespace {

using mesh::Facet;
using mesh::Index;
using Ends = std::array<Index, 2>;

/// The corners of a facet of a section, or the edges of a facet of a solid; empty for facets with repeated nodes.
std::vector<Ends> borders(const mesh::Mesh& mesh, const Facet& facet) {
    const mesh::CellTopology& type = mesh::topology(mesh::facet_type(mesh, facet));
    const std::vector<Index> nodes = mesh::facet_nodes(mesh, facet);
    const auto count = static_cast<std::size_t>(type.vertex_count);
    if (std::set<Index>(nodes.begin(), nodes.end()).size() != nodes.size()) return {};
    std::vector<Ends> all;
    for (std::size_t i = 0; i < count; ++i) {
        const Index a = nodes[i], b = mesh.dimension == 2 ? a : nodes[(i + 1) % count];
        all.push_back({std::min(a, b), std::max(a, b)});
    }
    return all;
}

/// Reference coordinates of the midpoint of the ends on a facet; empty if not both ends are its corners.
std::vector<surface::FacetPoint> middle_on(const mesh::Mesh& mesh, const Facet& facet, const Ends& ends) {
    const mesh::CellTopology& type = mesh::topology(mesh::facet_type(mesh, facet));
    const std::vector<Index> nodes = mesh::facet_nodes(mesh, facet);
    surface::FacetPoint middle{};
    for (const Index end : ends) {
        const auto found = std::find(nodes.begin(), nodes.begin() + type.vertex_count, end);
        if (found == nodes.begin() + type.vertex_count) return {};
        const auto& xi = type.nodes[static_cast<std::size_t>(found - nodes.begin())];
        for (std::size_t d = 0; d < 2; ++d) middle[d] += xi[d] / 2;
    }
    return {middle};
}

/// Outward unit normals, at the middle of the hinge, of the facets of a cell that share the hinge.
std::vector<Vector3> normals_at(const mesh::Mesh& mesh, Index cell, const Ends& ends,
                                std::span<const mesh::Point> positions) {
    std::vector<Vector3> normals;
    const int sides = static_cast<int>(mesh::topology(mesh.cell_type(cell)).facets.size());
    for (int local = 0; local < sides; ++local)
        for (const surface::FacetPoint& xi : middle_on(mesh, {cell, local}, ends)) {
            const surface::FacetMap::Value at = surface::facet_map(mesh, {cell, local}, positions)(xi);
            const Vector3 n = cross(at.t1, at.t2);
            const double length = norm(n);
            normals.push_back({n[0] / length, n[1] / length, n[2] / length});
        }
    return normals;
}

}  // namespace

std::vector<Hinge> hinges(const mesh::Mesh& mesh, std::span<const Facet> facets) {
    std::map<Ends, std::vector<int>> meeting;
    for (std::size_t f = 0; f < facets.size(); ++f)
        for (const Ends& ends : borders(mesh, facets[f])) meeting[ends].push_back(static_cast<int>(f));
    std::map<Index, std::vector<Index>> cells_at;
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
        const auto nodes = mesh.cell_nodes(cell);
        for (int v = 0; v < mesh::topology(mesh.cell_type(cell)).vertex_count; ++v)
            cells_at[nodes[static_cast<std::size_t>(v)]].push_back(cell);
    }
    std::vector<Hinge> result;
    for (const auto& [ends, members] : meeting) {
        if (members.size() != 2) continue;
        Hinge hinge{{members[0], members[1]}, ends, {}};
        const std::vector<Index>&first = cells_at[ends[0]], &second = cells_at[ends[1]];
        std::set_intersection(first.begin(), first.end(), second.begin(), second.end(),
                              std::back_inserter(hinge.cells));
        const bool sound = std::all_of(hinge.cells.begin(), hinge.cells.end(), [&](Index cell) {
            return normals_at(mesh, cell, ends, mesh.points).size() == 2;
        });
        if (sound) result.push_back(std::move(hinge));
    }
    return result;
}

double filled_angle(const mesh::Mesh& mesh, const Hinge& hinge, std::span<const mesh::Point> positions) {
    double sum = 0;
    for (const Index cell : hinge.cells) {
        const std::vector<Vector3> n = normals_at(mesh, cell, hinge.vertices, positions);
        sum += std::numbers::pi - std::acos(std::clamp(dot(n[0], n[1]), -1.0, 1.0));
    }
    return sum;
}

}  // namespace soft::contact
