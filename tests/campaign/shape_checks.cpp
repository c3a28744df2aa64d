#include "shape_checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "mesh/cell_map.hpp"
#include "mesh/shape.hpp"
#include "model/cavity_surface.hpp"
#include "surface/cgal_queries.hpp"
#include "surface/free_facets.hpp"
#include "surface/triangles.hpp"

namespace soft::campaign {
namespace {

using mesh::Facet;
using mesh::Point;

/// Straight pieces of the surface: edges of a section divided in so many, triangles of a solid at its nodes.
constexpr int parts_of_an_edge = 6;
/// Beyond the mirror by this part of the body.
constexpr double passed = 1e-6;

struct Pieces {
    std::vector<std::vector<Point>> corners;
    std::vector<std::array<long, 3>> ends;  ///< names of the corners, the same where pieces hang together
};

/// The parabola through an edge's ends and its middle.
Point on_edge(const Point& a, const Point& b, const Point& middle, double s) {
    Point p{};
    for (std::size_t d = 0; d < 2; ++d)
        p[d] = a[d] * (1 - s) * (1 - 2 * s) + b[d] * s * (2 * s - 1) + middle[d] * 4 * s * (1 - s);
    return p;
}

Pieces pieces_of_section(const mesh::Mesh& mesh, const std::vector<Facet>& skin) {
    Pieces pieces;
    const long inner = static_cast<long>(mesh.points.size());
    for (std::size_t f = 0; f < skin.size(); ++f) {
        const auto nodes = mesh::facet_nodes(mesh, skin[f]);
        const Point &a = mesh.point(nodes[0]), &b = mesh.point(nodes[1]);
        Point middle{};
        for (std::size_t d = 0; d < 3; ++d)
            middle[d] = nodes.size() > 2 ? mesh.point(nodes[2])[d] : 0.5 * (a[d] + b[d]);
        const auto name = [&](int k) {
            return k == 0                  ? static_cast<long>(nodes[0])
                   : k == parts_of_an_edge ? static_cast<long>(nodes[1])
                                           : inner + static_cast<long>(f) * parts_of_an_edge + k;
        };
        for (int k = 0; k < parts_of_an_edge; ++k) {
            const double s = 1.0 / parts_of_an_edge;
            pieces.corners.push_back({on_edge(a, b, middle, k * s), on_edge(a, b, middle, (k + 1) * s)});
            pieces.ends.push_back({name(k), name(k + 1), -1});
        }
    }
    return pieces;
}

Pieces pieces_of_solid(const mesh::Mesh& mesh, const std::vector<Facet>& skin) {
    Pieces pieces;
    const surface::Triangles triangles = surface::facet_triangles(mesh, skin);
    std::map<Point, long> names;  // a point may be there once a facet
    std::vector<long> name;
    for (const Point& p : triangles.points)
        name.push_back(names.emplace(p, static_cast<long>(names.size())).first->second);
    for (const auto& triangle : triangles.triangles) {
        auto& corners = pieces.corners.emplace_back();
        auto& ends = pieces.ends.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            corners.push_back(triangles.points[static_cast<std::size_t>(triangle[i])]);
            ends[i] = name[static_cast<std::size_t>(triangle[i])];
        }
    }
    return pieces;
}

bool hang_together(const std::array<long, 3>& a, const std::array<long, 3>& b) {
    return std::ranges::any_of(a, [&](long name) { return name >= 0 && std::ranges::find(b, name) != b.end(); });
}

double determinant(const std::array<Point, 3>& g, int dimension) {
    if (dimension == 2) return g[0][0] * g[1][1] - g[0][1] * g[1][0];
    return g[0][0] * (g[1][1] * g[2][2] - g[1][2] * g[2][1]) - g[0][1] * (g[1][0] * g[2][2] - g[1][2] * g[2][0]) +
           g[0][2] * (g[1][0] * g[2][1] - g[1][1] * g[2][0]);
}

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double times(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Angle between a triangle and the far corner of its neighbour about their common edge; negative where rubber fills it.
double air_angle(const std::vector<Point>& triangle, std::size_t opposite, const Point& far) {
    const Point &own = triangle[opposite], &a = triangle[(opposite + 1) % 3], &b = triangle[(opposite + 2) % 3];
    const Point along = minus(b, a), u = minus(own, a), v = minus(far, a);
    const double length2 = times(along, along);
    Point p{}, q{};
    for (std::size_t d = 0; d < 3; ++d) {
        p[d] = u[d] - times(u, along) / length2 * along[d];
        q[d] = v[d] - times(v, along) / length2 * along[d];
    }
    const double angle = std::acos(std::clamp(times(p, q) / std::sqrt(times(p, p) * times(q, q)), -1.0, 1.0));
    // The corners run round the normal out of the rubber: a, b, own.
    const Point normal{along[1] * u[2] - along[2] * u[1], along[2] * u[0] - along[0] * u[2],
                       along[0] * u[1] - along[1] * u[0]};
    return times(normal, v) > 0 ? angle : -angle;
}

}  // namespace

ShapeChecks::ShapeChecks(const model::Case& model)
    : model_(model), skin_(surface::free_facets(model)), extent_m_(model::extent_m(model.mesh)) {
    from_the_start_ = meeting(model.mesh);
}

mesh::Mesh ShapeChecks::moved(std::span<const double> u) const {
    mesh::Mesh mesh = model_.mesh;
    for (std::size_t n = 0; n < mesh.points.size(); ++n)
        for (std::size_t d = 0; d < 3; ++d) mesh.points[n][d] += u[3 * n + d];
    return mesh;
}

ShapeChecks::Pairs ShapeChecks::meeting(const mesh::Mesh& mesh) const {
    const Pieces pieces = mesh.dimension == 2 ? pieces_of_section(mesh, skin_) : pieces_of_solid(mesh, skin_);
    std::vector<surface::Box> boxes;
    for (const auto& corners : pieces.corners) {
        surface::Box& box = boxes.emplace_back(surface::Box{corners[0], corners[0]});
        for (const Point& p : corners)
            for (std::size_t d = 0; d < 3; ++d) {
                box.low[d] = std::min(box.low[d], p[d]);
                box.high[d] = std::max(box.high[d], p[d]);
            }
    }
    Pairs pairs;
    for (const auto& pair : surface::overlapping(boxes)) {
        const auto i = static_cast<std::size_t>(pair[0]), j = static_cast<std::size_t>(pair[1]);
        if (!hang_together(pieces.ends[i], pieces.ends[j]) && surface::meet(pieces.corners[i], pieces.corners[j]))
            pairs.insert(pair);
    }
    return pairs;
}

/// At nodes and between them: facets bulge.
bool ShapeChecks::passes_a_mirror(const mesh::Mesh& mesh) const {
    constexpr int samples = 8;
    const auto mirrors = surface::mirrors(model_);
    for (const Facet& facet : skin_) {
        const mesh::CellType type = mesh::facet_type(mesh, facet);
        const auto nodes = mesh::facet_nodes(mesh, facet);
        const bool flat = mesh::topology(type).shape == mesh::Shape::triangle;
        for (int i = 0; i <= samples; ++i)
            for (int j = 0; j <= (mesh.dimension == 2 ? 0 : samples); ++j) {
                const double a = static_cast<double>(i) / samples, b = static_cast<double>(j) / samples;
                if (flat && a + b > 1) continue;
                const auto shapes = mesh::shape_values(type, flat ? Point{a, b, 0} : Point{2 * a - 1, 2 * b - 1, 0});
                Point was{}, is{};
                for (std::size_t n = 0; n < nodes.size(); ++n)
                    for (std::size_t d = 0; d < 3; ++d) {
                        was[d] += shapes[n].value * model_.mesh.point(nodes[n])[d];
                        is[d] += shapes[n].value * mesh.point(nodes[n])[d];
                    }
                for (std::size_t d = 0; d < 3; ++d)
                    if (mirrors[d] && std::abs(was[d]) > passed * extent_m_ && is[d] * was[d] < 0) return true;
            }
    }
    return false;
}

/// Of a section: where two edges of the skin meet at a node, the way from one to the other through the air has become none.
bool ShapeChecks::crease_of_section_closes(const mesh::Mesh& mesh) const {
    const auto directions = [&](const mesh::Mesh& shape) {  // of the edges that leave and reach each node, outwards
        std::map<mesh::Index, std::array<Point, 2>> at;
        for (const Facet& facet : skin_) {
            const auto nodes = mesh::facet_nodes(shape, facet);
            const Point &a = shape.point(nodes[0]), &b = shape.point(nodes[1]);
            Point middle{};
            for (std::size_t d = 0; d < 2; ++d)
                middle[d] = nodes.size() > 2 ? shape.point(nodes[2])[d] : 0.5 * (a[d] + b[d]);
            for (std::size_t d = 0; d < 2; ++d) {
                at[nodes[0]][0][d] = 4 * middle[d] - 3 * a[d] - b[d];
                at[nodes[1]][1][d] = 4 * middle[d] - 3 * b[d] - a[d];
            }
        }
        return at;
    };
    const auto angle =
        [](const std::array<Point, 2>& d) {  // from the edge that leaves to the one that comes, (-pi, pi]
            return std::atan2(d[0][0] * d[1][1] - d[0][1] * d[1][0], d[0][0] * d[1][0] + d[0][1] * d[1][1]);
        };
    const auto before = directions(model_.mesh), now = directions(mesh);
    for (const auto& [node, d] : now) {
        const double was = angle(before.at(node)), is = angle(d);
        constexpr double sharp = 0.5;  // [rad]
        if ((was < -sharp || was > std::numbers::pi - sharp) && is > 0 && is < sharp) return true;
    }
    return false;
}

/// Of a solid: two triangles at an edge, in the undeformed body level or with air between them, have come next to each other.
bool ShapeChecks::crease_of_solid_closes(const mesh::Mesh& mesh) const {
    constexpr double closed = 0.35, level = 2.6;  // [rad]
    const Pieces before = pieces_of_solid(model_.mesh, skin_), now = pieces_of_solid(mesh, skin_);
    struct Side {
        std::size_t piece, opposite;  // the corner that is not on the edge
    };
    std::map<std::array<long, 2>, std::vector<Side>> edges;
    for (std::size_t p = 0; p < before.ends.size(); ++p)
        for (std::size_t i = 0; i < 3; ++i) {
            const long a = before.ends[p][(i + 1) % 3], b = before.ends[p][(i + 2) % 3];
            edges[{std::min(a, b), std::max(a, b)}].push_back({p, i});
        }
    for (const auto& [edge, sides] : edges) {
        if (sides.size() != 2) continue;
        const double was = air_angle(before.corners[sides[0].piece], sides[0].opposite,
                                     before.corners[sides[1].piece][sides[1].opposite]);
        const double is =
            air_angle(now.corners[sides[0].piece], sides[0].opposite, now.corners[sides[1].piece][sides[1].opposite]);
        const bool open = was > 0 || std::abs(was) > level;
        if (open && std::abs(is) < closed) return true;
    }
    return false;
}

bool ShapeChecks::crease_closes(const mesh::Mesh& mesh) const {
    return mesh.dimension == 2 ? crease_of_section_closes(mesh) : crease_of_solid_closes(mesh);
}

std::string ShapeChecks::contact(std::span<const double> u) const {
    const mesh::Mesh now = moved(u);
    Pairs pairs = meeting(now);
    for (const auto& pair : from_the_start_) pairs.erase(pair);
    if (!pairs.empty()) return "walls meet";
    if (passes_a_mirror(now)) return "a wall passes a mirror";
    return crease_closes(now) ? "a crease closes" : "";
}

double ShapeChecks::least_det_F(std::span<const double> u) const {
    const mesh::Mesh now = moved(u);
    double least = std::numeric_limits<double>::infinity();
    for (mesh::Index c = 0; c < now.cell_count(); ++c) {
        const mesh::CellType type = now.cell_type(c);
        const auto nodes = now.cell_nodes(c);
        std::vector<Point> places(mesh::topology(type).nodes.begin(), mesh::topology(type).nodes.end());
        for (const auto& point : mesh::volume_rule(type)) places.push_back(point.xi);
        for (const Point& xi : places) {
            std::array<Point, 3> was{}, is{};
            const auto shapes = mesh::shape_values(type, xi);
            for (std::size_t a = 0; a < nodes.size(); ++a)
                for (std::size_t i = 0; i < 3; ++i)
                    for (std::size_t k = 0; k < 3; ++k) {
                        was[i][k] += shapes[a].gradient[i] * model_.mesh.point(nodes[a])[k];
                        is[i][k] += shapes[a].gradient[i] * now.point(nodes[a])[k];
                    }
            least = std::min(least, determinant(is, now.dimension) / determinant(was, now.dimension));
        }
    }
    return least;
}

}  // namespace soft::campaign
