#include "solver/error_bar.hpp"

#include <algorithm>
#include <cmath>

namespace soft::solver {
namespace {

/// Factors by which differences fall from level to level: the slowest part, an intermediate one, and that of second-order cells
/// with a smooth solution.
constexpr double slow = 5.0 / 3, middle = 4, fast = 16;
constexpr double safety = 1.2;              ///< safety factor for three meshes
constexpr double single_cell_safety = 1.5;  ///< for two meshes, the coarse one with one cell through its walls
/// Fraction of the neighbourhood's error that a row's error is at least.
constexpr double min_share = 0.5;
constexpr double neighbourhood = 0.25;  ///< fraction of the path's length, either way
/// Weight of the farthest neighbour, whose differences bound the errors of two meshes.
constexpr double min_weight = 0.1;
/// Of two levels' differences over a neighbourhood that fall at a known rate.
constexpr double min_correlation = 0.8, slowest_settled = 1.25, fastest_settled = 2 * fast;
constexpr double nearest_start =
    0.02;  ///< fraction of the ranges: lower bound of the distance from the start to which differences are relative

/// Remaining error of a part that falls by rho per level, over the difference to the next level.
constexpr double still_to_come(double rho) { return rho / (rho - 1); }

/// A row in coordinates divided by their ranges.
struct Scaled {
    double load = 0, measure = 0;
    double cosine = 1, sine = 0;            ///< tangent in (measure, load)
    double along = 0;                       ///< path length up to here
    double from_start = 0;                  ///< distance
    double d = 0, before = 0, earlier = 0;  ///< to the next finer level: of the reported and two coarser levels
    double error = 0;                       ///< estimated from the differences, >= 0
    double curvature = 0;
};

struct Ranges {
    double load = 0, measure = 0;
};

Ranges ranges_of(std::span<const LevelRow> rows) {
    Ranges ranges;
    const auto range = [&](double CurvePoint::*member) {
        double low = rows.front().reported.*member, high = low;
        for (const LevelRow& row : rows) {
            low = std::min(low, row.reported.*member);
            high = std::max(high, row.reported.*member);
        }
        return high > low ? high - low : 1;
    };
    ranges.load = range(&CurvePoint::load);
    ranges.measure = range(&CurvePoint::measure);
    return ranges;
}

/// Missing tangents are taken from the row before to the row after.
void set_tangents(std::span<const LevelRow> rows, const Ranges& ranges, std::vector<Scaled>& path) {
    for (std::size_t i = 0; i < path.size(); ++i) {
        double dm = rows[i].tangent.measure / ranges.measure, dp = rows[i].tangent.load / ranges.load;
        if (dm == 0 && dp == 0) {
            const Scaled &before = path[i > 0 ? i - 1 : i], &after = path[std::min(i + 1, path.size() - 1)];
            dm = after.measure - before.measure;
            dp = after.load - before.load;
        }
        const double length = std::hypot(dm, dp);
        if (length > 0) {
            path[i].cosine = dm / length;
            path[i].sine = dp / length;
        }
    }
}

void set_curvatures(std::vector<Scaled>& path) {
    for (std::size_t i = 1; i < path.size(); ++i) {
        Scaled &a = path[i - 1], &b = path[i];
        const double length = b.along - a.along;
        if (!(length > 0)) continue;
        const double turn =
            std::abs(std::atan2(a.cosine * b.sine - a.sine * b.cosine, a.cosine * b.cosine + a.sine * b.sine));
        a.curvature = std::max(a.curvature, turn / length);
        b.curvature = std::max(b.curvature, turn / length);
    }
}

std::vector<Scaled> scaled(std::span<const LevelRow> rows, const Ranges& ranges) {
    std::vector<Scaled> path(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        path[i].load = rows[i].reported.load / ranges.load;
        path[i].measure = rows[i].reported.measure / ranges.measure;
    }
    set_tangents(rows, ranges, path);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        Scaled& at = path[i];
        const auto across = [&](const CurvePoint& a, const CurvePoint& b) {
            return at.cosine * (a.load - b.load) / ranges.load - at.sine * (a.measure - b.measure) / ranges.measure;
        };
        at.d = across(rows[i].reported, rows[i].finer);
        if (rows[i].before) at.before = across(*rows[i].before, rows[i].reported);
        if (rows[i].earlier) at.earlier = across(*rows[i].earlier, *rows[i].before);
        at.from_start = std::hypot(at.load - path[0].load, at.measure - path[0].measure);
        if (i > 0)
            at.along = path[i - 1].along + std::hypot(at.load - path[i - 1].load, at.measure - path[i - 1].measure);
    }
    set_curvatures(path);
    return path;
}

/// Calls f(row, weight, scale) for the rows near row i: weights fall with the distance along the path; multiplying by `scale` makes
/// values relative to the distance from the start.
template <class F>
void for_neighbours(const std::vector<Scaled>& path, std::size_t i, F&& f) {
    const double width = neighbourhood * path.back().along;
    for (const Scaled& row : path) {
        const double distance = std::abs(row.along - path[i].along);
        if (!(row.from_start > 0) || distance > width) continue;
        f(row, 1 - distance / width * (1 - 1e-3), 1 / std::max(row.from_start, nearest_start));
    }
}

/// Whether the differences of two levels, the coarser one first, are correlated and their ratio is that of a possible rate.
bool settled(const std::vector<Scaled>& path, std::size_t i, double Scaled::*before, double Scaled::*d,
             double slowest = slowest_settled) {
    double squares = 0, squares_before = 0, products = 0;
    for_neighbours(path, i, [&](const Scaled& row, double weight, double scale) {
        const double w = weight * scale * scale;
        squares += w * row.*d * row.*d;
        squares_before += w * row.*before * row.*before;
        products += w * row.*d * row.*before;
    });
    const double norm = std::sqrt(squares), norm_before = std::sqrt(squares_before);
    return products >= min_correlation * norm * norm_before && norm_before >= slowest * norm &&
           norm_before <= fastest_settled * norm;
}

/// The error from two parts of any sign, one slow and one fast, whose sums are the differences.
double of_two_parts(double before, double d) {
    const double rapid = (before - slow * d) / (fast - slow);  // the fast part of d
    return still_to_come(slow) * (d - rapid) + still_to_come(fast) * rapid;
}

/// The same with an intermediate third part.
double of_three_parts(double earlier, double before, double d) {
    // Without their slow part the differences are sums of two: (4 - 5/3) m + (16 - 5/3) f, and one level earlier.
    const double late = before - slow * d, early = earlier - slow * before;
    const double rapid = (early - middle * late) / ((fast - slow) * (fast - middle));
    const double medium = (late - (fast - slow) * rapid) / (middle - slow);
    return still_to_come(slow) * (d - medium - rapid) + still_to_come(middle) * medium + still_to_come(fast) * rapid;
}

/// Whether both pairs of differences are settled, or the last pair has a rate that no intermediate part has.
bool three_levels_agree(const std::vector<Scaled>& path, std::size_t i) {
    return settled(path, i, &Scaled::before, &Scaled::d, fast / 2) ||
           (settled(path, i, &Scaled::before, &Scaled::d) && settled(path, i, &Scaled::earlier, &Scaled::before));
}

/// Range of the differences nearby, zero included, relative to the distance from the start.
double range_nearby(const std::vector<Scaled>& path, std::size_t i) {
    double low = 0, high = 0;
    const double width = neighbourhood * path.back().along;
    for_neighbours(path, i, [&](const Scaled& row, double, double scale) {
        const double distance = width > 0 ? std::abs(row.along - path[i].along) / width : 0;
        const double relative = (1 - (1 - min_weight) * distance) * row.d * scale;
        low = std::min(low, relative);
        high = std::max(high, relative);
    });
    return high - low;
}

double expected_error(const std::vector<Scaled>& path, std::size_t i, const LevelRow& row, Walls walls) {
    const Scaled& at = path[i];
    if (!row.before)
        return (walls == Walls::single_cell ? single_cell_safety : 1) * still_to_come(slow) *
               std::max(std::abs(at.d), range_nearby(path, i) * at.from_start);
    double error = std::max(std::abs(of_two_parts(at.before, at.d)), still_to_come(fast) * std::abs(at.d));
    if (row.earlier && !three_levels_agree(path, i))
        error = std::max(error, std::abs(of_three_parts(at.earlier, at.before, at.d)));
    return safety * error;
}

/// Root mean square of the errors nearby, relative to the distance from the start.
double error_nearby(const std::vector<Scaled>& path, std::size_t i) {
    double weights = 0, squares = 0;
    for_neighbours(path, i, [&](const Scaled& row, double weight, double scale) {
        weights += weight;
        squares += weight * row.error * scale * row.error * scale;
    });
    return weights > 0 ? std::sqrt(squares / weights) : 0;
}

/// The curve is shifted by c across itself. Returns how far one coordinate changes at an equal value of the other. `own` and
/// `other` are the components of the tangent in the two coordinates. With s along the curve:
///     own = 1, other = 0:  c;   straight: c / other;   at a limit point of the other, other = 0: sqrt(2 c / curvature).
double shift(double c, double own, double other, double curvature) {
    if (c == 0) return 0;
    own = std::abs(own);
    other = std::abs(other);
    const double bend = 2 * curvature * c * own * own;
    const double away = 2 * c * own / (other + std::sqrt(other * other + bend));
    const double rest = other * other - bend;
    const double towards =
        rest >= 0 ? 2 * c * own / (other + std::sqrt(rest)) : other / (curvature * own);  // the limit point
    const double result = own > 0 ? c * other + own * std::max(away, towards) : c;
    return result < 1 ? result : 1;  // at most the whole range, also on a plateau, where the result is NaN
}

}  // namespace

std::vector<ErrorBar> error_bars(std::span<const LevelRow> rows, Walls walls) {
    if (rows.empty()) return {};
    const Ranges ranges = ranges_of(rows);
    std::vector<Scaled> path = scaled(rows, ranges);
    for (std::size_t i = 0; i < path.size(); ++i) path[i].error = expected_error(path, i, rows[i], walls);
    std::vector<ErrorBar> bars;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const Scaled& at = path[i];
        const double error = std::max(at.error, min_share * error_nearby(path, i) * at.from_start);
        const double c = error + solved_to * at.from_start;
        bars.push_back({shift(c, at.sine, at.cosine, at.curvature) * ranges.load,
                        shift(c, at.cosine, at.sine, at.curvature) * ranges.measure,
                        settled(path, i, &Scaled::before, &Scaled::d) || error <= solved_to * at.from_start});
    }
    return bars;
}

}  // namespace soft::solver
