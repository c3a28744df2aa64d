#include "post/interpolate.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "post/monotone_slopes.hpp"

namespace soft::post {
namespace {

/// Coordinates divided by their range; constant coordinates are ignored.
struct Metric {
    std::vector<const Column*> columns;
    std::vector<double> inverse_range;

    explicit Metric(const Curve& curve) {
        const bool have_slopes = std::ranges::any_of(curve.columns, [](const Column& column) {
            return column.role == Role::coordinate && !column.slopes.empty();
        });
        for (const Column& column : curve.columns) {
            if (column.role != Role::coordinate || column.values.empty()) continue;
            if (have_slopes && column.slopes.empty()) continue;  // it would count in distances alone
            const auto [low, high] = std::minmax_element(column.values.begin(), column.values.end());
            if (!(*high > *low)) continue;
            columns.push_back(&column);
            inverse_range.push_back(1 / (*high - *low));
        }
    }
    [[nodiscard]] double slope(std::size_t i, std::size_t row) const {
        return columns[i]->slopes.empty() ? 0 : columns[i]->slopes[row];
    }
    [[nodiscard]] double distance(std::size_t row_a, std::size_t row_b) const {
        double sum = 0;
        for (std::size_t i = 0; i < columns.size(); ++i)
            sum += std::pow((columns[i]->values[row_b] - columns[i]->values[row_a]) * inverse_range[i], 2);
        return std::sqrt(sum);
    }
    /// Scalar product of the recorded directions of two rows.
    [[nodiscard]] double product(std::size_t row_a, std::size_t row_b) const {
        double sum = 0;
        for (std::size_t i = 0; i < columns.size(); ++i)
            sum += slope(i, row_a) * slope(i, row_b) * inverse_range[i] * inverse_range[i];
        return sum;
    }
    /// Norm of the recorded direction; 0 if none is recorded.
    [[nodiscard]] double norm(std::size_t row) const { return std::sqrt(product(row, row)); }
    /// Scalar product of the direction recorded at `row` with the chord between two rows.
    [[nodiscard]] double along(std::size_t row, std::size_t row_a, std::size_t row_b) const {
        double sum = 0;
        for (std::size_t i = 0; i < columns.size(); ++i)
            sum += slope(i, row) * (columns[i]->values[row_b] - columns[i]->values[row_a]) * inverse_range[i] *
                   inverse_range[i];
        return sum;
    }
};

/// Speeds at the ends of the interval between two rows, and which recorded directions are used.
struct Speeds {
    double start, end;
    enum class Directions { both, first, second, none } directions = Directions::both;
};

constexpr double max_ratio = 2;  // of a speed to the chord; above it the directions do not enclose the chord
constexpr double parallel =
    1e-10;  // sin^2 of the angle between directions; below it rounding would dominate the speeds

/// Speeds at both ends of an interval within one stage, see the header.
Speeds interval_speeds(const Metric& metric, std::size_t row_a, std::size_t row_b) {
    const double chord = metric.distance(row_a, row_b);
    const double norm_a = metric.norm(row_a), norm_b = metric.norm(row_b);
    if (!(chord > 0 && norm_a > 0 && norm_b > 0)) return {chord, chord};
    const double cosine = metric.product(row_a, row_b) / (norm_a * norm_b);
    const double a = 2 * metric.along(row_a, row_a, row_b) / norm_a, b = 2 * metric.along(row_b, row_a, row_b) / norm_b;
    const double determinant = 1 - cosine * cosine;
    if (!(determinant > parallel)) return {chord, chord};
    const Speeds speeds{(a - b * cosine) / determinant, (b - a * cosine) / determinant};
    const auto is_valid = [&](double v) { return v * max_ratio > chord && v < chord * max_ratio; };  // false for NaN
    return is_valid(speeds.start) && is_valid(speeds.end) ? speeds : Speeds{chord, chord};
}

/// Speeds in an interval where only the direction recorded at one of both rows, `known`, belongs to it: the last one of a stage's first
/// interval, the first one before a kink; see the header.
Speeds one_sided_speeds(const Metric& metric, std::size_t row_a, std::size_t row_b, std::size_t known) {
    constexpr double noise = 1e-6;  // of the chord: slopes of coordinates that change less are ignored
    const double chord = metric.distance(row_a, row_b), norm = metric.norm(known);
    const Speeds straight{chord, chord, Speeds::Directions::none};
    if (!(chord > 0 && norm > 0)) return straight;
    const double cosine = metric.along(known, row_a, row_b) / (norm * chord), speed = chord / cosine;
    if (!(cosine * max_ratio > 1)) return straight;
    for (std::size_t i = 0; i < metric.columns.size(); ++i) {
        const Column& column = *metric.columns[i];
        const double d = (column.values[row_b] - column.values[row_a]) * metric.inverse_range[i];
        const double recorded = metric.slope(i, known) * metric.inverse_range[i] * speed / norm;
        for (const double slope : {recorded, 2 * d - recorded})
            if (slope * d < 0 && std::abs(slope) > noise * chord) return straight;
    }
    return {speed, speed, known == row_a ? Speeds::Directions::first : Speeds::Directions::second};
}

/// Root of a monotone piece by bisection to the resolution of doubles.
double bisect(const Hermite& cubic, double value, double left, double right) {
    const bool rising = cubic(right) > cubic(left);
    while (true) {
        const double middle = left + (right - left) / 2;
        if (!(middle > left && middle < right)) return left;
        ((cubic(middle) <= value) == rising ? left : right) = middle;
    }
}

}  // namespace

double Hermite::operator()(double t) const noexcept {
    if (t >= 1) return q1;  // exact at the ends: neighbouring pieces must be bitwise equal there
    const double d = q1 - q0;
    return q0 + t * (m0 + t * (3 * d - 2 * m0 - m1 + t * (m0 + m1 - 2 * d)));
}

std::vector<double> Hermite::monotone_pieces() const {
    // dq/dt = a t^2 + 2 b t + c; roots in the form without cancellation
    const double d = q1 - q0, a = 3 * (m0 + m1 - 2 * d), b = 3 * d - 2 * m0 - m1, c = m0;
    std::vector<double> ends{0};
    if (const double discriminant = b * b - a * c; discriminant > 0) {
        const double w = -(b + std::copysign(std::sqrt(discriminant), b));
        std::array<double, 2> roots{a != 0 ? w / a : -1, w != 0 ? c / w : -1};
        std::sort(roots.begin(), roots.end());
        for (const double root : roots)
            if (root > 0 && root < 1) ends.push_back(root);
    }
    ends.push_back(1);
    return ends;
}

namespace {

/// Speeds in time: slopes are time derivatives, so the speed at a row is the norm of its slopes times the duration.
Speeds speeds_in_time(const Metric& metric, const Column& time, std::size_t row_a, std::size_t row_b,
                      Speeds::Directions directions) {
    const double duration = time.values[row_b] - time.values[row_a];
    return {metric.norm(row_a) * duration, metric.norm(row_b) * duration, directions};
}

/// The recorded directions that belong to an interval.
Speeds::Directions directions_of(bool enters_a_stage, bool ends_at_a_kink) {
    if (enters_a_stage) return ends_at_a_kink ? Speeds::Directions::none : Speeds::Directions::second;
    return ends_at_a_kink ? Speeds::Directions::first : Speeds::Directions::both;
}

Speeds speeds_of(const Metric& metric, std::size_t row_a, std::size_t row_b, Speeds::Directions directions) {
    const double chord = metric.distance(row_a, row_b);
    switch (directions) {
        case Speeds::Directions::both: return interval_speeds(metric, row_a, row_b);
        case Speeds::Directions::first: return one_sided_speeds(metric, row_a, row_b, row_a);
        case Speeds::Directions::second: return one_sided_speeds(metric, row_a, row_b, row_b);
        case Speeds::Directions::none: break;
    }
    return {chord, chord, Speeds::Directions::none};
}

/// Fraction of the chord that the path has covered in an interval, a cubic of t like the coordinates.
Hermite progress(const Metric& metric, const Curve& curve, const std::vector<std::vector<Hermite>>& pieces,
                 std::size_t interval, double chord) {
    Hermite progress{0, 1, 0, 0};
    for (std::size_t k = 0; k < metric.columns.size(); ++k) {
        const Hermite& piece = pieces[curve.index_of(*metric.columns[k])][interval];
        const double share =
            (piece.q1 - piece.q0) * metric.inverse_range[k] * metric.inverse_range[k] / (chord * chord);
        progress.m0 += piece.m0 * share;
        progress.m1 += piece.m1 * share;
    }
    return progress;
}

/// Slopes dq/ds at both ends of an interval; they are continuous at rows within a stage.
struct EndSlopes {
    double start, end;
};

/// Whether a column that jumps (Column::jumps) has at one end of an interval the value of the neighbouring interval.
enum class Jump { none, at_start, at_end };

/// Slopes of each interval. `corners` are the rows at which a stage begins or that are kinks. Slopes on both sides of a corner are
/// independent: between loading and unloading the energy has a maximum, but its slope is zero on neither side. `jumps`: without the values
/// of rows at corners that belong to another interval (Jump).
std::vector<EndSlopes> slopes_by_stage(std::span<const double> s, std::span<const double> q,
                                       std::span<const std::size_t> corners, std::span<const Jump> jumps) {
    std::vector<EndSlopes> ends;
    std::size_t first = 0;
    const auto add_until = [&](std::size_t last) {
        const bool skips_first = last > first && jumps[first] == Jump::at_start;
        const bool skips_last = last > first && jumps[last - 1] == Jump::at_end;
        const std::size_t from = first + (skips_first ? 1 : 0), count = last - from + (skips_last ? 0 : 1);
        const std::vector<double> slopes = monotone_slopes(s.subspan(from, count), q.subspan(from, count));
        if (skips_first) ends.push_back({slopes.front(), slopes.front()});
        for (std::size_t i = 1; i < slopes.size(); ++i) ends.push_back({slopes[i - 1], slopes[i]});
        if (skips_last) ends.push_back({slopes.back(), slopes.back()});
        first = last;
    };
    for (const std::size_t corner : corners) add_until(corner);
    add_until(s.size() - 1);
    return ends;
}

/// True if the solver provides the derivative of the column along the path.
bool has_slopes(const Column& column) { return !column.slopes.empty(); }

}  // namespace

Path::Path(const Curve& curve) : curve_(&curve) {
    if (curve.row_count() == 0) throw Error(ExitCode::bad_input, "path", "the result contains no steps");
    const Metric metric(curve);
    const Column* stage = curve.find("stage");
    if (stage != nullptr && stage->role != Role::stage) stage = nullptr;  // an output of this name
    const Column* time = curve.find(Source::time);
    std::vector<Speeds> speeds;
    std::vector<double> chords{0};  // cumulative
    std::vector<std::size_t> corners;
    std::vector<Jump> jumps;  // by interval
    rows_.push_back(0);
    s_.push_back(0);
    for (std::size_t row = 1; row < curve.row_count(); ++row) {
        const std::size_t before = rows_.back();
        const bool enters = stage != nullptr && stage->values[row] != stage->values[before];
        const bool is_kink = std::ranges::binary_search(curve.kinks, row);
        const Speeds::Directions known = directions_of(enters, is_kink);
        const Speeds next =
            time != nullptr ? speeds_in_time(metric, *time, before, row, known) : speeds_of(metric, before, row, known);
        if (!(next.start + next.end > 0)) continue;
        if (enters || std::ranges::binary_search(curve.kinks, before)) corners.push_back(rows_.size() - 1);
        // With a single row before a kink, the value at the kink is better than none.
        const bool follows = !speeds.empty() && (corners.empty() || corners.back() + 1 != rows_.size());
        const bool reaches = is_kink && follows && row + 1 < curve.row_count();
        jumps.push_back(enters ? Jump::at_start : reaches ? Jump::at_end : Jump::none);
        rows_.push_back(row);
        speeds.push_back(next);
        s_.push_back(s_.back() +
                     (time != nullptr ? time->values[row] - time->values[before] : (next.start + next.end) / 2));
        chords.push_back(chords.back() + metric.distance(before, row));
    }
    const std::vector<Jump> nowhere(speeds.size(), Jump::none);
    for (const Column& column : curve.columns) {
        std::vector<double> q;
        for (const std::size_t row : rows_) q.push_back(column.values[row]);
        const std::vector<double>& parameters = has_slopes(column) || time != nullptr ? s_ : chords;
        const std::vector<EndSlopes> by_rows = slopes_by_stage(parameters, q, corners, column.jumps ? jumps : nowhere);
        const auto slope = [&](std::size_t i, double speed, double otherwise) {
            const double norm = has_slopes(column) ? metric.norm(rows_[i]) : 0;
            return norm > 0 ? column.slopes[rows_[i]] / norm * speed : otherwise;
        };
        std::vector<Hermite>& pieces = pieces_.emplace_back();
        for (std::size_t i = 0; i < speeds.size(); ++i) {
            const double ds = parameters[i + 1] - parameters[i], difference = q[i + 1] - q[i];
            using enum Speeds::Directions;
            const bool continues = !column.bends && speeds[i].directions == first;
            const auto known = has_slopes(column) && !continues ? speeds[i].directions : both;
            double start = slope(i, speeds[i].start, by_rows[i].start * ds),
                   end = slope(i + 1, speeds[i].end, by_rows[i].end * ds);
            if (known == first) end = 2 * difference - start;
            if (known == second) start = 2 * difference - end;
            const bool turns = start * difference < 0 || end * difference < 0;
            if (known == none || (known != both && time != nullptr && turns)) start = end = difference;
            const Jump jump = column.jumps ? jumps[i] : Jump::none;
            if (jump != Jump::none) start = end = by_rows[i].end * ds;
            pieces.push_back({jump == Jump::at_start ? q[i + 1] - end : q[i],
                              jump == Jump::at_end ? q[i] + start : q[i + 1], start, end});
        }
    }
    for (std::size_t i = 0; i < speeds.size(); ++i)
        progress_.push_back(time != nullptr
                                ? Hermite{0, 1, 1, 1}
                                : progress(metric, curve, pieces_, i, metric.distance(rows_[i], rows_[i + 1])));
}

double Path::in_interval(std::size_t column, std::size_t interval, double t) const {
    const double left = curve_->columns[column].values[rows_[interval]];
    const double right = curve_->columns[column].values[rows_[interval + 1]];
    switch (curve_->columns[column].role) {
        case Role::counter: return left + t * (right - left);
        case Role::stage: return t <= at_a_row ? left : right;
        case Role::flag: return t <= 0 ? left : t >= 1 ? right : std::min(left, right);
        case Role::dependent:
            if (curve_->columns[column].jumps && (t <= at_a_row || t >= 1 - at_a_row))
                return t <= at_a_row ? left : right;
            if (has_slopes(curve_->columns[column])) break;
            return pieces_[column][interval](std::clamp(progress_[interval](t), 0.0, 1.0));
        case Role::coordinate: break;
    }
    return pieces_[column][interval](t);
}

std::size_t Path::interval_at(double s) const {
    return static_cast<std::size_t>(std::upper_bound(s_.begin() + 1, s_.end() - 1, s) - s_.begin()) - 1;
}

std::array<double, 2> Path::ends(std::size_t column, double s) const {
    if (s_.size() < 2) return {curve_->columns[column].values.front(), curve_->columns[column].values.front()};
    const Hermite& piece = pieces_[column][interval_at(s)];
    return {piece.q0, piece.q1};
}

std::vector<double> Path::at(double s) const {
    std::vector<double> row;
    const std::size_t interval = s_.size() > 1 ? interval_at(s) : 0;
    const double t = s_.size() > 1 ? std::clamp((s - s_[interval]) / (s_[interval + 1] - s_[interval]), 0.0, 1.0) : 0;
    for (std::size_t column = 0; column < curve_->columns.size(); ++column)
        row.push_back(s_.size() > 1 ? in_interval(column, interval, t) : curve_->columns[column].values.front());
    return row;
}

/// Relative distance within which the solver reaches a goal (default of SolverSettings::residual_tolerance).
constexpr double goal_tolerance = 1e-9;

std::vector<double> Path::crossings(std::size_t column, double value) const {
    std::vector<double> found;
    for (std::size_t interval = 0; interval + 1 < s_.size(); ++interval) {
        const Hermite& cubic = pieces_[column][interval];
        const std::vector<double> ends = cubic.monotone_pieces();
        const double ds = s_[interval + 1] - s_[interval];
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {  // each piece includes its left end only
            const double left = cubic(ends[i]) - value, right = cubic(ends[i + 1]) - value;
            if (left == 0)
                found.push_back(s_[interval] + ds * ends[i]);
            else if ((left < 0) != (right < 0) && right != 0)
                found.push_back(s_[interval] + ds * bisect(cubic, value, ends[i], ends[i + 1]));
        }
    }
    // A path with this value as its goal ends within the solver's tolerance, slightly before or beyond it.
    const auto& values = curve_->columns[column].values;
    const double last = values[rows_.back()], size = std::max(std::abs(last), std::abs(value));
    const bool at_the_end = std::abs(last - value) <= goal_tolerance * size;
    const auto is_elsewhere = [&] { return found.back() < s_.back() - goal_tolerance * (s_.back() - s_.front()); };
    if (last == value || (at_the_end && (found.empty() || is_elsewhere()))) found.push_back(s_.back());
    return found;
}

double Path::within_reach(std::size_t column, double value) const {
    constexpr double end_tolerance = 1e-6;  // of the range
    const Range range = this->range(column);
    const double nearest = std::clamp(value, range.lowest, range.highest);
    return std::abs(value - nearest) <= end_tolerance * (range.highest - range.lowest) ? nearest : value;
}

Path::Range Path::range(std::size_t column) const {
    Range range{curve_->columns[column].values.front(), curve_->columns[column].values.front()};
    const auto include = [&](double value) { range = {std::min(range.lowest, value), std::max(range.highest, value)}; };
    for (const Hermite& cubic : pieces_[column])
        for (const double t : cubic.monotone_pieces()) include(cubic(t));
    return range;
}

}  // namespace soft::post
