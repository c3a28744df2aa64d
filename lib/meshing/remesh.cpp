#include "meshing/remesh.hpp"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "surface/facet_map.hpp"
#include "surface/near.hpp"

namespace soft::meshing {
namespace {

using CgalPoint = CGAL::Simple_cartesian<double>::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<CgalPoint>;
using Vertex = SurfaceMesh::Vertex_index;
using Halfedge = SurfaceMesh::Halfedge_index;
using EdgeIndex = SurfaceMesh::Edge_index;
using mesh::Point;

double distance(const Point& a, const Point& b) { return norm(difference(b, a)); }
Vector3 area_vector(const std::array<Point, 3>& t) { return cross(difference(t[1], t[0]), difference(t[2], t[0])); }

/// Shape quality: 1 for an equilateral triangle, 0 for a degenerate one: 2 sqrt(3) |area vector| / sum of the squared edge lengths.
double shape_of(const std::array<Point, 3>& t) {
    double squares = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double length = distance(t[k], t[(k + 1) % 3]);
        squares += length * length;
    }
    return squares > 0 ? 2 * std::sqrt(3.0) * norm(area_vector(t)) / squares : 0;
}

class Remesher {
public:
    Remesher(const BodySurface& surface, const Creases& creases, const SizeAt& size_m)
        : size_m_(size_m), original_(surface.points, surface.triangles) {
        for (const auto& t : surface.triangles) normals_.push_back(triangle_geometry(surface.points, t).normal);
        if (!creases.empty()) lines_.emplace(surface.points, creases);
        std::vector<Vertex> vertices;
        for (const Point& p : surface.points) vertices.push_back(mesh_.add_vertex({p[0], p[1], p[2]}));
        const auto vertex = [&](int number) { return vertices[static_cast<std::size_t>(number)]; };
        for (const auto& t : surface.triangles) mesh_.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2]));
        sizes_ = mesh_.add_property_map<Vertex, double>("v:size", 0).first;
        creases_ = mesh_.add_property_map<EdgeIndex, bool>("e:crease", false).first;
        fixed_ = mesh_.add_property_map<Vertex, bool>("v:fixed", false).first;
        for (const Vertex v : mesh_.vertices()) sizes_[v] = size_m_(at(v));
        for (const auto& [a, b] : creases) creases_[mesh_.edge(mesh_.halfedge(vertex(a), vertex(b)))] = true;
        for (const Vertex v : mesh_.vertices()) fixed_[v] = is_corner(v);
    }

    /// False if more than `max_points` points would be needed.
    bool run(std::size_t max_points) {
        constexpr int rounds = 6;  // further rounds change almost nothing
        for (int round = 0; round < rounds; ++round) {
            if (!split(max_points)) return false;
            collapse();
            flip();
            move();
        }
        mesh_.collect_garbage();
        return true;
    }

    Remeshed take() {
        Remeshed result;
        for (const Vertex v : mesh_.vertices()) result.points.push_back(at(v));
        for (const auto face : mesh_.faces()) {
            std::array<int, 3> t{};
            std::size_t k = 0;
            for (const Vertex v : CGAL::vertices_around_face(mesh_.halfedge(face), mesh_))
                t[k++] = static_cast<int>(v.idx());
            result.triangles.push_back(t);
        }
        for (const EdgeIndex e : mesh_.edges())
            if (creases_[e]) {
                const auto a = static_cast<int>(mesh_.vertex(e, 0).idx()),
                           b = static_cast<int>(mesh_.vertex(e, 1).idx());
                result.creases.push_back({std::min(a, b), std::max(a, b)});
            }
        return result;
    }

private:
    [[nodiscard]] Point at(Vertex v) const {
        const CgalPoint& p = mesh_.point(v);
        return {p.x(), p.y(), p.z()};
    }
    [[nodiscard]] double length(EdgeIndex e) const { return distance(at(mesh_.vertex(e, 0)), at(mesh_.vertex(e, 1))); }
    [[nodiscard]] double requested(EdgeIndex e) const {
        return (sizes_[mesh_.vertex(e, 0)] + sizes_[mesh_.vertex(e, 1)]) / 2;
    }

    [[nodiscard]] std::vector<EdgeIndex> creases_at(Vertex v) const {
        std::vector<EdgeIndex> found;
        for (const Halfedge h : CGAL::halfedges_around_target(v, mesh_))
            if (creases_[mesh_.edge(h)]) found.push_back(mesh_.edge(h));
        return found;
    }
    [[nodiscard]] Vertex other_end(EdgeIndex e, Vertex v) const {
        return mesh_.vertex(e, 0) == v ? mesh_.vertex(e, 1) : mesh_.vertex(e, 0);
    }

    /// Whether creases end, cross or turn sharply at the vertex.
    [[nodiscard]] bool is_corner(Vertex v) const {
        constexpr double sharp_turn = 0.77;  // cosine of 40 degrees
        const auto own = creases_at(v);
        if (own.empty()) return false;
        if (own.size() != 2) return true;
        const Vector3 a = difference(at(v), at(other_end(own[0], v))), b = difference(at(other_end(own[1], v)), at(v));
        return dot(a, b) < sharp_turn * norm(a) * norm(b);
    }

    [[nodiscard]] std::array<Point, 3> corners(Halfedge h) const {
        return {at(mesh_.source(h)), at(mesh_.target(h)), at(mesh_.target(mesh_.next(h)))};
    }

    /// Whether the triangle lies on the surface of the file to within a fraction of its size, with the same orientation.
    enum class Where { everywhere, in_the_middle };
    [[nodiscard]] bool fits(const std::array<Point, 3>& t, double size_m, Where where = Where::everywhere) const {
        constexpr double share = 0.05, min_cosine = 0.5;
        const Vector3 n = area_vector(t);
        const double area = norm(n);
        if (!(area > 0)) return false;
        const auto near = [&](const Point& p) {
            const auto location = original_.within(p, share * size_m);
            return location && dot(normals_[static_cast<std::size_t>(location->element)], n) >= min_cosine * area;
        };
        const Point centre{(t[0][0] + t[1][0] + t[2][0]) / 3, (t[0][1] + t[1][1] + t[2][1]) / 3,
                           (t[0][2] + t[1][2] + t[2][2]) / 3};
        if (!near(centre)) return false;
        if (where == Where::in_the_middle) return true;
        for (std::size_t k = 0; k < 3; ++k) {  // next to the edges, because on a crease the normal is ambiguous
            const Point &a = t[k], &b = t[(k + 1) % 3];
            if (!near({0.45 * (a[0] + b[0]) + 0.1 * centre[0], 0.45 * (a[1] + b[1]) + 0.1 * centre[1],
                       0.45 * (a[2] + b[2]) + 0.1 * centre[2]}))
                return false;
        }
        return true;
    }

    bool split(std::size_t max_points) {
        constexpr double too_long = 4.0 / 3.0;
        for (bool any = true; any;) {
            any = false;
            std::vector<std::pair<double, EdgeIndex>> pending;
            for (const EdgeIndex e : mesh_.edges())
                if (const double ratio = length(e) / requested(e); ratio > too_long) pending.emplace_back(-ratio, e);
            std::ranges::sort(pending);
            for (const auto& [ratio, e] : pending) {
                if (mesh_.number_of_vertices() >= max_points) return false;
                split(e);
                any = true;
            }
        }
        return true;
    }

    void split(EdgeIndex e) {
        const Point a = at(mesh_.vertex(e, 0)), b = at(mesh_.vertex(e, 1));
        const Point middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
        const bool crease = creases_[e];
        const Point location = crease ? (*lines_)(middle).point : original_(middle).point;
        const Halfedge half = CGAL::Euler::split_edge(mesh_.halfedge(e), mesh_), opposite = mesh_.opposite(half);
        const Vertex v = mesh_.target(half);
        put(v, location, size_m_(location));
        fixed_[v] = false;
        creases_[mesh_.edge(half)] = crease;
        for (const Halfedge across : {CGAL::Euler::split_face(half, mesh_.next(mesh_.next(half)), mesh_),
                                      CGAL::Euler::split_face(mesh_.prev(opposite), mesh_.next(opposite), mesh_)})
            creases_[mesh_.edge(across)] = false;
    }

    void collapse() {
        constexpr double too_short = 0.8;
        std::vector<std::pair<double, EdgeIndex>> pending;
        for (const EdgeIndex e : mesh_.edges())
            if (const double ratio = length(e) / requested(e); ratio < too_short) pending.emplace_back(ratio, e);
        std::ranges::sort(pending);
        for (const auto& [ratio, e] : pending) {
            if (mesh_.is_removed(e) || length(e) >= too_short * requested(e)) continue;
            const Halfedge h = mesh_.halfedge(e);
            const auto one = after_collapse(h), other = after_collapse(mesh_.opposite(h));
            if (!one && !other) continue;
            collapse(other && (!one || *other > *one) ? mesh_.opposite(h) : h);
        }
    }

    /// Worst shape of the triangles around the vertex after collapsing the source of the halfedge into its target; nullopt if the collapse
    /// is not allowed.
    [[nodiscard]] std::optional<double> after_collapse(Halfedge h) const {
        constexpr double too_long = 4.0 / 3.0, worst_shape = 0.05;
        const Vertex from = mesh_.source(h), to = mesh_.target(h);
        if (fixed_[from]) return std::nullopt;
        const bool crease = creases_[mesh_.edge(h)];
        if (!crease && !creases_at(from).empty()) return std::nullopt;
        for (const Halfedge side : {h, mesh_.opposite(h)})  // would merge two creases
            if (creases_[mesh_.edge(mesh_.next(side))] && creases_[mesh_.edge(mesh_.prev(side))]) return std::nullopt;
        if (!CGAL::Euler::does_satisfy_link_condition(mesh_.edge(h), mesh_)) return std::nullopt;
        double worst = 1, worst_before = 1;
        for (const Halfedge in : CGAL::halfedges_around_target(from, mesh_)) {
            const std::array<Point, 3> old = corners(in);
            worst_before = std::min(worst_before, shape_of(old));
            const Vertex next = mesh_.source(in);  // faces of `in`: (next, from, third)
            const Vertex third = mesh_.target(mesh_.next(in));
            if (next == to || third == to) continue;
            const std::array<Point, 3> t{at(next), at(to), at(third)};
            const double size_m = (sizes_[next] + sizes_[to] + sizes_[third]) / 3;
            if (distance(t[0], t[1]) > too_long * (sizes_[next] + sizes_[to]) / 2) return std::nullopt;
            if (distance(t[2], t[1]) > too_long * (sizes_[third] + sizes_[to]) / 2) return std::nullopt;
            worst = std::min(worst, shape_of(t));
            if (!fits(t, size_m)) return std::nullopt;
        }
        if (worst < worst_shape && worst < worst_before) return std::nullopt;
        if (crease && !crease_fits(h)) return std::nullopt;
        return worst;
    }

    /// A collapse along a crease replaces two edges by one, whose midpoint must stay on the crease.
    [[nodiscard]] bool crease_fits(Halfedge h) const {
        constexpr double share = 0.05;
        for (const EdgeIndex e : creases_at(mesh_.source(h))) {
            if (e == mesh_.edge(h)) continue;
            const Vertex end = other_end(e, mesh_.source(h));
            const Point a = at(end), b = at(mesh_.target(h));
            const Point middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
            if ((*lines_)(middle).distance_m > share * sizes_[end]) return false;
        }
        return true;
    }

    /// Collapses the source into the target. For the edge p-q, CGAL removes the edges p-t and q-b; their crease flags are transferred to
    /// the edges that remain.
    void collapse(Halfedge h) {
        const Vertex target = mesh_.target(h);
        const Point location = at(target);
        const double size_m = sizes_[target];
        const bool fixed = fixed_[target];
        const Halfedge pq = mesh_.halfedge(mesh_.edge(h)), qp = mesh_.opposite(pq);
        for (const Halfedge side : {pq, qp}) {
            const EdgeIndex remaining = mesh_.edge(mesh_.next(side)), removed = mesh_.edge(mesh_.prev(side));
            creases_[remaining] = creases_[remaining] || creases_[removed];
        }
        const Vertex kept = CGAL::Euler::collapse_edge(mesh_.edge(h), mesh_);
        put(kept, location, size_m);
        fixed_[kept] = fixed;
    }

    void flip() {
        constexpr double better = 1e-6;  // prevents edges from flipping back and forth by rounding
        for (const EdgeIndex e : mesh_.edges()) {
            if (creases_[e]) continue;
            const Halfedge h = mesh_.halfedge(e), back = mesh_.opposite(h);
            const Vertex a = mesh_.source(h), b = mesh_.target(h), c = mesh_.target(mesh_.next(h)),
                         d = mesh_.target(mesh_.next(back));
            if (mesh_.halfedge(c, d) != SurfaceMesh::null_halfedge()) continue;
            const std::array<Point, 3> one{at(a), at(d), at(c)}, other{at(d), at(b), at(c)};
            if (std::min(shape_of(one), shape_of(other)) <=
                std::min(shape_of(corners(h)), shape_of(corners(back))) + better)
                continue;
            const double size_m = (sizes_[a] + sizes_[b] + sizes_[c] + sizes_[d]) / 4;
            if (fits(one, size_m) && fits(other, size_m)) CGAL::Euler::flip_edge(h, mesh_);
        }
    }

    /// Laplacian smoothing along the surface or the crease: a point moves to the mean of its neighbours if the worst triangle improves.
    void move() {
        constexpr double gain = 1.01;
        for (const Vertex v : mesh_.vertices()) {
            if (fixed_[v]) continue;
            const auto lines = creases_at(v);
            std::vector<Point> around;
            if (lines.empty())
                for (const Halfedge h : CGAL::halfedges_around_target(v, mesh_)) around.push_back(at(mesh_.source(h)));
            for (const EdgeIndex e : lines) around.push_back(at(other_end(e, v)));
            Point middle{};
            for (const Point& p : around)
                for (std::size_t d = 0; d < 3; ++d) middle[d] += p[d] / static_cast<double>(around.size());
            const Point old = at(v), location = lines.empty() ? original_(middle).point : (*lines_)(middle).point;
            const double before = worst_around(v), old_size_m = sizes_[v];
            put(v, location, size_m_(location));
            if (worst_around(v) <= gain * before || !fits_around(v)) put(v, old, old_size_m);
        }
    }

    void put(Vertex v, const Point& location, double size_m) {
        mesh_.point(v) = {location[0], location[1], location[2]};
        sizes_[v] = size_m;
    }

    [[nodiscard]] double worst_around(Vertex v) const {
        double worst = 1;
        for (const Halfedge h : CGAL::halfedges_around_target(v, mesh_)) worst = std::min(worst, shape_of(corners(h)));
        return worst;
    }

    [[nodiscard]] bool fits_around(Vertex v) const {
        for (const Halfedge h : CGAL::halfedges_around_target(v, mesh_))
            if (!fits(corners(h), sizes_[v], Where::in_the_middle)) return false;
        return true;
    }

    SizeAt size_m_;
    surface::NearestOnTriangles original_;
    std::vector<Vector3> normals_;
    std::optional<surface::NearestOnSegments> lines_;
    SurfaceMesh mesh_;
    SurfaceMesh::Property_map<Vertex, double> sizes_;
    SurfaceMesh::Property_map<EdgeIndex, bool> creases_;
    SurfaceMesh::Property_map<Vertex, bool> fixed_;
};

}  // namespace

Remeshed remesh(const BodySurface& surface, const Creases& creases, const SizeAt& size_m, const SoupOrigin& origin,
                std::size_t max_points) {
    Remesher remesher(surface, creases, size_m);
    if (!remesher.run(max_points))
        throw Error(ExitCode::bad_input, origin.name,
                    "cells of this size need more than " + std::to_string(max_points) + " points on the surface",
                    "use a larger mesh.size");
    return remesher.take();
}

}  // namespace soft::meshing
