#include "post/error_bar.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace soft::post {
namespace {

/// Chosen so that one rate anywhere between the slow and the fast one gives a bar less than three times the error:
/// 1.4 x 2.06 where the geometric mean is farthest off.
constexpr double safety = 1.4;
constexpr double neighbourhood = 0.25;  ///< of the path's length, either way
constexpr double least_correlation = 0.5;
constexpr double slow = 2;  ///< ratio of differences at rate 1
constexpr double nearest_start =
    0.02;  ///< of the ranges: nearer to the start differences are not taken relative to less

/// A row in coordinates divided by their ranges.
struct Scaled {
    double load = 0, measure = 0;
    double cosine = 1, sine = 0;  ///< tangent in (measure, load)
    double along = 0;             ///< path length up to here
    double from_start = 0;        ///< distance
    double d1 = 0, d2 = 0;
    double curvature = 0;
};

struct Ranges {
    double load = 0, measure = 0;
};

Ranges ranges_of(std::span<const LevelRow> rows) {
    Ranges ranges;
    const auto range = [&](double PathPoint::*member) {
        double low = 0, high = 0;  // the undeformed state belongs to every path
        for (const LevelRow& row : rows) {
            low = std::min(low, row.levels[2].*member);
            high = std::max(high, row.levels[2].*member);
        }
        return high > low ? high - low : 1;
    };
    ranges.load = range(&PathPoint::load);
    ranges.measure = range(&PathPoint::measure);
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
        path[i].load = rows[i].levels[2].load / ranges.load;
        path[i].measure = rows[i].levels[2].measure / ranges.measure;
    }
    set_tangents(rows, ranges, path);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        Scaled& at = path[i];
        const auto across = [&](std::size_t level) {
            return at.cosine * (rows[i].levels[level].load / ranges.load - at.load) -
                   at.sine * (rows[i].levels[level].measure / ranges.measure - at.measure);
        };
        at.d1 = across(0) - across(1);
        at.d2 = across(1);
        at.from_start = std::hypot(at.load - path[0].load, at.measure - path[0].measure);
        if (i > 0)
            at.along = path[i - 1].along + std::hypot(at.load - path[i - 1].load, at.measure - path[i - 1].measure);
    }
    set_curvatures(path);
    return path;
}

/// Relative differences of a neighbourhood.
struct Nearby {
    double first = 0, second = 0;  ///< root mean squares of d1, d2
    double correlation = 0;
};

Nearby nearby(const std::vector<Scaled>& path, std::size_t i) {
    const double width = neighbourhood * path.back().along;
    double weights = 0, squares1 = 0, squares2 = 0, products = 0;
    for (const Scaled& row : path) {
        const double distance = std::abs(row.along - path[i].along);
        if (!(row.from_start > 0) || distance > width) continue;
        const double weight = 1 - distance / width * (1 - 1e-3),
                     scale = 1 / std::max(row.from_start, nearest_start);  // > 0
        const double d1 = row.d1 * scale, d2 = row.d2 * scale;
        weights += weight;
        squares1 += weight * d1 * d1;
        squares2 += weight * d2 * d2;
        products += weight * d1 * d2;
    }
    if (!(weights > 0)) return {};
    const double both = std::sqrt(squares1 * squares2);
    return {std::sqrt(squares1 / weights), std::sqrt(squares2 / weights), both > 0 ? products / both : 0};
}

/// Error of the finest mesh over the last difference, if a fast and a slow part make it.
double of_two_rates(double rho, double fast) {
    return std::abs((rho - slow) / (fast - slow) / (fast - 1) + (fast - rho) / (fast - slow) / (slow - 1));
}

/// The same, as far as it can be told.
double error_share(const Nearby& near, int order) {
    const double fast = std::pow(2.0, 2 * order), rho = near.second > 0 ? near.first / near.second : fast;
    const double two_rates = of_two_rates(rho, fast);
    if (near.correlation < least_correlation)  // the two parts may have opposite signs
        return std::max({1.0, two_rates / safety, of_two_rates(-rho, fast) / safety});
    if (rho <= slow) return 1;
    if (rho <= fast) return std::sqrt(two_rates / (rho - 1));
    // Faster than can be: not yet the rate, or two parts of opposite sign, the more so the faster.
    const double one_rate = 1 / (fast - 1), trust = std::min(0.5 + 0.5 * std::log2(rho / fast), 1.0);
    return std::max(one_rate, std::pow(one_rate, 1 - trust) * std::pow(two_rates, trust));
}

/// How far one coordinate of the curve shifted by c across itself is away at an equal value of the other, whose share of
/// the tangent is `other`; `own` that of the first. With s along the curve:
///     own = 1, other = 0:  c;   straight: c / other;   at a limit of the other, other = 0: sqrt(2 c / curvature).
std::optional<double> shift(double c, double own, double other, double curvature) {
    if (c == 0) return 0;
    own = std::abs(own);
    other = std::abs(other);
    const double bend = 2 * curvature * c * own * own;
    const double away = 2 * c * own / (other + std::sqrt(other * other + bend));
    const double rest = other * other - bend;
    const double towards =
        rest >= 0 ? 2 * c * own / (other + std::sqrt(rest)) : other / (curvature * own);  // the limit point
    const double result = own > 0 ? c * other + own * std::max(away, towards) : c;
    return result < 1 ? std::optional(result) : std::nullopt;  // of the whole range; false for a plateau's NaN too
}

}  // namespace

std::vector<ErrorBar> error_bars(std::span<const LevelRow> rows, int order) {
    if (order != 1 && order != 2) throw std::logic_error("error_bars: cells are of order 1 or 2");
    if (rows.empty()) return {};
    const Ranges ranges = ranges_of(rows);
    const std::vector<Scaled> path = scaled(rows, ranges);
    std::vector<ErrorBar> bars;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const Scaled& at = path[i];
        const Nearby near = nearby(path, i);
        constexpr double least_share = 0.5;
        const double difference = std::max(std::abs(at.d2), least_share * near.second * at.from_start);
        const double c = safety * error_share(near, order) * difference + solved_to * at.from_start;
        const auto load = shift(c, at.sine, at.cosine, at.curvature),
                   measure = shift(c, at.cosine, at.sine, at.curvature);
        bars.push_back({load ? std::optional(*load * ranges.load) : std::nullopt,
                        measure ? std::optional(*measure * ranges.measure) : std::nullopt});
    }
    return bars;
}

}  // namespace soft::post
