#include "geometry/openings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "math/vector.hpp"
#include "mesh/cell_map.hpp"
#include "model/cavity_surface.hpp"

namespace soft::geometry {
namespace {

using mesh::Index;

Vector3 area_of(const mesh::Mesh& mesh, const std::vector<model::RimEdge>& rim) {
    Vector3 area{};
    for (const model::RimEdge& edge : rim) {
        const mesh::CellType type = edge.size() == 3 ? mesh::CellType::line3 : mesh::CellType::line2;
        for (const mesh::QuadraturePoint& point : mesh::volume_rule(type)) {
            const auto shapes = mesh::shape_values(type, point.xi);
            Vector3 x{}, dx{};
            for (std::size_t a = 0; a < edge.size(); ++a)
                for (std::size_t d = 0; d < 3; ++d) {
                    x[d] += shapes[a].value * mesh.point(edge[a])[d];
                    dx[d] += shapes[a].gradient[0] * mesh.point(edge[a])[d];
                }
            for (std::size_t d = 0; d < 3; ++d) {
                const std::size_t e = (d + 1) % 3, f = (d + 2) % 3;
                area[d] += 0.5 * point.weight * (x[e] * dx[f] - x[f] * dx[e]);
            }
        }
    }
    return area;
}

/// Boundary facets next to the wall that have two corners on the rim (section: its end point).
std::vector<mesh::Facet> sides_around(const mesh::Mesh& mesh, const std::vector<mesh::Facet>& wall,
                                      const std::set<Index>& rim) {
    const std::set<mesh::Facet> own(wall.begin(), wall.end());
    const auto needed = mesh.dimension - 1;
    std::vector<mesh::Facet> around;
    for (const mesh::Facet& facet : boundary_facets(mesh)) {
        if (!own.contains(facet) &&
            std::ranges::count_if(facet_corners(mesh, facet), [&](Index n) { return rim.contains(n); }) >= needed)
            around.push_back(facet);
    }
    return around;
}

/// The smallest face that contains all of the facets.
std::string face_around(const mesh::Mesh& mesh, const std::vector<mesh::Facet>& around) {
    std::string smallest;
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    for (const auto& [name, facets] : mesh.facet_sets) {
        const std::set<mesh::Facet> set(facets.begin(), facets.end());
        if (around.empty() || facets.size() >= fewest ||
            !std::ranges::all_of(around, [&](const mesh::Facet& f) { return set.contains(f); }))
            continue;
        smallest = name;
        fewest = facets.size();
    }
    return smallest;
}

FoundOpening found(const mesh::Mesh& mesh, const std::vector<mesh::Facet>& wall, const Vector3& area,
                   const std::set<Index>& rim) {
    const double size = std::hypot(area[0], area[1], area[2]);
    FoundOpening result{{"", size, {area[0] / size, area[1] / size, area[2] / size}}, sides_around(mesh, wall, rim)};
    result.opening.face = face_around(mesh, result.around);
    return result;
}

/// Ends of the wall away from the axis. If the last facet of the wall runs towards an end with growing r, the plug lies at higher x:
/// the axial parts of wall and plugs cancel, closed integral of n dA = 0.
std::vector<FoundOpening> openings_of_section(const mesh::Mesh& mesh, const std::vector<mesh::Facet>& wall) {
    std::map<Index, int> sense;  // +1 where a facet ends, -1 where one starts; 0 where both do
    for (const mesh::Facet& facet : wall) {
        const auto nodes = facet_nodes(mesh, facet);
        --sense[nodes[0]];
        ++sense[nodes[1]];
    }
    std::vector<FoundOpening> result;
    for (const auto& [node, sign] : sense) {
        const double radius_m = mesh.point(node)[1];
        if (sign != 0 && radius_m > 0)
            result.push_back(found(mesh, wall, {sign * std::numbers::pi * radius_m * radius_m, 0, 0}, {node}));
    }
    return result;
}

}  // namespace

std::vector<FoundOpening> openings_of(const mesh::Mesh& mesh, const std::vector<mesh::Facet>& wall,
                                      model::Kinematics kinematics, const std::array<bool, 3>& mirrors) {
    if (kinematics == model::Kinematics::plane_strain) return {};
    if (kinematics == model::Kinematics::axisymmetric) return openings_of_section(mesh, wall);
    model::Case bare;
    bare.mesh = mesh;
    bare.symmetry_planes = mirrors;
    std::vector<FoundOpening> result;
    for (const auto& rim : model::rims(bare, wall)) {
        std::set<Index> corners;
        for (const model::RimEdge& edge : rim) corners.insert({edge[0], edge[1]});
        Vector3 area =
            area_of(mesh,
                    rim);  // lines along the cuts, which close the rim, add nothing to the uncancelled components
        for (std::size_t d = 0; d < 3; ++d)
            if (mirrors[d])
                for (std::size_t e = 0; e < 3; ++e) area[e] *= e == d ? 0 : 2;
        result.push_back(found(mesh, wall, area, corners));
    }
    return result;
}

}  // namespace soft::geometry
