#include "sweep/trace.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "post/interpolate.hpp"

namespace soft::sweep {
namespace {

bool is_drawn(const post::Column& column) {
    using post::Role;
    return column.shown == post::Shown::always && column.role != Role::counter && column.role != Role::flag &&
           column.role != Role::stage;
}

Trace sampled(const post::Curve& curve) {
    constexpr int samples_per_interval = 6;
    Trace trace;
    std::vector<std::size_t> columns;
    for (std::size_t c = 0; c < curve.columns.size(); ++c) {
        const post::Column& column = curve.columns[c];
        if (!is_drawn(column)) continue;
        columns.push_back(c);
        std::string label = column.quantity;
        std::ranges::replace(label, '_', ' ');
        trace.push_back({column.name, label, column.unit, {}});
    }
    const auto add = [&](const std::vector<double>& row) {
        for (std::size_t i = 0; i < columns.size(); ++i) trace[i].values.push_back(row[columns[i]]);
    };
    const post::Path path(curve);
    const auto s = path.row_parameters();
    add(path.at(s.front()));
    for (std::size_t i = 0; i + 1 < s.size(); ++i)
        for (int k = 1; k <= samples_per_interval; ++k)
            add(path.at(s[i] + (s[i + 1] - s[i]) * k / samples_per_interval));
    return trace;
}

struct Piece {
    double deviation = 0;  ///< of the farthest point from the line between the ends
    std::size_t first = 0, last = 0, farthest = 0;

    friend bool operator<(const Piece& a, const Piece& b) {
        return a.deviation != b.deviation ? a.deviation > b.deviation : a.first < b.first;
    }
};

Piece piece_between(const std::vector<std::vector<double>>& points, std::size_t first, std::size_t last) {
    Piece piece{-1, first, last, first};
    for (std::size_t i = first + 1; i < last; ++i) {
        double dot = 0, chord = 0, square = 0;
        for (std::size_t c = 0; c < points[i].size(); ++c) {
            const double along = points[last][c] - points[first][c], from = points[i][c] - points[first][c];
            dot += along * from, chord += along * along, square += from * from;
        }
        const double share = chord > 0 ? std::clamp(dot / chord, 0.0, 1.0) : 0;
        const double deviation = square - share * (2 * dot - share * chord);  // squared distance from the segment
        if (deviation > piece.deviation) piece.deviation = deviation, piece.farthest = i;
    }
    return piece;
}

/// Indices of the kept points, in order.
std::set<std::size_t> kept_points(const std::vector<std::vector<double>>& points, std::size_t max_points) {
    std::set<std::size_t> kept{0, points.size() - 1};
    std::set<Piece> pieces{piece_between(points, 0, points.size() - 1)};
    while (kept.size() < max_points && !pieces.empty()) {
        const Piece widest = *pieces.begin();
        pieces.erase(pieces.begin());
        if (widest.farthest == widest.first) continue;
        kept.insert(widest.farthest);
        pieces.insert(piece_between(points, widest.first, widest.farthest));
        pieces.insert(piece_between(points, widest.farthest, widest.last));
    }
    return kept;
}

}  // namespace

Trace make_trace(const post::Curve& curve, std::size_t max_points) {
    if (curve.row_count() == 0) return {};
    Trace trace = sampled(curve);
    const std::size_t count = trace.front().values.size();
    if (count <= max_points) return trace;
    std::vector<std::vector<double>> points(count);
    for (const TraceColumn& column : trace) {
        const auto [low, high] = std::ranges::minmax(column.values);
        for (std::size_t i = 0; i < count; ++i)
            points[i].push_back(high > low ? (column.values[i] - low) / (high - low) : 0);
    }
    const std::set<std::size_t> kept = kept_points(points, std::max<std::size_t>(max_points, 2));
    for (TraceColumn& column : trace) {
        std::vector<double> values;
        for (const std::size_t i : kept) values.push_back(column.values[i]);
        column.values = std::move(values);
    }
    return trace;
}

std::array<std::size_t, 2> usual_axes(const Trace& trace) {  // in the order of a curve: [time], load, outputs, volume
    const auto index = [&](std::size_t i) { return std::min(i, trace.size() - 1); };
    return trace.front().name == "time_s" ? std::array{index(0), index(2)} : std::array{index(1), index(0)};
}

}  // namespace soft::sweep
