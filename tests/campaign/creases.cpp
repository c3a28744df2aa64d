#include "creases.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "mesh/mesh.hpp"
#include "surface/free_facets.hpp"

namespace soft::campaign {
namespace {

using mesh::Index;
using mesh::Point;
using surface::FacetPoint;

/// [rad] A crease is closed if the rubber fills more than a full turn by up to this angle. It was open if the rubber filled less than that.
constexpr double max_closed_angle = 0.5;
/// [rad] Creases closer to a full turn in the undeformed model are slits and are ignored.
constexpr double min_open_angle = 1e-3;
/// Sample points on an edge; its ends also belong to other edges and are avoided.
constexpr std::array edge_samples{0.01, 0.25, 0.5, 0.75, 0.99};

/// Directions at a point of a facet's edge: the outward normal, and the direction into the facet perpendicular to the edge.
struct Side {
    Vector3 out, inward;
};

Side side_of(const surface::FacetMap& map, const FacetPoint& from, const FacetPoint& to, const FacetPoint& in,
             double s) {
    const auto at = map({from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1])});
    const auto direction = [&](const FacetPoint& xi) {
        return along({xi[0] * at.t1[0], xi[0] * at.t1[1], xi[0] * at.t1[2]}, xi[1], at.t2);
    };
    const bool line = mesh::topology(map.type).shape == mesh::Shape::line;
    const Vector3 edge = line ? at.t2 : direction({to[0] - from[0], to[1] - from[1]});
    const Vector3 inward = direction(in);
    return {cross(at.t1, at.t2), along(inward, -dot(inward, edge) / dot(edge, edge), edge)};
}

/// Angle from a facet through the rubber to the direction of another facet, in (-pi, pi]: negative beyond half a turn (minus the angle of
/// the remaining air) and positive again beyond a full turn.
double angle(const Side& side, const Vector3& other) {
    return std::atan2(-dot(side.out, other) / norm(side.out), dot(side.inward, other) / norm(side.inward));
}

}  // namespace

Creases::Creases(const model::Case& model, const std::vector<mesh::Facet>& skin) : model_(model), skin_(skin) {
    const auto mirrors = surface::mirrors(model);
    const double near_m = mesh::plane_tolerance * mesh::extent_m(model.mesh);
    std::map<std::array<Index, 2>, std::vector<EdgeSide>> meeting;
    for (std::size_t f = 0; f < skin.size(); ++f) {
        const mesh::CellTopology& type = mesh::topology(mesh::facet_type(model.mesh, skin[f]));
        const auto nodes = mesh::facet_nodes(model.mesh, skin[f]);
        const auto count = static_cast<std::size_t>(type.vertex_count);
        const bool line = type.shape == mesh::Shape::line;
        FacetPoint middle{};
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t d = 0; d < 2; ++d) middle[d] += type.nodes[i][d] / static_cast<double>(count);
        for (std::size_t i = 0; i < count; ++i) {
            std::size_t a = i, b = line ? i : (i + 1) % count;
            if (nodes[b] < nodes[a]) std::swap(a, b);  // same direction along the edge in both facets
            EdgeSide border{f, {type.nodes[a][0], type.nodes[a][1]}, {type.nodes[b][0], type.nodes[b][1]}, {}};
            for (std::size_t d = 0; d < 2; ++d) border.inward[d] = middle[d] - (border.from[d] + border.to[d]) / 2;
            meeting[{nodes[a], nodes[b]}].push_back(border);
        }
    }
    for (const auto& [ends, borders] : meeting) {
        if (borders.size() == 2) creases_.push_back({borders[0], borders[1], -1});
        for (int d = 0; d < 3; ++d)
            if (const auto k = static_cast<std::size_t>(d);
                mirrors[k] && borders.size() == 1 &&
                std::ranges::all_of(ends, [&](Index node) { return std::abs(model.mesh.point(node)[k]) <= near_m; }))
                creases_.push_back({borders[0], borders[0], d});
    }
}

double Creases::rubber_angle(const Crease& crease, double along, std::span<const Point> positions) const {
    const auto side = [&](const EdgeSide& b) {
        return side_of(surface::facet_map(model_.mesh, skin_[b.facet], positions), b.from, b.to, b.inward, along);
    };
    const Side one = side(crease.one);
    Vector3 other = crease.mirror < 0 ? side(crease.other).inward : one.inward;
    if (crease.mirror >= 0) other[static_cast<std::size_t>(crease.mirror)] *= -1;
    const double length = norm(other);
    for (double& component : other) component /= length;
    return angle(one, other);
}

bool Creases::has_closed(std::span<const Point> before, std::span<const Point> now) const {
    return std::ranges::any_of(creases_, [&](const Crease& crease) {
        return std::ranges::any_of(edge_samples, [&](double along) {
            const double is = rubber_angle(crease, along, now);
            if (!(is > 0 && is < max_closed_angle)) return false;
            const double was = rubber_angle(crease, along, before),
                         first = rubber_angle(crease, along, model_.mesh.points);
            return (was < 0 || was > std::numbers::pi - max_closed_angle) &&
                   (first < -min_open_angle || first > max_closed_angle);
        });
    });
}

}  // namespace soft::campaign
