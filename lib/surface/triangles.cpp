#include "surface/triangles.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "surface/facet_map.hpp"
#include "surface/volume.hpp"

namespace soft::surface {
namespace {

using mesh::CellType;
using mesh::Index;
using mesh::Point;

Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

int add_point(Triangles& surface, const Point& point, const Point& location) {
    surface.points.push_back(point);
    surface.model_points.push_back(location);
    return static_cast<int>(surface.points.size()) - 1;
}

/// Omits triangles with coincident corners (a strip that ends on the axis).
void add_triangle(Triangles& surface, int a, int b, int c, int facet) {
    if (a == b || b == c || c == a) return;
    surface.triangles.push_back({a, b, c});
    surface.facets.push_back(facet);
}

/// Nodes of an edge of a section from its start to its end.
std::vector<Index> nodes_along(const std::vector<Index>& line) {
    return line.size() == 3 ? std::vector<Index>{line[0], line[2], line[1]} : line;
}

/// Few sectors, for speed: CGAL takes about 5 us per triangle. Between two planes through the axis the surface is the outline extruded
/// along straight lines. It therefore intersects itself exactly where the outline does, for any number of sectors, and the enlarged
/// polygons preserve the volume.
constexpr int sectors = 4;

void revolve(const model::Case& model, const std::vector<mesh::Facet>& facets, Triangles& surface) {
    const double angle = 2 * std::numbers::pi / sectors, enlarged = std::sqrt(angle / std::sin(angle));
    const double tolerance_m = mesh::plane_tolerance * mesh::extent_m(model.mesh);

    std::map<Index, std::vector<int>> circles;
    const auto circle = [&](Index node) -> const std::vector<int>& {
        std::vector<int>& points = circles[node];
        if (!points.empty()) return points;
        const Point& p = model.mesh.point(node);
        if (std::abs(p[1]) <= tolerance_m)
            points.assign(static_cast<std::size_t>(sectors), add_point(surface, {p[0], 0, 0}, p));
        for (int s = static_cast<int>(points.size()); s < sectors; ++s)
            points.push_back(add_point(
                surface, {p[0], p[1] * enlarged * std::cos(s * angle), p[1] * enlarged * std::sin(s * angle)}, p));
        return points;
    };
    for (std::size_t f = 0; f < facets.size(); ++f) {
        const std::vector<Index> nodes = nodes_along(facet_nodes(model.mesh, facets[f]));
        for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
            const std::vector<int>&a = circle(nodes[i]), &b = circle(nodes[i + 1]);
            for (std::size_t s = 0; s < a.size(); ++s) {
                const std::size_t next = (s + 1) % a.size();
                add_triangle(surface, a[s], a[next], b[next], static_cast<int>(f));
                add_triangle(surface, a[s], b[next], b[s], static_cast<int>(f));
            }
        }
    }
}

/// Adds points of the mesh to the surface on first use.
class UsedPoints {
public:
    UsedPoints(const mesh::Mesh& mesh, Triangles& surface) : mesh_(&mesh), surface_(&surface) {}
    int operator()(Index node) {
        const auto [found, is_new] = numbers_.emplace(node, 0);
        if (is_new) found->second = add_point(*surface_, mesh_->point(node), mesh_->point(node));
        return found->second;
    }

private:
    const mesh::Mesh* mesh_;
    Triangles* surface_;
    std::map<Index, int> numbers_;
};

void reverse_orientation(Triangles& surface) {
    for (auto& triangle : surface.triangles) std::swap(triangle[1], triangle[2]);
}

/// Adds the mirror image at the plane where coordinate `d` is zero; points on the plane are shared.
void mirror(Triangles& surface, std::size_t d, double tolerance_m) {
    std::vector<int> image(surface.points.size());
    for (std::size_t i = 0; i < image.size(); ++i) {
        Point point = surface.points[i];
        if (std::abs(point[d]) <= tolerance_m) {
            image[i] = static_cast<int>(i);
            continue;
        }
        point[d] = -point[d];
        const Point location = surface.model_points[i];
        image[i] = add_point(surface, point, location);
    }
    for (std::size_t t = 0, count = surface.triangles.size(); t < count; ++t) {
        const auto [a, b, c] = surface.triangles[t];
        const auto at = [&](int i) { return image[static_cast<std::size_t>(i)]; };
        add_triangle(surface, at(a), at(c), at(b), surface.facets[t]);
    }
}

using DirectedEdge = std::pair<int, int>;

/// Directed edges without their opposite, grouped into connected rims.
std::vector<std::vector<DirectedEdge>> open_rims(const Triangles& surface) {
    std::vector<DirectedEdge> edges;
    for (const auto& t : surface.triangles)
        for (std::size_t i = 0; i < 3; ++i) edges.emplace_back(t[i], t[(i + 1) % 3]);
    std::sort(edges.begin(), edges.end());
    std::multimap<int, DirectedEdge> open;  // by start
    for (const DirectedEdge& edge : edges)
        if (!std::binary_search(edges.begin(), edges.end(), DirectedEdge{edge.second, edge.first}))
            open.emplace(edge.first, edge);
    std::vector<std::vector<DirectedEdge>> rims;
    while (!open.empty()) {
        std::vector<DirectedEdge>& rim = rims.emplace_back();
        for (auto next = open.begin(); next != open.end(); next = open.find(rim.back().second)) {
            rim.push_back(next->second);
            open.erase(next);
        }
    }
    return rims;
}

/// Area vector of the fan that closes a rim, out of the cavity.
Point cap_area(const Triangles& surface, const std::vector<DirectedEdge>& rim) {
    const auto at = [&](int i) { return surface.points[static_cast<std::size_t>(i)]; };
    const Point origin = at(rim.front().first);
    Point area{};
    for (const auto& [a, b] : rim) {
        const Point part = cross(at(b) - origin, at(a) - origin);  // the cap has the opposite edge direction
        for (std::size_t d = 0; d < 3; ++d) area[d] += part[d] / 2;
    }
    return area;
}

bool is_cap_of(const model::Opening& opening, const Point& area) {
    constexpr double faceted = 0.1;  // a polygon instead of a circle: 8 corners have 90 % of its area
    double distance2 = 0;
    for (std::size_t d = 0; d < 3; ++d) distance2 += std::pow(area[d] - opening.area_m2 * opening.direction[d], 2);
    return std::sqrt(distance2) <= faceted * opening.area_m2;
}

void add_fan(Triangles& surface, const std::vector<DirectedEdge>& rim) {
    Point centre{}, location{};
    for (const auto& [a, b] : rim)
        for (std::size_t d = 0; d < 3; ++d) {
            centre[d] += surface.points[static_cast<std::size_t>(a)][d] / static_cast<double>(rim.size());
            location[d] += surface.model_points[static_cast<std::size_t>(a)][d] / static_cast<double>(rim.size());
        }
    const int apex = add_point(surface, centre, location);
    for (const auto& [a, b] : rim) add_triangle(surface, b, a, apex, -1);
}

std::vector<Triangles::Edge> edges_in_plane(const Triangles& surface, double tolerance_m) {
    const auto in_plane = [&](int point) {
        return std::abs(surface.points[static_cast<std::size_t>(point)][2]) <= tolerance_m;
    };
    std::map<std::array<int, 2>, int> edges;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const int a = surface.triangles[t][i], b = surface.triangles[t][(i + 1) % 3];
            if (in_plane(a) && in_plane(b)) edges.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(t));
        }
    std::vector<Triangles::Edge> found;
    for (const auto& [points, triangle] : edges) found.push_back({points, triangle});
    return found;
}

}  // namespace

std::vector<std::array<int, 3>> facet_division(CellType facet) {
    switch (facet) {
        case CellType::triangle3: return {{0, 1, 2}};
        case CellType::triangle6: return {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
        case CellType::quad4: return {{0, 1, 2}, {0, 2, 3}};
        case CellType::quad9:
            return {{0, 4, 8}, {4, 1, 8}, {1, 5, 8}, {5, 2, 8}, {2, 6, 8}, {6, 3, 8}, {3, 7, 8}, {7, 0, 8}};
        default: return {};  // lines are extruded instead; cells are not facets
    }
}

Triangles cavity_surface(const model::Case& model, const model::Cavity& cavity) {
    const std::vector<mesh::Facet> facets = cavity_facets(model, cavity);
    const bool is_section = model.kinematics == model::Kinematics::axisymmetric;
    Triangles surface;
    if (is_section) {
        revolve(model, facets, surface);
    } else {
        surface = facet_triangles(model.mesh, facets);
        reverse_orientation(surface);
    }
    const double tolerance_m = mesh::plane_tolerance * mesh::extent_m(model.mesh);
    for (std::size_t d = 0; d < (is_section ? 1u : 3u); ++d)
        if (model.symmetry_planes[d]) mirror(surface, d, tolerance_m);

    std::vector<model::Opening> openings = cavity.openings;
    for (const auto& rim : open_rims(surface)) {
        const Point area = cap_area(surface, rim);
        const auto match = std::find_if(openings.begin(), openings.end(),
                                        [&](const model::Opening& opening) { return is_cap_of(opening, area); });
        if (match == openings.end()) continue;
        openings.erase(match);
        add_fan(surface, rim);
    }
    if (is_section) surface.outline = edges_in_plane(surface, tolerance_m);
    return surface;
}

Triangles facet_triangles(const mesh::Mesh& mesh, const std::vector<mesh::Facet>& facets) {
    Triangles surface;
    UsedPoints used(mesh, surface);
    const double half_width_m = mesh::extent_m(mesh);  // any width is sufficient: rays stay at z = 0
    for (std::size_t f = 0; f < facets.size(); ++f) {
        const std::vector<Index> nodes = facet_nodes(mesh, facets[f]);
        const int number = static_cast<int>(f);
        for (const auto& [a, b, c] : facet_division(facet_type(mesh, facets[f])))
            add_triangle(surface, used(nodes[static_cast<std::size_t>(a)]), used(nodes[static_cast<std::size_t>(b)]),
                         used(nodes[static_cast<std::size_t>(c)]), number);
        if (mesh.dimension == 3) continue;
        const std::vector<Index> line = nodes_along(nodes);
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            const Point p = mesh.point(line[i]), q = mesh.point(line[i + 1]);
            const int a = add_point(surface, {p[0], p[1], -half_width_m}, p),
                      b = add_point(surface, {q[0], q[1], -half_width_m}, q);
            const int c = add_point(surface, {q[0], q[1], 2 * half_width_m}, q),
                      d = add_point(surface, {p[0], p[1], 2 * half_width_m}, p);
            add_triangle(surface, a, b, c, number);  // factor 2: the diagonal crosses z = 0 away from the middle
            add_triangle(surface, a, c, d, number);
        }
    }
    return surface;
}

}  // namespace soft::surface
