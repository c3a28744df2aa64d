#include "meshing/body_walls.hpp"

#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "meshing/named_faces.hpp"
#include "surface/cgal_queries.hpp"
#include "surface/facet_map.hpp"

namespace soft::meshing {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Search = CGAL::Orthogonal_k_neighbor_search<CGAL::Search_traits_3<Kernel>>;

constexpr double growth = 0.5;  ///< increase of the requested size per distance

/// Evenly distributed points in a triangle: the low-discrepancy sequence of the plastic number (M. Roberts, 2018), folded into the
/// triangle.
mesh::Point point_in(const std::vector<mesh::Point>& points, const std::array<int, 3>& t, std::size_t number) {
    constexpr double g = 1.3247179572447460;
    double u = std::fmod(1.0 / 3 + static_cast<double>(number) / g, 1.0),
           v = std::fmod(1.0 / 3 + static_cast<double>(number) / (g * g), 1.0);
    if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
    }
    mesh::Point p{};
    for (std::size_t d = 0; d < 3; ++d)
        p[d] = (1 - u - v) * points[static_cast<std::size_t>(t[0])][d] + u * points[static_cast<std::size_t>(t[1])][d] +
               v * points[static_cast<std::size_t>(t[2])][d];
    return p;
}

}  // namespace

std::vector<Wall> walls(const std::vector<mesh::Point>& points, const std::vector<std::array<int, 3>>& triangles) {
    constexpr double sample_count = 20000;  // takes a few seconds; a bellows of 100 mm has one sample every 2 mm
    constexpr double min_cosine = 0.5;
    surface::Triangles surface{points, triangles, {}, points, {}};
    std::vector<TriangleGeometry> facets;
    double area = 0;
    for (const auto& t : triangles) {
        surface.facets.push_back(static_cast<int>(facets.size()));
        facets.push_back(triangle_geometry(points, t));
        area += facets.back().area;
    }
    const surface::RayTree tree(surface);
    std::vector<Wall> found;
    double share = 0;  // fraction of a sample carried over from the previous facets
    for (std::size_t f = 0; f < facets.size(); ++f) {
        const TriangleGeometry& facet = facets[f];
        share += sample_count * facet.area / area;
        const Vector3 inward{-facet.normal[0], -facet.normal[1], -facet.normal[2]};
        for (std::size_t number = 0; share >= 0.5; share -= 1, ++number) {
            const mesh::Point location = point_in(points, triangles[f], number);
            const auto hit = tree.first_hit(location, inward, static_cast<int>(f));
            if (hit && dot(facets[static_cast<std::size_t>(hit->facet)].normal, inward) >= min_cosine)
                found.push_back({location, hit->distance_m});
        }
    }
    return found;
}

std::vector<Bend> bends(const BodySurface& surface) {
    std::vector<TriangleGeometry> facets;
    for (const auto& t : surface.triangles) facets.push_back(triangle_geometry(surface.points, t));
    constexpr double max_samples = 200;  // per edge: CAD exports have edges as long as a cylinder
    std::vector<Bend> found;
    for (const auto& [edge, sides] : edges_with_sides(surface)) {
        const TriangleGeometry &one = facets[sides[0]], &other = facets[sides[1]];
        const double angle = std::atan2(norm(cross(one.normal, other.normal)), dot(one.normal, other.normal));
        const mesh::Point &a = surface.points[static_cast<std::size_t>(edge[0])],
                          &b = surface.points[static_cast<std::size_t>(edge[1])];
        const double length = norm(along(b, -1, a)), turn = length * angle;
        if (angle >= sharp_rad || !(turn > 0)) continue;
        const double radius = (one.area + other.area) / turn;
        const int samples = static_cast<int>(std::clamp(std::ceil(length / radius), 1.0, max_samples));
        for (int k = 0; k < samples; ++k) found.push_back({along(a, (k + 0.5) / samples, along(b, -1, a)), radius});
    }
    return found;
}

WallStatistics wall_statistics(std::vector<Wall> walls) {
    std::ranges::sort(walls, {}, [](const Wall& wall) { return std::pair(wall.thickness_m, wall.location); });
    return {walls.front(), walls[walls.size() / 2].thickness_m};
}

/// Walls of about the same size share a search tree; the nearest wall of each tree determines the size.
struct WallSizes::Classes {
    double max_m = 0;
    std::map<int, std::unique_ptr<Search::Tree>> trees;  ///< size = max_m / step^number
    static constexpr double step = 1.1;
};

WallSizes::WallSizes(const std::vector<Wall>& walls, const std::vector<Bend>& bends, const SizeBounds& bounds) {
    auto classes = std::make_shared<Classes>();
    classes->max_m = bounds.max_m;
    const auto add = [&](const mesh::Point& location, double requested_m) {
        const double size_m = std::max(bounds.min_m, requested_m);
        if (size_m >= bounds.max_m) return;
        auto& tree =
            classes->trees[static_cast<int>(std::round(std::log(bounds.max_m / size_m) / std::log(Classes::step)))];
        if (!tree) tree = std::make_unique<Search::Tree>();
        tree->insert({location[0], location[1], location[2]});
    };
    if (bounds.through_wall > 0)
        for (const Wall& wall : walls) add(wall.location, wall.thickness_m / bounds.through_wall);
    for (const Bend& bend : bends) add(bend.location, bend.radius_m);
    for (auto& [number, tree] : classes->trees) tree->build();
    classes_ = std::move(classes);
}

double WallSizes::operator()(const mesh::Point& location) const {
    double size_m = classes_->max_m;
    for (const auto& [number, tree] : classes_->trees) {
        const Search search(*tree, {location[0], location[1], location[2]}, 1);
        const double own_m = classes_->max_m * std::pow(Classes::step, -number);
        size_m = std::min(size_m, own_m + growth * std::sqrt(search.begin()->second));
    }
    return size_m;
}

}  // namespace soft::meshing
