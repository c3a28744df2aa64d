#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "contact/signed_distance.hpp"
#include "geometry/obstacle.hpp"
#include "geometry/obstacle_points.hpp"
#include "mesh/cell_map.hpp"
#include "mesh/locate.hpp"
#include "surface/free_facets.hpp"
#include "surface/near.hpp"
#include "surface/triangles.hpp"

namespace soft::geometry {
namespace {

using mesh::Point;

/// A facet as a curved surface.
struct Facet {
    mesh::Facet facet;
    mesh::CellType type;
    std::vector<Point> nodes;
};

Point position(const Facet& facet, const std::vector<mesh::ShapeValue>& shapes) {
    Point p{};
    for (std::size_t a = 0; a < facet.nodes.size(); ++a) p = along(p, shapes[a].value, facet.nodes[a]);
    return p;
}

bool is_in_reference(mesh::CellType type, double x, double y) {
    const bool triangle = mesh::topology(type).shape == mesh::Shape::triangle;
    return triangle ? x >= 0 && y >= 0 && x + y <= 1 : std::abs(x) <= 1 && std::abs(y) <= 1;
}

/// Reference coordinates of the closest point of the facet, by a search that halves its step: no derivatives, so that it is safe at
/// the borders of the reference cell.
std::array<double, 3> closest_on(const Facet& facet, const Point& from) {
    constexpr double first_step = 0.25, last_step = 1e-8;  // the distance is quadratic about its minimum
    std::array<double, 3> xi = mesh::reference_centre(facet.type);
    const auto distance_at = [&](const std::array<double, 3>& at) {
        return norm(difference(position(facet, mesh::shape_values(facet.type, at)), from));
    };
    double best = distance_at(xi);
    const bool line = mesh::topology(facet.type).dimension == 1;
    for (double step = first_step; step > last_step;) {
        std::array<double, 3> next = xi;
        for (int i = -1; i <= 1; ++i)
            for (int j = line ? 0 : -1; j <= (line ? 0 : 1); ++j) {
                const std::array<double, 3> tried{xi[0] + i * step, xi[1] + j * step, 0};
                if (!is_in_reference(facet.type, tried[0], tried[1])) continue;
                if (const double distance = distance_at(tried); distance < best) {
                    best = distance;
                    next = tried;
                }
            }
        if (next == xi) step /= 2;
        xi = next;
    }
    return xi;
}

/// The free surface of the actuator.
class FreeSurface {
public:
    explicit FreeSurface(const model::Case& model) : model_(model) {
        for (const mesh::Facet& facet : surface::free_facets(model)) {
            Facet& own = facets_.emplace_back(Facet{facet, mesh::facet_type(model.mesh, facet), {}});
            for (const mesh::Index node : mesh::facet_nodes(model.mesh, facet))
                own.nodes.push_back(model.mesh.point(node));
        }
        if (model.mesh.dimension == 3)
            add_triangles();
        else
            add_segments();
    }

    /// Nodes and quadrature points.
    [[nodiscard]] std::vector<Point> samples() const {
        std::vector<Point> points;
        for (const Facet& facet : facets_) {
            points.insert(points.end(), facet.nodes.begin(), facet.nodes.end());
            for (const mesh::QuadraturePoint& point : mesh::volume_rule(facet.type))
                points.push_back(position(facet, mesh::shape_values(facet.type, point.xi)));
        }
        return points;
    }

    /// Signed distance of a point, negative in the rubber, and the closest point.
    struct Closest {
        double distance_m;
        Point at;
    };
    [[nodiscard]] Closest closest(const Point& from) const {
        const Facet& facet = facets_[nearest_facet(from).facet];
        const auto shapes = mesh::shape_values(facet.type, closest_on(facet, from));
        const Point at = position(facet, shapes);
        const Vector3 to = difference(from, at);
        const bool behind = dot(to, mesh::facet_normal(model_.mesh, facet.facet, shapes)) < 0;
        // At a sharp edge of the actuator the normal of one facet does not decide.
        const bool inside = behind && mesh::locate(model_.mesh, from);
        return {inside ? -norm(to) : norm(to), at};
    }

    /// Longest side of the facet at a point of the surface, without its part along a unit vector, which may be 0.
    [[nodiscard]] double side_m(const Point& at, const Vector3& axis) const {
        const Facet& facet = facets_[nearest_facet(at).facet];
        const auto corners = static_cast<std::size_t>(mesh::topology(facet.type).vertex_count);
        double longest = 0;
        for (std::size_t a = 0; a < corners; ++a) {
            const Vector3 side = difference(facet.nodes[(a + 1) % corners], facet.nodes[a]);
            longest = std::max(longest, norm(along(side, -dot(side, axis), axis)));
        }
        return longest;
    }

    /// Those of the points that are deepest in the flat facets: the search on the curved facets is slow.
    [[nodiscard]] std::vector<OwnPoint> nearest(std::vector<OwnPoint> points) const {
        constexpr std::size_t enough = 100;
        std::vector<std::pair<double, OwnPoint>> ranked;
        for (const OwnPoint& own : points) ranked.emplace_back(flat_distance_m(own.point) - own.radius_m, own);
        std::ranges::stable_sort(ranked, {}, [](const auto& entry) { return entry.first; });
        points.clear();
        for (const auto& [depth, own] : ranked)
            if (points.size() < enough) points.push_back(own);
        return points;
    }

private:
    void add_triangles() {
        const surface::Triangles all = surface::facet_triangles(model_.mesh, free_facets());
        std::vector<std::array<int, 3>> triangles;
        for (std::size_t t = 0; t < all.triangles.size(); ++t) {
            const auto& [a, b, c] = all.triangles[t];
            const auto at = [&](int point) { return all.points[static_cast<std::size_t>(point)]; };
            if (norm(cross(difference(at(b), at(a)), difference(at(c), at(a)))) == 0) continue;
            triangles.push_back(all.triangles[t]);
            facet_of_.push_back(static_cast<std::size_t>(all.facets[t]));
        }
        triangles_.emplace(all.points, triangles);
    }
    void add_segments() {
        std::vector<Point> points;
        std::vector<std::array<int, 2>> segments;
        for (std::size_t f = 0; f < facets_.size(); ++f) {
            const std::vector<Point>& nodes = facets_[f].nodes;  // the ends, then the middle
            const int first = static_cast<int>(points.size());
            points.insert(points.end(), nodes.begin(), nodes.end());
            if (nodes.size() > 2)
                segments.insert(segments.end(), {{first, first + 2}, {first + 2, first + 1}});
            else
                segments.push_back({first, first + 1});
            facet_of_.resize(segments.size(), f);
        }
        segments_.emplace(points, segments);
    }
    [[nodiscard]] std::vector<mesh::Facet> free_facets() const {
        std::vector<mesh::Facet> all;
        for (const Facet& facet : facets_) all.push_back(facet.facet);
        return all;
    }
    struct Nearest {
        std::size_t facet;
        double distance_m;  ///< from the flat facet
    };
    [[nodiscard]] Nearest nearest_facet(const Point& from) const {
        const auto of = [&](const auto& found) {
            return Nearest{facet_of_[static_cast<std::size_t>(found.element)], found.distance_m};
        };
        return triangles_ ? of((*triangles_)(from)) : of((*segments_)(from));
    }
    /// With the sign of the normal in the middle of the nearest facet.
    [[nodiscard]] double flat_distance_m(const Point& from) const {
        const Nearest nearest = nearest_facet(from);
        const Facet& facet = facets_[nearest.facet];
        const auto shapes = mesh::shape_values(facet.type, mesh::reference_centre(facet.type));
        const Vector3 to = difference(from, position(facet, shapes)),
                      normal = mesh::facet_normal(model_.mesh, facet.facet, shapes);
        return dot(to, normal) < 0 ? -nearest.distance_m : nearest.distance_m;
    }

    const model::Case& model_;
    std::vector<Facet> facets_;
    std::vector<std::size_t> facet_of_;  // of each triangle or segment
    std::optional<surface::NearestOnTriangles> triangles_;
    std::optional<surface::NearestOnSegments> segments_;
};

ObstacleGap gap_of(const model::Obstacle& obstacle, const model::Case& model, const FreeSurface& surface,
                   std::span<const Point> samples) {
    const contact::SignedDistance distance = contact::signed_distance(obstacle);
    ObstacleGap gap{obstacle.name, std::numeric_limits<double>::infinity(), {}};
    const auto take = [&](double gap_m, const Point& at) {
        if (gap_m >= gap.gap_m) return;
        gap.gap_m = gap_m;
        gap.at = at;
    };
    constexpr double asymmetry = 1e-3;  // of the facets of a symmetric obstacle
    const double allowed_m = asymmetry * mesh::extent_m(model.mesh);
    for (const Point& point : samples) {
        const double distance_m = distance(point);
        take(distance_m, point);
        for (std::size_t i = 0; i < 3; ++i) {
            if (!model.symmetry_planes[i] || gap.wrong_side) continue;
            Point image = point;
            image[i] = -image[i];
            if (distance(image) < distance_m - allowed_m) gap.wrong_side = i;
        }
    }
    for (const OwnPoint& own : surface.nearest(own_points(obstacle, model))) {
        const FreeSurface::Closest closest = surface.closest(own.point);
        take(closest.distance_m - own.radius_m, closest.at);
    }
    const auto* cylinder = std::get_if<model::Cylinder>(&obstacle.shape);
    gap.cell_m = surface.side_m(gap.at, cylinder ? cylinder->axis : Vector3{});
    return gap;
}

}  // namespace

std::vector<ObstacleGap> obstacle_gaps(const model::Case& model) {
    std::vector<ObstacleGap> gaps;
    if (model.obstacles.empty()) return gaps;
    const FreeSurface surface(model);
    const std::vector<Point> samples = surface.samples();
    for (const model::Obstacle& obstacle : model.obstacles) gaps.push_back(gap_of(obstacle, model, surface, samples));
    return gaps;
}

}  // namespace soft::geometry
