#include "shape_checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "contact/distance.hpp"
#include "mesh/cell_map.hpp"
#include "mesh/mesh.hpp"
#include "mesh/shape.hpp"
#include "surface/cgal_queries.hpp"
#include "surface/facet_map.hpp"
#include "surface/free_facets.hpp"

namespace soft::campaign {
namespace {

using mesh::Facet;
using mesh::Point;

/// Numbers of straight pieces along each edge of a curved facet, for all facets, and for folds between facets that share a node.
constexpr int pieces_per_edge = 6, pieces_of_neighbours = 12;
/// Distance from the symmetry plane beyond which a point counts as off the plane, relative to the extent of the model.
constexpr double crossing_tolerance = 1e-6;

struct Pieces {
    std::vector<std::vector<Point>> corners;
    std::vector<std::array<long, 3>> ends;  ///< ids of the corners, equal for connected pieces
    std::vector<mesh::Index> cells;
    std::vector<std::size_t> facets;
    std::vector<double>
        sag_m;  ///< of the curved facet at the middle of the piece: thinner walls between pieces cannot be told from none
};

/// A point (i, j) of a facet's grid.
struct GridPoint {
    int i, j;
};

/// Ids of grid points, equal in two facets for the points of their common edge.
class Names {
public:
    Names(std::size_t facet, std::span<const mesh::Index> nodes, int parts, mesh::Shape shape)
        : facet_(static_cast<long>(facet)), nodes_(nodes), parts_(parts), shape_(shape) {}

    [[nodiscard]] std::array<long, 3> operator()(const GridPoint& p) const {
        const auto [i, j] = p;
        const bool four = shape_ == mesh::Shape::quadrilateral;
        if (shape_ == mesh::Shape::line || j == 0) return on_edge(0, 1, i);
        if (i == 0) return on_edge(0, four ? 3 : 2, j);
        if (!four && i + j == parts_) return on_edge(1, 2, j);
        if (four && i == parts_) return on_edge(1, 2, j);
        if (four && j == parts_) return on_edge(3, 2, i);
        return {-1 - facet_, i, j};
    }

private:
    [[nodiscard]] std::array<long, 3> on_edge(std::size_t from, std::size_t to, int k) const {
        const long a = nodes_[from], b = nodes_[to];
        if (k == 0) return {a, a, 0};
        if (k == parts_) return {b, b, 0};
        return a < b ? std::array<long, 3>{a, b, k} : std::array<long, 3>{b, a, parts_ - k};
    }

    long facet_;
    std::span<const mesh::Index> nodes_;
    int parts_;
    mesh::Shape shape_;
};

/// Triangles (segments) of a facet's grid.
std::vector<std::vector<GridPoint>> grid(mesh::Shape shape, int parts) {
    std::vector<std::vector<GridPoint>> pieces;
    if (shape == mesh::Shape::line)
        for (int i = 0; i < parts; ++i) pieces.push_back({{i, 0}, {i + 1, 0}});
    else
        for (int j = 0; j < parts; ++j)
            for (int i = 0; i < (shape == mesh::Shape::triangle ? parts - j : parts); ++i) {
                pieces.push_back({{i, j}, {i + 1, j}, {i, j + 1}});
                if (shape == mesh::Shape::quadrilateral || i + j + 1 < parts)
                    pieces.push_back({{i + 1, j}, {i + 1, j + 1}, {i, j + 1}});
            }
    return pieces;
}

/// Curved facets are subdivided finely enough to detect a crease that closes between nodes.
Pieces pieces_of(const mesh::Mesh& mesh, const std::vector<Facet>& skin, int per_edge) {
    Pieces pieces;
    std::map<std::array<long, 3>, long> numbers;
    for (std::size_t f = 0; f < skin.size(); ++f) {
        const surface::FacetMap map = surface::facet_map(mesh, skin[f], mesh.points);
        const mesh::CellTopology& type = mesh::topology(map.type);
        const bool plane = type.order == 1 && type.shape != mesh::Shape::quadrilateral;
        const int parts = plane ? 1 : per_edge;
        const auto nodes = mesh::facet_nodes(mesh, skin[f]);
        const Names name{f, nodes, parts, type.shape};
        const bool simplex = type.shape == mesh::Shape::triangle;
        for (const auto& piece : grid(type.shape, parts)) {
            auto& corners = pieces.corners.emplace_back();
            auto& ends = pieces.ends.emplace_back(std::array<long, 3>{-1, -1, -1});
            pieces.cells.push_back(skin[f].cell);
            pieces.facets.push_back(f);
            const auto at = [&](double i, double j) {
                const double a = i / parts, b = j / parts;
                return map(simplex ? surface::FacetPoint{a, b} : surface::FacetPoint{2 * a - 1, 2 * b - 1}).x;
            };
            double i = 0, j = 0;
            Point middle{};
            const double share = 1.0 / static_cast<double>(piece.size());
            for (std::size_t k = 0; k < piece.size(); ++k) {
                i += share * piece[k].i;
                j += share * piece[k].j;
                corners.push_back(at(piece[k].i, piece[k].j));
                middle = along(middle, share, corners.back());
                ends[k] = numbers.emplace(name(piece[k]), static_cast<long>(numbers.size())).first->second;
            }
            pieces.sag_m.push_back(norm(difference(at(i, j), middle)));
        }
    }
    return pieces;
}

bool share_vertex(const std::array<long, 3>& a, const std::array<long, 3>& b) {
    return std::ranges::any_of(a, [&](long name) { return name >= 0 && std::ranges::find(b, name) != b.end(); });
}

bool share_node(const Facet& a, const Facet& b, const mesh::Mesh& mesh) {
    const auto nodes = mesh::facet_nodes(mesh, b);
    return std::ranges::any_of(mesh::facet_nodes(mesh, a),
                               [&](mesh::Index n) { return std::ranges::find(nodes, n) != nodes.end(); });
}

double determinant(const std::array<Point, 3>& g, int dimension) {
    if (dimension == 2) return g[0][0] * g[1][1] - g[0][1] * g[1][0];
    return g[0][0] * (g[1][1] * g[2][2] - g[1][2] * g[2][1]) - g[0][1] * (g[1][0] * g[2][2] - g[1][2] * g[2][0]) +
           g[0][2] * (g[1][0] * g[2][1] - g[1][1] * g[2][0]);
}

}  // namespace

ShapeChecks::ShapeChecks(const model::Case& model)
    : model_(model), skin_(surface::free_facets(model)), creases_(model, skin_), extent_m_(mesh::extent_m(model.mesh)) {
    initial_pairs_ = intersecting_pairs(model.mesh, 0);
}

mesh::Mesh ShapeChecks::moved(std::span<const double> u) const {
    mesh::Mesh mesh = model_.mesh;
    for (std::size_t n = 0; n < mesh.points.size(); ++n)
        for (std::size_t d = 0; d < 3; ++d) mesh.points[n][d] += u[3 * n + d];
    return mesh;
}

/// Pairs of intersecting pieces. Sides of the same cell are excluded: rubber lies between them, and if they intersect the cell is inverted.
ShapeChecks::Pairs ShapeChecks::intersecting_pairs(const mesh::Mesh& mesh, double allowed_m) const {
    Pairs pairs;
    for (const int per_edge : {pieces_per_edge, pieces_of_neighbours}) {
        const Pieces pieces = pieces_of(mesh, skin_, per_edge);
        std::vector<surface::Box> boxes;
        for (const auto& corners : pieces.corners) {
            surface::Box& box = boxes.emplace_back(surface::Box{corners[0], corners[0]});
            for (const Point& p : corners)
                for (std::size_t d = 0; d < 3; ++d) {
                    box.low[d] = std::min(box.low[d], p[d]);
                    box.high[d] = std::max(box.high[d], p[d]);
                }
        }
        for (const auto& pair : surface::overlapping_pairs(boxes)) {
            const auto i = static_cast<std::size_t>(pair[0]), j = static_cast<std::size_t>(pair[1]);
            if (pieces.cells[i] == pieces.cells[j] || share_vertex(pieces.ends[i], pieces.ends[j])) continue;
            if (per_edge == pieces_of_neighbours && !share_node(skin_[pieces.facets[i]], skin_[pieces.facets[j]], mesh))
                continue;
            const auto &a = pieces.corners[i], &b = pieces.corners[j];
            if (surface::intersect(a, b) &&
                (allowed_m == 0 || std::min(surface::reach_m(a, b), surface::reach_m(b, a)) >
                                       allowed_m + pieces.sag_m[i] + pieces.sag_m[j]))
                pairs.insert({per_edge, pair[0], pair[1]});
        }
    }
    return pairs;
}

namespace {

/// Points of a grid on a facet, its edges and corners included.
std::vector<surface::FacetPoint> grid_points(mesh::CellType facet) {
    const mesh::Shape shape = mesh::topology(facet).shape;
    const int samples = shape == mesh::Shape::line ? 256 : 32;
    const bool simplex = shape == mesh::Shape::triangle;
    std::vector<surface::FacetPoint> points;
    for (int i = 0; i <= samples; ++i)
        for (int j = 0; j <= (shape == mesh::Shape::line ? 0 : samples); ++j) {
            const double a = static_cast<double>(i) / samples, b = static_cast<double>(j) / samples;
            if (simplex && a + b > 1) continue;
            points.push_back(simplex                      ? surface::FacetPoint{a, b}
                             : shape == mesh::Shape::line ? surface::FacetPoint{2 * a - 1, 0}
                                                          : surface::FacetPoint{2 * a - 1, 2 * b - 1});
        }
    return points;
}

}  // namespace

/// Checks nodes and points between them, because facets bulge. Facets with rubber between them and the plane are excluded: there a cell is
/// inverted.
bool ShapeChecks::crosses_symmetry_plane(const mesh::Mesh& mesh, double allowed_m) const {
    const auto mirrors = surface::mirrors(model_);
    for (const Facet& facet : skin_) {
        const surface::FacetMap before = surface::facet_map(model_.mesh, facet, model_.mesh.points),
                                now = surface::facet_map(mesh, facet, mesh.points);
        for (const surface::FacetPoint& xi : grid_points(now.type)) {
            const Point was = before(xi).x;
            const auto is = now(xi);
            const Vector3 out = cross(is.t1, is.t2);
            for (std::size_t d = 0; d < 3; ++d)
                if (mirrors[d] && std::abs(was[d]) > crossing_tolerance * extent_m_ && is.x[d] * was[d] < 0 &&
                    std::abs(is.x[d]) > allowed_m && out[d] * was[d] < 0)
                    return true;
        }
    }
    return false;
}

ShapeChecks::Depth ShapeChecks::deepest_in_obstacle(std::span<const double> u) const {
    const mesh::Mesh now = moved(u);
    Depth deepest;
    const auto distance_m = [](const model::Obstacle& obstacle, const Point& x) {
        return std::visit(
            [&](const auto& shape) {
                if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, model::FacetedSurface>)
                    return 0.0;
                else
                    return contact::distance(shape, x).value_m;
            },
            obstacle.shape);
    };
    for (const Facet& facet : skin_) {
        const surface::FacetMap map = surface::facet_map(now, facet, now.points);
        for (const surface::FacetPoint& xi : grid_points(map.type))
            for (const model::Obstacle& obstacle : model_.obstacles)
                if (const double depth_m = -distance_m(obstacle, map(xi).x); depth_m > deepest.depth_m)
                    deepest = {depth_m, obstacle.name};
    }
    return deepest;
}

double ShapeChecks::contact_distance_m() const {
    double largest_m = 0;
    for (const Facet& facet : skin_) {
        const auto nodes = mesh::facet_nodes(model_.mesh, facet);
        for (const mesh::Index a : nodes)
            for (const mesh::Index b : nodes)
                largest_m = std::max(largest_m, norm(difference(model_.mesh.point(a), model_.mesh.point(b))));
    }
    return model_.contact.distance * largest_m;
}

std::string ShapeChecks::contact(std::span<const double> u, std::span<const double> before, double allowed_m) const {
    const mesh::Mesh now = moved(u);
    Pairs pairs = intersecting_pairs(now, allowed_m);
    for (const auto& pair : initial_pairs_) pairs.erase(pair);
    if (!pairs.empty()) return "walls intersect";
    if (crosses_symmetry_plane(now, allowed_m)) return "a wall crosses a symmetry plane";
    return creases_.has_closed(moved(before).points, now.points) ? "a crease closes" : "";
}

double ShapeChecks::min_det_F(std::span<const double> u) const {
    const mesh::Mesh now = moved(u);
    double minimum = std::numeric_limits<double>::infinity();
    for (mesh::Index c = 0; c < now.cell_count(); ++c) {
        const mesh::CellType type = now.cell_type(c);
        const auto nodes = now.cell_nodes(c);
        std::vector<Point> samples(mesh::topology(type).nodes.begin(), mesh::topology(type).nodes.end());
        for (const auto& point : mesh::volume_rule(type)) samples.push_back(point.xi);
        for (const Point& xi : samples) {
            std::array<Point, 3> was{}, is{};
            const auto shapes = mesh::shape_values(type, xi);
            for (std::size_t a = 0; a < nodes.size(); ++a)
                for (std::size_t i = 0; i < 3; ++i)
                    for (std::size_t k = 0; k < 3; ++k) {
                        was[i][k] += shapes[a].gradient[i] * model_.mesh.point(nodes[a])[k];
                        is[i][k] += shapes[a].gradient[i] * now.point(nodes[a])[k];
                    }
            minimum = std::min(minimum, determinant(is, now.dimension) / determinant(was, now.dimension));
        }
    }
    return minimum;
}

}  // namespace soft::campaign
