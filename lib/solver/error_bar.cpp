#include "solver/error_bar.hpp"

#include <algorithm>
#include <cmath>

namespace soft::solver {
namespace {

/// Of the difference to the next level: any rate above 0.87.
constexpr double widest = 2.2;
/// Of measured differences, and never less than.
constexpr double safety = 1.2, narrowest = 1.2;
constexpr double slow = 2, fast = 16;  ///< ratios of differences at rates 1 and 4
/// Of the neighbourhood's difference, where the row's own is smaller.
constexpr double least_share = 0.5;
constexpr double neighbourhood = 0.25;     ///< of the path's length, either way
constexpr double least_correlation = 0.9;  ///< of two levels' differences that fall at one rate
constexpr double nearest_start =
    0.02;  ///< of the ranges: nearer to the start differences are not taken relative to less

/// A row in coordinates divided by their ranges.
struct Scaled {
    double load = 0, measure = 0;
    double cosine = 1, sine = 0;  ///< tangent in (measure, load)
    double along = 0;             ///< path length up to here
    double from_start = 0;        ///< distance
    double d = 0, before = 0;     ///< differences to the finer level, and of the level before to this one
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

/// Tangents that the solver does not give: from the row before to the row after.
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
        at.from_start = std::hypot(at.load - path[0].load, at.measure - path[0].measure);
        if (i > 0)
            at.along = path[i - 1].along + std::hypot(at.load - path[i - 1].load, at.measure - path[i - 1].measure);
    }
    set_curvatures(path);
    return path;
}

/// Relative differences of a neighbourhood.
struct Nearby {
    double difference = 0, before = 0;  ///< root mean squares of d, and of the level before
    double correlation = 0;
};

Nearby nearby(const std::vector<Scaled>& path, std::size_t i) {
    const double width = neighbourhood * path.back().along;
    double weights = 0, squares = 0, squares_before = 0, products = 0;
    for (const Scaled& row : path) {
        const double distance = std::abs(row.along - path[i].along);
        if (!(row.from_start > 0) || distance > width) continue;
        const double weight = 1 - distance / width * (1 - 1e-3),
                     scale = 1 / std::max(row.from_start, nearest_start);  // > 0
        const double d = row.d * scale, before = row.before * scale;
        weights += weight;
        squares += weight * d * d;
        squares_before += weight * before * before;
        products += weight * d * before;
    }
    if (!(weights > 0)) return {};
    const double both = std::sqrt(squares * squares_before);
    return {std::sqrt(squares / weights), std::sqrt(squares_before / weights), both > 0 ? products / both : 0};
}

/// Of the difference to the finer level, so that the bar covers the error.
double share_of_error(const Nearby& near) {
    const double rho = near.difference > 0 ? near.before / near.difference : 0;
    if (near.correlation < least_correlation || rho <= slow) return widest;
    const double share = (std::min(rho, fast) - slow) / (fast - slow);  // of the fast part
    return std::clamp(safety * (share * fast / (fast - 1) + (1 - share) * slow / (slow - 1)), narrowest, widest);
}

/// How far one coordinate of the curve shifted by c across itself is away at an equal value of the other, whose share of
/// the tangent is `other`; `own` that of the first. With s along the curve:
///     own = 1, other = 0:  c;   straight: c / other;   at a limit of the other, other = 0: sqrt(2 c / curvature).
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
    return result < 1 ? result : 1;  // the whole range; of a plateau, where it is NaN, too
}

}  // namespace

std::vector<ErrorBar> error_bars(std::span<const LevelRow> rows) {
    if (rows.empty()) return {};
    const Ranges ranges = ranges_of(rows);
    const std::vector<Scaled> path = scaled(rows, ranges);
    std::vector<ErrorBar> bars;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const Scaled& at = path[i];
        const Nearby near = nearby(path, i);
        const double difference = std::max(std::abs(at.d), least_share * near.difference * at.from_start);
        const double c = share_of_error(near) * difference + solved_to * at.from_start;
        bars.push_back({shift(c, at.sine, at.cosine, at.curvature) * ranges.load,
                        shift(c, at.cosine, at.sine, at.curvature) * ranges.measure});
    }
    return bars;
}

}  // namespace soft::solver
