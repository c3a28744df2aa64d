#include "surface/hull.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <vector>

namespace soft::surface {

double hull_volume_m3(std::span<const mesh::Point> points) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    std::vector<Kernel::Point_3> cloud;
    for (const mesh::Point& point : points) cloud.emplace_back(point[0], point[1], point[2]);
    if (cloud.size() < 4) return 0;
    CGAL::Surface_mesh<Kernel::Point_3> hull;
    CGAL::convex_hull_3(cloud.begin(), cloud.end(), hull);
    // For coplanar points CGAL returns a flat polygon, which encloses no volume.
    return hull.number_of_vertices() >= 4 && CGAL::is_closed(hull) ? CGAL::Polygon_mesh_processing::volume(hull) : 0.0;
}

}  // namespace soft::surface
