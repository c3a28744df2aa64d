#include "contact/crossing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace soft::contact {
namespace {

using mesh::Point;
using Weights = std::array<double, 3>;  ///< of a piece's corners
using Triangle = std::array<Point, 3>;

surface::Box grown(surface::Box box, double margin_m) {
    for (std::size_t d = 0; d < 3; ++d) {
        box.low[d] -= margin_m;
        box.high[d] += margin_m;
    }
    return box;
}

double size(const surface::Box& box) { return norm(difference(box.high, box.low)); }

/// Intersection of two segments, as weights of the ends of the first.
Weights on_segment(const Triangle& a, const Triangle& b) {
    const Vector3 u = difference(a[1], a[0]), v = difference(b[1], b[0]), gap = difference(b[0], a[0]);
    const double determinant = u[0] * v[1] - u[1] * v[0], length2 = dot(u, u);
    double s = (gap[0] * v[1] - gap[1] * v[0]) / determinant;
    if (std::abs(determinant) <= 1e-12 * std::sqrt(length2 * dot(v, v))) {  // collinear: middle of the overlap
        const double from = dot(gap, u) / length2, to = dot(difference(b[1], a[0]), u) / length2;
        s = (std::clamp(from, 0.0, 1.0) + std::clamp(to, 0.0, 1.0)) / 2;
    }
    s = std::clamp(s, 0.0, 1.0);
    return {1 - s, s, 0};
}

Weights weights_at(const Triangle& t, const Point& x) {
    const Vector3 e1 = difference(t[1], t[0]), e2 = difference(t[2], t[0]), r = difference(x, t[0]), n = cross(e1, e2);
    const double w1 = dot(cross(r, e2), n) / dot(n, n), w2 = dot(cross(e1, r), n) / dot(n, n);
    return {1 - w1 - w2, w1, w2};
}

/// Calls `found` for each point where an edge of `edges` intersects the triangle `through`.
template <class Found>
void for_each_piercing(const Triangle& edges, const Triangle& through, const Found& found) {
    const Vector3 n = cross(difference(through[1], through[0]), difference(through[2], through[0]));
    for (std::size_t i = 0; i < 3; ++i) {
        const Point &p = edges[i], &q = edges[(i + 1) % 3];
        const double from = dot(n, difference(p, through[0])), to = dot(n, difference(q, through[0]));
        if ((from > 0) == (to > 0)) continue;
        const Point x = along(p, from / (from - to), difference(q, p));
        const Weights inside = weights_at(through, x);
        if (std::min({inside[0], inside[1], inside[2]}) >= 0) found(x);
    }
}

/// Middle of the intersection of two triangles, as weights of the corners of the first; its centre if they only touch.
Weights on_triangle(const Triangle& a, const Triangle& b) {
    Weights sum{};
    int count = 0;
    const auto add = [&](const Point& x) {
        const Weights w = weights_at(a, x);
        for (std::size_t i = 0; i < 3; ++i) sum[i] += w[i];
        ++count;
    };
    for_each_piercing(a, b, add);
    for_each_piercing(b, a, add);
    if (count == 0) return {1 / 3.0, 1 / 3.0, 1 / 3.0};
    for (double& w : sum) w /= count;
    return sum;
}

/// The pieces of a facet whose bounding boxes overlap `box`.
std::vector<std::size_t> pieces_near(const DividedFacets& facets, const DividedShape& shape, std::size_t f,
                                     const surface::Box& box) {
    std::vector<std::size_t> near;
    const Division& division = facets.division(f);
    const auto points = facets.points(shape, f);
    for (std::size_t i = 0; i < division.pieces.size(); ++i) {
        const auto corners = piece_corners(points, division.pieces[i]);
        if (overlap(box_of(std::span{corners}.first(division.corners)), box)) near.push_back(i);
    }
    return near;
}

/// For each point of the first facet the coincident point of the second, or -1.
std::vector<int> common_points(const FacetPair& pair, const DividedShape& undeformed) {
    const auto P = pair.facets->points(undeformed, pair.first), Q = pair.facets->points(undeformed, pair.second);
    const double tolerance_m =
        coincidence_tolerance * std::min(size(undeformed.boxes[pair.first]), size(undeformed.boxes[pair.second]));
    std::vector<int> same;
    for (const Point& p : P) {
        const auto found =
            std::find_if(Q.begin(), Q.end(), [&](const Point& q) { return norm(difference(p, q)) <= tolerance_m; });
        same.push_back(found == Q.end() ? -1 : static_cast<int>(found - Q.begin()));
    }
    return same;
}

bool share(const std::vector<int>& same, const std::array<int, 3>& a, const std::array<int, 3>& b) {
    for (const int i : a)
        if (i >= 0 && same[static_cast<std::size_t>(i)] >= 0 &&
            std::find(b.begin(), b.end(), same[static_cast<std::size_t>(i)]) != b.end())
            return true;
    return false;
}

/// Calls `visit` for pairs of pieces whose bounding boxes are within `margin_m` in `shape`, until it returns false.
template <class Visit>
void for_each_near(const FacetPair& pair, const DividedShape& undeformed, const DividedShape& shape, double margin_m,
                   const Visit& visit) {
    const DividedFacets& facets = *pair.facets;
    const surface::Box first = grown(shape.boxes[pair.first], margin_m);
    const auto ours = pieces_near(facets, shape, pair.first, grown(shape.boxes[pair.second], margin_m));
    const auto theirs = pieces_near(facets, shape, pair.second, first);
    if (ours.empty() || theirs.empty()) return;
    const std::vector<int> same = pair.are_neighbours() ? common_points(pair, undeformed) : std::vector<int>{};
    const Division &mine = facets.division(pair.first), &other = facets.division(pair.second);
    const auto P = facets.points(shape, pair.first), Q = facets.points(shape, pair.second);
    for (const std::size_t i : ours) {
        const Triangle a = piece_corners(P, mine.pieces[i]);
        const surface::Box box = grown(box_of(std::span{a}.first(mine.corners)), margin_m);
        for (const std::size_t j : theirs) {
            const Triangle b = piece_corners(Q, other.pieces[j]);
            if (!overlap(box, box_of(std::span{b}.first(other.corners)))) continue;
            if (!same.empty() && share(same, mine.pieces[i], other.pieces[j])) continue;
            if (!visit(i, std::span{a}.first(mine.corners), std::span{b}.first(other.corners), a, b)) return;
        }
    }
}

}  // namespace

bool FacetPair::are_neighbours() const {
    const auto a = facets->nodes(first), b = facets->nodes(second);
    return std::any_of(a.begin(), a.end(),
                       [&](mesh::Index node) { return std::find(b.begin(), b.end(), node) != b.end(); });
}

std::optional<surface::FacetPoint> find_crossing(const FacetPair& pair, const DividedShape& undeformed,
                                                 const DividedShape& now, double least_overlap_m) {
    const Division& division = pair.facets->division(pair.first);
    surface::FacetPoint sum{};
    int count = 0;
    for_each_near(pair, undeformed, now, 0,
                  [&](std::size_t piece, surface::Corners a, surface::Corners b, const Triangle& s, const Triangle& t) {
                      if (!surface::intersect(a, b)) return true;
                      if (std::min(surface::reach_m(a, b), surface::reach_m(b, a)) < least_overlap_m) return true;
                      const Weights weights = a.size() == 2 ? on_segment(s, t) : on_triangle(s, t);
                      for (std::size_t i = 0; i < a.size(); ++i)
                          for (std::size_t d = 0; d < 2; ++d)
                              sum[d] +=
                                  weights[i] * division.xi[static_cast<std::size_t>(division.pieces[piece][i])][d];
                      ++count;
                      return true;
                  });
    if (count == 0) return std::nullopt;
    return surface::FacetPoint{sum[0] / count, sum[1] / count};
}

bool is_touching(const FacetPair& pair, const DividedShape& undeformed) {
    const double near_m =
        coincidence_tolerance * std::min(size(undeformed.boxes[pair.first]), size(undeformed.boxes[pair.second]));
    bool found = false;
    for_each_near(pair, undeformed, undeformed, near_m,
                  [&](std::size_t, surface::Corners a, surface::Corners b, const Triangle&, const Triangle&) {
                      found = surface::is_within(a, b, near_m);
                      return !found;
                  });
    return found;
}

bool is_visible_from_one_side(const NormalCone& a, const NormalCone& b) {
    const double between = std::acos(std::clamp(dot(a.axis, b.axis), -1.0, 1.0));
    return between + a.angle + b.angle < std::numbers::pi;
}

}  // namespace soft::contact
