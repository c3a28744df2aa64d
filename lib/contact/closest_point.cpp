#include "contact/closest_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace soft::contact {

namespace {

using mesh::Point;
using surface::FacetPoint;

constexpr int iteration_limit = 50;
/// In reference coordinates; the error of the distance is of the order of its square.
constexpr double xi_tolerance = 1e-12;
/// Iterates of the interior search may leave the facet by this much before it is abandoned for the edges.
constexpr double beyond = 1.0;

/// Near the boundary of a facet, the distances of the minimum in the interior and of one on the boundary are equal in floating-point
/// numbers although their positions are not: the first is taken.
bool is_closer(double distance, double than) { return distance < than * (1 - 1e-6); }

/// Derivatives of half the squared distance in given directions.
struct Derivatives {
    std::array<double, 2> gradient{};
    std::array<std::array<double, 2>, 2> hessian{}, metric{};
};

Derivatives derivatives(const FacetJet& at, const Point& x, std::span<const FacetPoint> directions) {
    const Vector3 r = difference(at.y, x);
    Derivatives found;
    std::array<Vector3, 2> t{};
    for (std::size_t a = 0; a < directions.size(); ++a)
        for (std::size_t d = 0; d < 3; ++d)
            t[a][d] = directions[a][0] * at.first[0][d] + directions[a][1] * at.first[1][d];
    for (std::size_t a = 0; a < directions.size(); ++a) {
        found.gradient[a] = dot(t[a], r);
        for (std::size_t b = 0; b < directions.size(); ++b) {
            found.metric[a][b] = found.hessian[a][b] = dot(t[a], t[b]);
            for (std::size_t i = 0; i < 2; ++i)
                for (std::size_t j = 0; j < 2; ++j)
                    found.hessian[a][b] += directions[a][i] * directions[b][j] * dot(at.second[i][j], r);
        }
    }
    return found;
}

/// Newton's step, by the metric where the Hessian is not positive definite.
std::array<double, 2> newton_step(const Derivatives& f, std::size_t count) {
    if (count == 1) {
        const double slope = f.hessian[0][0] > 0 ? f.hessian[0][0] : f.metric[0][0];
        return {-f.gradient[0] / slope, 0};
    }
    const auto determinant = [](const auto& m) { return m[0][0] * m[1][1] - m[0][1] * m[1][0]; };
    const bool definite = f.hessian[0][0] > 0 && determinant(f.hessian) > 1e-6 * determinant(f.metric);
    const auto& m = definite ? f.hessian : f.metric;
    const double det = determinant(m);
    return {(-f.gradient[0] * m[1][1] + f.gradient[1] * m[0][1]) / det,
            (-f.gradient[1] * m[0][0] + f.gradient[0] * m[1][0]) / det};
}

double distance_at(const Patch& facet, const FacetPoint& xi, const Point& x) {
    return norm(difference(facet(xi).x, x));
}

/// Minimum in the interior; nullopt if the search leaves the facet.
std::optional<ClosestPoint> search_interior(const Patch& facet, const Point& x, FacetPoint xi) {
    const mesh::Shape shape = mesh::topology(facet.type).shape;
    const std::size_t count = shape == mesh::Shape::line ? 1 : 2;
    const std::array<FacetPoint, 2> directions{FacetPoint{1, 0}, FacetPoint{0, 1}};
    for (int i = 0; i < iteration_limit; ++i) {
        const auto step = newton_step(derivatives(jet(facet, xi), x, std::span{directions}.first(count)), count);
        const double largest = std::max(std::abs(step[0]), std::abs(step[1])),
                     share = largest > 0.5 ? 0.5 / largest : 1;
        xi = {xi[0] + share * step[0], xi[1] + share * step[1]};
        if (!surface::is_inside(shape, xi, -beyond)) return std::nullopt;
        if (largest < xi_tolerance) {
            if (!surface::is_inside(shape, xi, 0)) return std::nullopt;
            return ClosestPoint{distance_at(facet, xi, x), xi, directions, static_cast<int>(count), 0, true};
        }
    }
    return std::nullopt;
}

}  // namespace

FacetJet jet(const Patch& facet, const FacetPoint& xi) {
    const auto [s, t] = xi;
    const auto value = facet(xi);
    FacetJet at{value.x, {value.t1, facet.is_line() ? Vector3{} : value.t2}, {}};
    const auto& c = facet.c;
    for (std::size_t d = 0; d < 3; ++d) {
        at.second[0][0][d] = 2 * (c[6][d] + t * (c[7][d] + t * c[8][d]));
        if (facet.is_line()) continue;
        at.second[1][1][d] = 2 * (c[2][d] + s * (c[5][d] + s * c[8][d]));
        at.second[0][1][d] = at.second[1][0][d] = c[4][d] + 2 * s * c[7][d] + 2 * t * c[5][d] + 4 * s * t * c[8][d];
    }
    return at;
}

std::array<std::size_t, 2> edge_corners(mesh::CellType facet, std::size_t k) {
    return {k, (k + 1) % static_cast<std::size_t>(mesh::topology(facet).vertex_count)};
}

ClosestPoint closest_on_edge(const Patch& facet, std::size_t k, const Point& x) {
    const auto [first, last] = edge_corners(facet.type, k);
    const auto &a = mesh::topology(facet.type).nodes[first], &b = mesh::topology(facet.type).nodes[last];
    const FacetPoint half{0.5 * (b[0] - a[0]), 0.5 * (b[1] - a[1])}, middle{0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
    const auto at = [&](double s) { return FacetPoint{middle[0] + s * half[0], middle[1] + s * half[1]}; };
    double s = 0, best = distance_at(facet, at(0), x);
    for (const double end : {-1.0, 1.0})
        if (const double there = distance_at(facet, at(end), x); there < best) {
            s = end;
            best = there;
        }
    for (int i = 0; i < iteration_limit; ++i) {
        const auto f = derivatives(jet(facet, at(s)), x, std::span{&half, 1});
        const double next = std::clamp(s + std::clamp(newton_step(f, 1)[0], -0.5, 0.5), -1.0, 1.0);
        const double moved = std::abs(next - s);
        s = next;
        if (moved < xi_tolerance) break;
    }
    return {distance_at(facet, at(s), x), at(s), {half, {}}, std::abs(s) == 1.0 ? 0 : 1, k, false};
}

ClosestPoint at_corner(const Patch& facet, std::size_t corner, const Point& x) {
    const auto& xi = mesh::topology(facet.type).nodes[corner];
    return {norm(difference(facet.nodes[corner], x)), {xi[0], xi[1]}, {}, 0, 0, false};
}

ClosestPoint closest_point(const Patch& facet, const Point& x) {
    const mesh::CellTopology& topology = mesh::topology(facet.type);
    FacetPoint start{};
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t a = 0; a < static_cast<std::size_t>(topology.node_count); ++a)
        if (const double there = norm(difference(facet.nodes[a], x)); there < nearest) {
            nearest = there;
            start = {topology.nodes[a][0], topology.nodes[a][1]};
        }
    auto interior = search_interior(facet, x, start);
    if (interior && !is_closer(nearest, interior->distance_m)) return *interior;
    if (topology.shape == mesh::Shape::line) {
        const bool last = norm(difference(facet.nodes[1], x)) < norm(difference(facet.nodes[0], x));
        const ClosestPoint end = at_corner(facet, last ? 1 : 0, x);
        return end;
    }
    ClosestPoint best;
    best.distance_m = std::numeric_limits<double>::max();
    if (interior) best = *interior;
    for (std::size_t k = 0; k < static_cast<std::size_t>(topology.vertex_count); ++k)
        if (const auto found = closest_on_edge(facet, k, x); is_closer(found.distance_m, best.distance_m)) best = found;
    return best;
}

}  // namespace soft::contact
