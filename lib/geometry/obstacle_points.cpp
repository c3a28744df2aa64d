#include "geometry/obstacle_points.hpp"

#include <algorithm>
#include <cmath>

#include "surface/free_facets.hpp"

namespace soft::geometry {
namespace {

using mesh::Point;

/// Bounding box of the mesh.
struct Bounds {
    Point low, high;
    [[nodiscard]] bool contains(const Point& point) const {
        for (std::size_t i = 0; i < 3; ++i)
            if (point[i] < low[i] || point[i] > high[i]) return false;
        return true;
    }
};

Bounds bounds_of(const mesh::Mesh& mesh) {
    Bounds bounds{mesh.points.front(), mesh.points.front()};
    for (const Point& point : mesh.points)
        for (std::size_t i = 0; i < 3; ++i) {
            bounds.low[i] = std::min(bounds.low[i], point[i]);
            bounds.high[i] = std::max(bounds.high[i], point[i]);
        }
    return bounds;
}

/// Where axes pass that are at most this radius beside the actuator.
Bounds grown(Bounds bounds, double radius_m) {
    for (std::size_t i = 0; i < 3; ++i) {
        bounds.low[i] -= radius_m;
        bounds.high[i] += radius_m;
    }
    return bounds;
}

/// Points at equal distances on a line, within the bounds.
void add_line(const Point& start, const Vector3& step, const Bounds& bounds, double radius_m,
              std::vector<OwnPoint>& points) {
    double first = 0, last = 1;
    for (std::size_t i = 0; i < 3; ++i) {
        if (step[i] == 0) continue;
        const double a = (bounds.low[i] - start[i]) / step[i], b = (bounds.high[i] - start[i]) / step[i];
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    constexpr int count = 100;
    for (int k = 0; k <= count && first <= last; ++k) {
        const Point point = along(start, first + k * (last - first) / count, step);
        if (bounds.contains(point)) points.push_back({point, radius_m});
    }
}

using Points = std::vector<OwnPoint>;

Points points_of(const model::Plane&, const Bounds&) { return {}; }

Points points_of(const model::Sphere& sphere, const Bounds&) {
    if (sphere.side == model::Side::inside) return {};
    return {{sphere.center, sphere.radius_m}};
}

Points points_of(const model::Cylinder& cylinder, const Bounds& bounds) {
    if (cylinder.side == model::Side::inside) return {};
    const double far_m = norm(difference(bounds.high, bounds.low)) + norm(difference(cylinder.point, bounds.low));
    if (bounds.low[2] == bounds.high[2] && cylinder.axis[2] != 0) return {{cylinder.point, cylinder.radius_m}};
    Points points;
    Vector3 step = cylinder.axis;
    for (double& component : step) component *= 2 * far_m;
    add_line(along(cylinder.point, -far_m, cylinder.axis), step, grown(bounds, cylinder.radius_m), cylinder.radius_m,
             points);
    return points;
}

/// Along the edges.
Points points_of(const model::Box& box, const Bounds& bounds) {
    Points points;
    const bool is_section = bounds.low[2] == bounds.high[2];
    for (std::size_t d = 0; d < (is_section ? 2 : 3); ++d)
        for (const bool second : {false, true})
            for (const bool third : {false, true}) {
                Point start{};
                for (std::size_t i = 0; i < 3; ++i) {
                    const bool is_high = i == (d + 1) % 3 ? second : i == (d + 2) % 3 && third;
                    start[i] = is_high ? box.high[i] - box.radius_m : box.low[i] + box.radius_m;
                }
                if (is_section) start[2] = bounds.low[2];
                Vector3 step{};
                step[d] = box.high[d] - box.low[d] - 2 * box.radius_m;
                add_line(start, step, grown(bounds, box.radius_m), box.radius_m, points);
            }
    return points;
}

Points points_of(const model::FacetedSurface& faceted, const Bounds& bounds) {
    Points points;
    const double long_m = norm(difference(bounds.high, bounds.low)) / 100;
    for (const auto& facet : faceted.facets)
        for (std::size_t i = 0; i < 3 && facet[i] >= 0; ++i) {
            const int next = facet[(i + 1) % 3] >= 0 ? facet[(i + 1) % 3] : facet[0];
            const Point& start = faceted.points[static_cast<std::size_t>(facet[i])];
            const Vector3 edge = difference(faceted.points[static_cast<std::size_t>(next)], start);
            if (norm(edge) > long_m && facet[i] < next)
                add_line(start, edge, bounds, 0, points);
            else if (bounds.contains(start))
                points.push_back({start, 0});
        }
    std::ranges::sort(points, {}, &OwnPoint::point);
    const auto same = std::ranges::unique(points, {}, &OwnPoint::point);
    points.erase(same.begin(), same.end());
    // A finer surface has vertices closer to each other than the nodes of the actuator, which are compared with its facets.
    constexpr std::size_t max_points = 5000;
    const std::size_t stride = 1 + points.size() / max_points;
    for (std::size_t i = 0; i * stride < points.size(); ++i) points[i] = points[i * stride];
    points.resize((points.size() + stride - 1) / stride);
    return points;
}

}  // namespace

std::vector<OwnPoint> own_points(const model::Obstacle& obstacle, const model::Case& model) {
    const Bounds bounds = bounds_of(model.mesh);
    const std::array<bool, 3> mirrored = surface::mirrors(model);
    Points points = std::visit([&](const auto& shape) { return points_of(shape, bounds); }, obstacle.shape);
    std::erase_if(points, [&](const OwnPoint& own) {
        for (std::size_t i = 0; i < 3; ++i) {
            const bool above = bounds.high[i] > -bounds.low[i];
            if (mirrored[i] && (above ? own.point[i] < 0 : own.point[i] > 0)) return true;
        }
        return false;
    });
    return points;
}

}  // namespace soft::geometry
