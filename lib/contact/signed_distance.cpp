#include "contact/signed_distance.hpp"

#include <memory>

#include "contact/distance.hpp"
#include "surface/cgal_queries.hpp"
#include "surface/near.hpp"

namespace soft::contact {
namespace {

using mesh::Point;

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

SignedDistance distance_of_section(const model::FacetedSurface& section) {
    std::vector<std::array<int, 2>> segments;
    for (const auto& facet : section.facets) segments.push_back({facet[0], facet[1]});
    const auto nearest = std::make_shared<surface::NearestOnSegments>(section.points, segments);
    return [section, nearest](const Point& point) {
        const double distance_m = (*nearest)(point).distance_m;
        return is_in_section(section, point) ? -distance_m : distance_m;
    };
}

/// The first triangle that a ray meets has its back to a point inside.
SignedDistance distance_of_triangles(const model::FacetedSurface& faceted) {
    surface::Triangles triangles{faceted.points, faceted.facets, {}, {}, {}};
    for (std::size_t t = 0; t < faceted.facets.size(); ++t) triangles.facets.push_back(static_cast<int>(t));
    const auto rays = std::make_shared<surface::RayTree>(triangles);
    const auto nearest = std::make_shared<surface::NearestOnTriangles>(faceted.points, faceted.facets);
    return [faceted, rays, nearest](const Point& point) {
        // Parallel to no likely edge, and nearly across z, so that it does not leave an extruded profile through an end.
        constexpr Vector3 direction{0.79864838, 0.60099281, 0.03124521};
        constexpr int no_facet = -1;
        const double distance_m = (*nearest)(point).distance_m;
        const auto hit = rays->first_hit(point, direction, no_facet);
        if (!hit) return distance_m;
        const Vector3 normal = model::facet_normal(faceted, faceted.facets[static_cast<std::size_t>(hit->facet)]);
        return dot(normal, direction) > 0 ? -distance_m : distance_m;
    };
}

template <class Shape>
SignedDistance distance_of(const Shape& shape) {
    return [shape](const Point& point) { return distance(shape, point).value_m; };
}

SignedDistance distance_of(const model::FacetedSurface& faceted) {
    return faceted.facets.front()[2] < 0 ? distance_of_section(faceted) : distance_of_triangles(faceted);
}

}  // namespace

SignedDistance signed_distance(const model::Obstacle& obstacle) {
    return std::visit([](const auto& shape) { return distance_of(shape); }, obstacle.shape);
}

}  // namespace soft::contact
