#include "surface/cgal_queries.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

namespace soft::surface {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

Kernel::Point_2 cgal_point_in_plane(const mesh::Point& p) { return {p[0], p[1]}; }
Kernel::Segment_2 cgal_segment(Corners c) { return {cgal_point_in_plane(c[0]), cgal_point_in_plane(c[1])}; }
Kernel::Point_3 cgal_point(const mesh::Point& p) { return {p[0], p[1], p[2]}; }

Kernel::Triangle_3 cgal_triangle(Corners c) { return {cgal_point(c[0]), cgal_point(c[1]), cgal_point(c[2])}; }

/// Midpoint of the first edge that is not used exactly once in each direction; CGAL reports that there is one, but not where.
std::optional<mesh::Point> first_bad_edge(const Triangles& surface) {
    using Edge = std::pair<int, int>;
    std::vector<Edge> edges;
    for (const auto& t : surface.triangles)
        for (std::size_t i = 0; i < 3; ++i) edges.emplace_back(t[i], t[(i + 1) % 3]);
    std::sort(edges.begin(), edges.end());
    const auto uses = [&](const Edge& edge) {
        const auto [first, last] = std::equal_range(edges.begin(), edges.end(), edge);
        return last - first;
    };
    for (const Edge& edge : edges) {
        if (uses(edge) == 1 && uses({edge.second, edge.first}) == 1) continue;
        const mesh::Point& a = surface.model_points[static_cast<std::size_t>(edge.first)];
        const mesh::Point& b = surface.model_points[static_cast<std::size_t>(edge.second)];
        return mesh::Point{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
    }
    return std::nullopt;
}

/// Converts to a CGAL mesh whose faces are numbered as the triangles. If the surface is not manifold, returns instead the number of the
/// first triangle at a non-manifold edge or point.
std::variant<SurfaceMesh, std::size_t> to_mesh(const Triangles& surface) {
    SurfaceMesh mesh;
    std::vector<SurfaceMesh::Vertex_index> vertices;
    for (const mesh::Point& point : surface.points) vertices.push_back(mesh.add_vertex(cgal_point(point)));
    const auto vertex = [&](int number) { return vertices[static_cast<std::size_t>(number)]; };
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const auto& [a, b, c] = surface.triangles[t];
        if (mesh.add_face(vertex(a), vertex(b), vertex(c)) == SurfaceMesh::null_face()) return t;
    }
    return mesh;
}

/// The pair with the smallest triangle numbers. The fast test comes first; all pairs are listed only if it finds one, because CGAL
/// returns them in its own order.
std::optional<std::array<int, 2>> first_intersection(const SurfaceMesh& mesh) {
    if (!PMP::does_self_intersect(mesh)) return std::nullopt;
    std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> pairs;
    PMP::self_intersections(mesh, std::back_inserter(pairs));
    std::vector<std::array<int, 2>> numbers;
    for (const auto& [f, g] : pairs) {
        const int a = static_cast<int>(f.idx()), b = static_cast<int>(g.idx());
        numbers.push_back({std::min(a, b), std::max(a, b)});
    }
    return *std::min_element(numbers.begin(), numbers.end());
}

/// Whether the segments from the common end p to a and to b overlap.
bool fold_back(const mesh::Point& p, const mesh::Point& a, const mesh::Point& b) {
    const auto o = cgal_point_in_plane(p), s = cgal_point_in_plane(a), t = cgal_point_in_plane(b);
    return CGAL::collinear(o, s, t) && CGAL::angle(s, o, t) == CGAL::ACUTE;
}

bool edges_cross(const Triangles& surface, const Triangles::Edge& a, const Triangles::Edge& b) {
    const auto at = [&](int point) -> const mesh::Point& { return surface.points[static_cast<std::size_t>(point)]; };
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j)
            if (a.points[i] == b.points[j]) return fold_back(at(a.points[i]), at(a.points[1 - i]), at(b.points[1 - j]));
    const std::array ends_a{at(a.points[0]), at(a.points[1])}, ends_b{at(b.points[0]), at(b.points[1])};
    return intersect(ends_a, ends_b);
}

/// As first_intersection, for a revolved section: CGAL's search over its triangles, many of them coplanar, needs exact arithmetic
/// and took a quarter of the time of a small mesh.
std::optional<std::array<int, 2>> first_crossing(const Triangles& surface) {
    std::vector<Box> boxes;
    for (const Triangles::Edge& edge : surface.outline) {
        const mesh::Point& a = surface.points[static_cast<std::size_t>(edge.points[0])];
        const mesh::Point& b = surface.points[static_cast<std::size_t>(edge.points[1])];
        boxes.push_back(
            {{std::min(a[0], b[0]), std::min(a[1], b[1]), 0}, {std::max(a[0], b[0]), std::max(a[1], b[1]), 0}});
    }
    std::optional<std::array<int, 2>> first;
    for (const auto& [i, j] : overlapping_pairs(boxes)) {
        const Triangles::Edge &a = surface.outline[static_cast<std::size_t>(i)],
                              &b = surface.outline[static_cast<std::size_t>(j)];
        if (!edges_cross(surface, a, b)) continue;
        const std::array pair{std::min(a.triangle, b.triangle), std::max(a.triangle, b.triangle)};
        first = first ? std::min(*first, pair) : pair;
    }
    return first;
}

}  // namespace

SurfaceChecks check_surface(const Triangles& surface) {
    SurfaceChecks checks;
    checks.open_location = first_bad_edge(surface);
    const auto converted = to_mesh(surface);
    const SurfaceMesh* mesh = std::get_if<SurfaceMesh>(&converted);
    if (mesh == nullptr) {
        const auto& triangle = surface.triangles[std::get<std::size_t>(converted)];
        if (!checks.open_location) checks.open_location = surface.model_points[static_cast<std::size_t>(triangle[0])];
        return checks;
    }
    checks.closed = !checks.open_location && CGAL::is_closed(*mesh);
    checks.intersecting = surface.outline.empty() ? first_intersection(*mesh) : first_crossing(surface);
    if (!checks.closed) return checks;
    checks.volume_m3 = CGAL::to_double(PMP::volume(*mesh));
    // is_outward_oriented casts a ray and is meaningless if the surface intersects itself
    checks.outward = checks.intersecting ? checks.volume_m3 > 0 : PMP::is_outward_oriented(*mesh);
    return checks;
}

struct RayTree::Tree {
    using Triangle = Kernel::Triangle_3;
    using Primitive = CGAL::AABB_triangle_primitive<Kernel, std::vector<Triangle>::const_iterator>;
    using Aabb = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

    std::vector<Triangle> triangles;
    std::vector<int> facets;
    Aabb aabb;

    [[nodiscard]] int facet(const std::vector<Triangle>::const_iterator& at) const {
        return facets[static_cast<std::size_t>(at - triangles.cbegin())];
    }
};

RayTree::RayTree(const Triangles& surface) : tree_(std::make_unique<Tree>()) {
    for (const auto& t : surface.triangles)
        tree_->triangles.emplace_back(cgal_point(surface.points[static_cast<std::size_t>(t[0])]),
                                      cgal_point(surface.points[static_cast<std::size_t>(t[1])]),
                                      cgal_point(surface.points[static_cast<std::size_t>(t[2])]));
    tree_->facets = surface.facets;
    tree_->aabb.insert(tree_->triangles.cbegin(), tree_->triangles.cend());
    tree_->aabb.build();
}

RayTree::~RayTree() = default;
RayTree::RayTree(RayTree&&) noexcept = default;
RayTree& RayTree::operator=(RayTree&&) noexcept = default;

std::optional<RayTree::Hit> RayTree::first_hit(const mesh::Point& from, const mesh::Point& direction, int skip) const {
    const Kernel::Point_3 origin = cgal_point(from);
    const Kernel::Vector_3 along(direction[0], direction[1], direction[2]);
    const auto passed = [&](const std::vector<Tree::Triangle>::const_iterator& at) { return tree_->facet(at) == skip; };
    const auto hit = tree_->aabb.first_intersection(Kernel::Ray_3(origin, along), passed);
    if (!hit) return std::nullopt;
    const int facet = tree_->facet(hit->second);
    if (const auto* point = boost::get<Kernel::Point_3>(&hit->first))
        return Hit{CGAL::to_double((*point - origin) * along), facet};
    const auto* segment = boost::get<Kernel::Segment_3>(&hit->first);  // the ray lies in the triangle's plane
    if (segment == nullptr) return std::nullopt;
    return Hit{std::min(CGAL::to_double((segment->source() - origin) * along),
                        CGAL::to_double((segment->target() - origin) * along)),
               facet};
}

std::vector<std::array<int, 2>> overlapping_pairs(std::span<const Box> boxes) {
    // explicit ids: the algorithm moves the boxes, so addresses do not identify them
    using Numbered = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int, CGAL::Box_intersection_d::ID_EXPLICIT>;
    std::vector<Numbered> numbered;
    numbered.reserve(boxes.size());
    for (const Box& box : boxes)
        numbered.emplace_back(CGAL::Bbox_3(box.low[0], box.low[1], box.low[2], box.high[0], box.high[1], box.high[2]),
                              static_cast<int>(numbered.size()));
    std::vector<std::array<int, 2>> pairs;
    // Fewer boxes are compared in sequence: two to three times faster than with CGAL's 10.
    constexpr std::ptrdiff_t few = 100;
    CGAL::box_self_intersection_d(
        numbered.begin(), numbered.end(),
        [&pairs](const Numbered& a, const Numbered& b) {
            pairs.push_back({std::min(a.info(), b.info()), std::max(a.info(), b.info())});
        },
        few);
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

double reach_m(Corners piece, Corners other) {
    const Vector3 first = difference(other[1], other[0]);
    const Vector3 normal = cross(first, other.size() > 2 ? difference(other[2], other[0]) : Vector3{0, 0, 1});
    double low = 0, high = 0;
    for (const mesh::Point& p : piece) {
        const double height = dot(difference(p, other[0]), normal) / norm(normal);
        low = std::min(low, height);
        high = std::max(high, height);
    }
    return std::min(-low, high);
}

bool intersect(Corners a, Corners b) {
    if (a.size() == 2) {
        const auto s = cgal_segment(a), t = cgal_segment(b);
        return !s.is_degenerate() && !t.is_degenerate() && CGAL::do_intersect(s, t);
    }
    const auto s = cgal_triangle(a), t = cgal_triangle(b);
    return !s.is_degenerate() && !t.is_degenerate() && CGAL::do_intersect(s, t);
}

bool is_within(Corners a, Corners b, double distance_m) {
    const double square = distance_m * distance_m;
    if (a.size() == 2) return CGAL::squared_distance(cgal_segment(a), cgal_segment(b)) <= square;
    return CGAL::squared_distance(cgal_triangle(a), cgal_triangle(b)) <= square;
}

}  // namespace soft::surface
