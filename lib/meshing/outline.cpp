#include "meshing/outline.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "core/text.hpp"

namespace soft::meshing {
namespace {

double distance_to(const OutlinePiece& piece, PlanePoint p) {
    const PlanePoint along = minus(piece.end, piece.start), to = minus(p, piece.start);
    const double square = dot(along, along);
    const double share = square > 0 ? std::clamp(dot(to, along) / square, 0.0, 1.0) : 0.0;
    return length(minus(to, {share * along[0], share * along[1]}));
}

bool cross_each_other(const OutlinePiece& a, const OutlinePiece& b) {
    const auto sides = [](const OutlinePiece& line, PlanePoint one, PlanePoint other) {
        const PlanePoint along = minus(line.end, line.start);
        return cross(along, minus(one, line.start)) * cross(along, minus(other, line.start));
    };
    return sides(a, b.start, b.end) < 0 && sides(b, a.start, a.end) < 0;
}

bool are_near(const OutlinePiece& a, const OutlinePiece& b, double near_m) {
    for (std::size_t d = 0; d < 2; ++d) {
        const auto [a_low, a_high] = std::minmax(a.start[d], a.end[d]);
        const auto [b_low, b_high] = std::minmax(b.start[d], b.end[d]);
        if (a_low > b_high + near_m || b_low > a_high + near_m) return false;
    }
    return true;
}

bool touch(const OutlinePiece& a, const OutlinePiece& b, double near_m) {
    return cross_each_other(a, b) || distance_to(a, b.start) < near_m || distance_to(a, b.end) < near_m ||
           distance_to(b, a.start) < near_m || distance_to(b, a.end) < near_m;
}

/// Whether two consecutive pieces run back over each other.
bool folds(const OutlinePiece& before, const OutlinePiece& after, double near_m) {
    const PlanePoint back = minus(before.start, before.end), on = minus(after.end, after.start);
    return dot(back, on) > 0 && (distance_to(before, after.end) < near_m || distance_to(after, before.start) < near_m);
}

constexpr int steps_per_span = 10;

/// Total absolute turn of the spline between one of its points and the next.
double span_turn_rad(const std::vector<PlanePoint>& points, std::size_t span) {
    constexpr int chords = 4;
    double turn_rad = 0;
    PlanePoint before{}, from = points[span];
    for (int k = 1; k <= chords; ++k) {
        const PlanePoint to = spline_at(points, static_cast<double>(span) + static_cast<double>(k) / chords);
        const PlanePoint chord = minus(to, from);
        if (k > 1) turn_rad += std::abs(std::atan2(cross(before, chord), dot(before, chord)));
        before = chord;
        from = to;
    }
    return turn_rad * chords / (chords - 1);  // half a chord at each end is not counted
}

std::vector<PlanePoint> even_polyline(const std::vector<PlanePoint>& points) {
    std::vector<PlanePoint> line;
    const int steps = steps_per_span * static_cast<int>(points.size() - 1);
    for (int k = 0; k <= steps; ++k) line.push_back(spline_at(points, static_cast<double>(k) / steps_per_span));
    return line;
}

std::string location_text(PlanePoint p) {
    std::string text{"("};  // operator+ causes a false overlap warning in g++ 12
    return text.append(core::rounded_text(1e3 * p[0], 5))
        .append(", ")
        .append(core::rounded_text(1e3 * p[1], 5))
        .append(") mm");
}

const OutlineEdge& edge_of(const Outline& outline, const OutlinePiece& piece) {
    return outline.loops[piece.loop][piece.edge];
}

std::optional<OutlineFault> repeated_point(const Outline& outline, double near_m) {
    for (const Loop& loop : outline.loops)
        for (const OutlineEdge& edge : loop) {
            for (std::size_t i = 0; i + 1 < edge.points.size(); ++i)
                if (length(minus(edge.points[i + 1], edge.points[i])) < near_m)
                    return OutlineFault{edge.row,
                                        "the point " + location_text(edge.points[i]) + " appears twice in a row",
                                        "remove one; the last point is connected to the first automatically"};
            const bool closed = length(minus(edge.points.front(), edge.points.back())) < near_m;
            if (closed && edge.shape != OutlineEdge::Shape::spline)
                return OutlineFault{edge.row, "the edge ends where it starts", "use three points or more"};
        }
    return std::nullopt;
}

/// Limits the number of pieces, because all pairs are compared: up to two seconds for the maximum.
std::optional<OutlineFault> too_many(const Outline& outline) {
    constexpr std::size_t max_pieces = 20000;
    const std::vector<OutlinePiece> pieces = pieces_of(outline);
    if (pieces.size() <= max_pieces) return std::nullopt;
    std::string problem{"more than "};  // operator+ causes a false overlap warning in g++ 12
    problem.append(std::to_string(max_pieces)).append(" straight pieces, up to ten per span of a spline");
    return OutlineFault{edge_of(outline, pieces[max_pieces]).row, problem, "draw the outline with fewer points"};
}

std::optional<OutlineFault> intersection(const Outline& outline, double near_m) {
    const std::vector<OutlinePiece> pieces = pieces_of(outline);
    for (std::size_t i = 0; i < pieces.size(); ++i)
        for (std::size_t j = i + 1; j < pieces.size(); ++j) {
            const OutlinePiece &a = pieces[i], &b = pieces[j];
            if (!are_near(a, b, near_m)) continue;
            const bool follows = j == i + 1 && a.loop == b.loop;
            const bool precedes = a.loop == b.loop && a.first_of_loop && b.last_of_loop;
            if (follows ? folds(a, b, near_m) : precedes ? folds(b, a, near_m) : touch(a, b, near_m)) {
                const std::size_t row = edge_of(outline, a).row, other = edge_of(outline, b).row;
                const std::string what = row == other ? "itself" : "the edge of line " + std::to_string(other);
                return OutlineFault{
                    row, "the edge crosses, touches or runs back over " + what + " near " + location_text(b.start),
                    "an outline must enclose the solid once"};
            }
        }
    return std::nullopt;
}

std::optional<OutlineFault> wrong_orientation(const Outline& outline) {
    std::size_t outer = 0;
    for (std::size_t i = 1; i < outline.loops.size(); ++i)
        if (std::abs(area_m2(outline.loops[i])) > std::abs(area_m2(outline.loops[outer]))) outer = i;
    const auto pieces = pieces_of(outline);
    const auto only = [&](std::size_t loop) {
        std::vector<OutlinePiece> own;
        std::ranges::copy_if(pieces, std::back_inserter(own),
                             [&](const OutlinePiece& piece) { return piece.loop == loop; });
        return own;
    };
    const std::string remedy = "reverse the order of its points (each tag moves to the row where its edge now starts)";
    for (std::size_t i = 0; i < outline.loops.size(); ++i) {
        const Loop& loop = outline.loops[i];
        const bool counter_clockwise = area_m2(loop) > 0;
        if (i == outer && !counter_clockwise)
            return OutlineFault{loop.front().row, "the outline is clockwise: the solid would lie outside it", remedy};
        if (i == outer) continue;
        for (std::size_t other = 0; other < outline.loops.size(); ++other)
            if (other != i && is_inside(only(other), loop.front().points.front()) != (other == outer))
                return OutlineFault{
                    loop.front().row,
                    other == outer ? "this loop lies outside the largest one" : "this loop lies inside another hole",
                    "use one outline and holes in it: a section is one body"};
        if (counter_clockwise)
            return OutlineFault{loop.front().row,
                                "the loop of the hole is counter-clockwise: the solid would lie inside it", remedy};
    }
    return std::nullopt;
}

}  // namespace

PlanePoint OutlineArc::at(double share) const {
    const double angle = start_rad + share * turn_rad;
    return {centre[0] + radius_m * std::cos(angle), centre[1] + radius_m * std::sin(angle)};
}

OutlineArc arc_of(const OutlineEdge& edge) {
    // The centre has equal distances from all three points: two linear equations, relative to the first point.
    const PlanePoint &start = edge.points[0], &end = edge.points[2];
    const PlanePoint u = minus(edge.points[1], start), v = minus(end, start);
    const double twice = 2 * cross(u, v), uu = dot(u, u), vv = dot(v, v);
    const PlanePoint to_centre{(uu * v[1] - vv * u[1]) / twice, (vv * u[0] - uu * v[0]) / twice};
    OutlineArc arc{{start[0] + to_centre[0], start[1] + to_centre[1]}, length(to_centre), 0, 0};
    const auto angle = [&](const PlanePoint& p) { return std::atan2(p[1] - arc.centre[1], p[0] - arc.centre[0]); };
    arc.start_rad = angle(start);
    arc.turn_rad = angle(end) - arc.start_rad;
    constexpr double round = 2 * std::numbers::pi;
    if (twice > 0 && arc.turn_rad <= 0) arc.turn_rad += round;
    if (twice < 0 && arc.turn_rad >= 0) arc.turn_rad -= round;
    return arc;
}

PlanePoint spline_at(const std::vector<PlanePoint>& points, double span) {
    const std::size_t last = points.size() - 1;
    const bool closed = points.front() == points.back();
    const std::size_t i = std::min(static_cast<std::size_t>(std::max(span, 0.0)), last - 1);
    const double t = span - static_cast<double>(i);
    PlanePoint result{};
    for (std::size_t d = 0; d < 2; ++d) {
        const double p1 = points[i][d], p2 = points[i + 1][d];
        const double p0 = i > 0 ? points[i - 1][d] : closed ? points[last - 1][d] : 2 * p1 - p2;
        const double p3 = i + 2 <= last ? points[i + 2][d] : closed ? points[1][d] : 2 * p2 - p1;
        result[d] = p1 + 0.5 * t * (p2 - p0 + t * (2 * p0 - 5 * p1 + 4 * p2 - p3 + t * (3 * (p1 - p2) + p3 - p0)));
    }
    return result;
}

PlanePoint point_at(const OutlineEdge& edge, double share) {
    const PlanePoint &start = edge.points.front(), &end = edge.points.back();
    switch (edge.shape) {
        case OutlineEdge::Shape::line: break;
        case OutlineEdge::Shape::arc: return arc_of(edge).at(share);
        case OutlineEdge::Shape::spline:
            return spline_at(edge.points, share * static_cast<double>(edge.points.size() - 1));
    }
    return {start[0] + share * (end[0] - start[0]), start[1] + share * (end[1] - start[1])};
}

std::vector<PlanePoint> polyline(const OutlineEdge& edge) {
    constexpr double step_rad = 3 * std::numbers::pi / 180;
    std::vector<PlanePoint> line{edge.points.front()};
    if (edge.shape == OutlineEdge::Shape::arc) {
        const OutlineArc arc = arc_of(edge);
        const int steps = static_cast<int>(std::ceil(std::abs(arc.turn_rad) / step_rad));
        for (int k = 1; k < steps; ++k) line.push_back(arc.at(static_cast<double>(k) / steps));
    } else if (edge.shape == OutlineEdge::Shape::spline) {
        for (std::size_t span = 0; span + 1 < edge.points.size(); ++span) {
            const auto at = [&](double t) { return spline_at(edge.points, static_cast<double>(span) + t); };
            const double turn_rad = span_turn_rad(edge.points, span);
            const int steps = std::clamp(static_cast<int>(std::ceil(turn_rad / step_rad)), 1, steps_per_span);
            for (int k = 1; k <= steps; ++k) line.push_back(at(static_cast<double>(k) / steps));
        }
        line.pop_back();  // replaced below by the exact end point
    }
    line.push_back(edge.points.back());
    return line;
}

std::vector<OutlinePiece> pieces_of(const Outline& outline) {
    std::vector<OutlinePiece> pieces;
    for (std::size_t l = 0; l < outline.loops.size(); ++l) {
        const std::size_t first = pieces.size();
        for (std::size_t e = 0; e < outline.loops[l].size(); ++e) {
            const auto line = polyline(outline.loops[l][e]);
            for (std::size_t i = 0; i + 1 < line.size(); ++i)
                pieces.push_back({line[i], line[i + 1], l, e, false, false});
        }
        if (pieces.size() == first) continue;
        pieces[first].first_of_loop = true;
        pieces.back().last_of_loop = true;
    }
    return pieces;
}

double area_m2(const Loop& loop) {
    double twice = 0;
    for (const OutlineEdge& edge : loop) {
        const auto line = edge.shape == OutlineEdge::Shape::spline ? even_polyline(edge.points) : polyline(edge);
        for (std::size_t i = 0; i + 1 < line.size(); ++i) twice += cross(line[i], line[i + 1]);
        if (edge.shape != OutlineEdge::Shape::arc) continue;
        // Area between each chord and the true arc: R^2 (t - sin t)/2.
        const OutlineArc arc = arc_of(edge);
        const double pieces = static_cast<double>(line.size() - 1), turn = arc.turn_rad / pieces;
        twice += pieces * arc.radius_m * arc.radius_m * (turn - std::sin(turn));
    }
    return 0.5 * twice;
}

bool is_inside(const std::vector<OutlinePiece>& pieces, PlanePoint point) {
    bool inside = false;
    for (const OutlinePiece& piece : pieces) {
        if ((piece.start[1] > point[1]) == (piece.end[1] > point[1])) continue;
        const double share = (point[1] - piece.start[1]) / (piece.end[1] - piece.start[1]);
        if (point[0] < piece.start[0] + share * (piece.end[0] - piece.start[0])) inside = !inside;
    }
    return inside;
}

PlanePoint extents_m(const Outline& outline) {
    PlanePoint low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
    for (const Loop& loop : outline.loops)
        for (const OutlineEdge& edge : loop)
            for (const PlanePoint& p : edge.points)
                for (std::size_t d = 0; d < 2; ++d) {
                    low[d] = std::min(low[d], p[d]);
                    high[d] = std::max(high[d], p[d]);
                }
    return minus(high, low);
}

double extent_m(const Outline& outline) {
    const PlanePoint sides = extents_m(outline);
    return std::max(sides[0], sides[1]);
}

std::optional<OutlineFault> fault_of(const Outline& outline) {
    const double near_m = outline_tolerance * extent_m(outline);
    if (auto fault = repeated_point(outline, near_m)) return fault;
    if (auto fault = too_many(outline)) return fault;
    if (auto fault = intersection(outline, near_m)) return fault;
    return wrong_orientation(outline);
}

}  // namespace soft::meshing
