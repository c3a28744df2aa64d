#include "contact/signed_distance.hpp"

#include <cmath>
#include <memory>

#include "surface/cgal_queries.hpp"
#include "surface/near.hpp"

namespace soft::contact {
namespace {

using mesh::Point;
using DistanceWithGradient = std::function<Distance(const Point&)>;

/// From the closest point of a facet, on whose other side the obstacle is if `inside`. On the surface the gradient is the facet's normal.
template <class Closest>
Distance from(const model::FacetedSurface& faceted, const Closest& closest, const Point& point, bool inside) {
    const Vector3 normal = model::facet_normal(faceted, faceted.facets[static_cast<std::size_t>(closest.element)]);
    constexpr double on_the_surface = 1e-9;  // of the facet: closer, the direction is lost in rounding
    const double length = norm(normal), size_m = faceted.facets.front()[2] < 0 ? length : std::sqrt(length);
    if (closest.distance_m <= on_the_surface * size_m) return {0, along({}, 1 / length, normal), {}};
    const double sign = inside ? -1 : 1;
    return {sign * closest.distance_m, along({}, sign / closest.distance_m, difference(point, closest.point)), {}};
}

/// Whether a line upward from the point crosses the closed section an odd number of times. Edges on the axis r = 0, which are not
/// part of the section, are below all points.
bool is_in_section(const model::FacetedSurface& section, const Point& point) {
    bool inside = false;
    for (const auto& [start, end, none] : section.facets) {
        const Point &a = section.points[static_cast<std::size_t>(start)],
                    &b = section.points[static_cast<std::size_t>(end)];
        if ((a[0] > point[0]) == (b[0] > point[0])) continue;
        if (a[1] + (point[0] - a[0]) / (b[0] - a[0]) * (b[1] - a[1]) > point[1]) inside = !inside;
    }
    return inside;
}

DistanceWithGradient distance_of_section(const model::FacetedSurface& section) {
    std::vector<std::array<int, 2>> segments;
    for (const auto& facet : section.facets) segments.push_back({facet[0], facet[1]});
    const auto nearest = std::make_shared<surface::NearestOnSegments>(section.points, segments);
    return [section, nearest](const Point& point) {
        const auto closest = (*nearest)(point);
        return from(section, closest, point, is_in_section(section, point));
    };
}

/// The first triangle that a ray meets has its back to a point inside.
DistanceWithGradient distance_of_triangles(const model::FacetedSurface& faceted) {
    surface::Triangles triangles{faceted.points, faceted.facets, {}, {}, {}};
    for (std::size_t t = 0; t < faceted.facets.size(); ++t) triangles.facets.push_back(static_cast<int>(t));
    const auto rays = std::make_shared<surface::RayTree>(triangles);
    const auto nearest = std::make_shared<surface::NearestOnTriangles>(faceted.points, faceted.facets);
    return [faceted, rays, nearest](const Point& point) {
        // Parallel to no likely edge, and nearly across z, so that it does not leave an extruded profile through an end.
        constexpr Vector3 direction{0.79864838, 0.60099281, 0.03124521};
        constexpr int no_facet = -1;
        const auto closest = (*nearest)(point);
        const auto hit = rays->first_hit(point, direction, no_facet);
        const bool inside =
            hit &&
            dot(model::facet_normal(faceted, faceted.facets[static_cast<std::size_t>(hit->facet)]), direction) > 0;
        return from(faceted, closest, point, inside);
    };
}

template <class Shape>
DistanceWithGradient distance_of(const Shape& shape) {
    return [shape](const Point& point) { return distance(shape, point); };
}

DistanceWithGradient distance_of(const model::FacetedSurface& faceted) {
    return faceted.facets.front()[2] < 0 ? distance_of_section(faceted) : distance_of_triangles(faceted);
}

}  // namespace

DistanceWithGradient distance_with_gradient(const model::Obstacle& obstacle) {
    return std::visit([](const auto& shape) { return distance_of(shape); }, obstacle.shape);
}

SignedDistance signed_distance(const model::Obstacle& obstacle) {
    return [distance = distance_with_gradient(obstacle)](const Point& point) { return distance(point).value_m; };
}

}  // namespace soft::contact
