#include "post/align.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace soft::post {
namespace {

constexpr double backward_penalty = 1e6;  // in squared ranges: larger than any real distance
/// Of its range: a track that changes less from a row to the next one does not tell their positions.
constexpr double standstill = 1e-4;

std::size_t reversals(std::span<const double> values) {
    std::size_t count = 0;
    double direction = 0;
    for (std::size_t i = 1; i < values.size(); ++i) {
        const double step = values[i] - values[i - 1];
        if (step * direction < 0) ++count;
        if (step != 0) direction = step;
    }
    return count;
}

double range_of(std::span<const double> values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return *high - *low;
}

/// Whether a track hardly changes before or after a row.
bool stands_still(std::span<const double> values, std::size_t row, double range) {
    const auto is_still = [&](std::size_t a, std::size_t b) {
        return std::abs(values[b] - values[a]) <= standstill * range;
    };
    return (row > 0 && is_still(row - 1, row)) || (row + 1 < values.size() && is_still(row, row + 1));
}

/// Grows with the square, to at most `largest`.
double bounded(double square, double largest) {
    return std::isinf(largest) ? square : largest * (std::isnan(square) ? 1 : square / (1 + square));
}

/// Squared distance between a row of the table and a position on the path.
double distance(std::span<const Track> tracks, std::span<const double> ranges, std::size_t row,
                const std::vector<double>& state) {
    double sum = 0;
    for (std::size_t i = 0; i < tracks.size(); ++i)
        if (ranges[i] > 0)
            sum +=
                bounded(std::pow((state[tracks[i].column] - tracks[i].values[row]) / ranges[i], 2), tracks[i].largest);
    return sum;
}

struct Candidate {
    double s = 0, cost = 0;
    std::size_t before = 0;  ///< candidate of the previous row on the cheapest sequence to this one
};

/// Adds the cost of the cheapest sequence through the candidates of the previous row (dynamic programming).
void link(std::vector<Candidate>& row, const std::vector<Candidate>& before) {
    for (Candidate& here : row) {
        double best = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < before.size(); ++i) {
            const double cost = before[i].cost + (before[i].s > here.s ? backward_penalty : 0);
            if (cost < best) best = cost, here.before = i;
        }
        here.cost += best;
    }
}

}  // namespace

std::size_t leading_track(std::span<const Track> tracks) {
    const auto least = std::min_element(tracks.begin(), tracks.end(), [](const Track& a, const Track& b) {
        const bool moves_a = range_of(a.values) > 0, moves_b = range_of(b.values) > 0;
        return moves_a != moves_b ? moves_a : reversals(a.values) < reversals(b.values);
    });
    return static_cast<std::size_t>(least - tracks.begin());
}

std::vector<double> align(const Path& path, std::span<const Track> tracks, std::size_t leader,
                          std::span<const std::vector<double>> targets) {
    std::vector<double> ranges;
    for (const Track& track : tracks) ranges.push_back(range_of(track.values));
    std::vector<std::size_t> reached;
    std::vector<std::vector<Candidate>> rows;
    const std::size_t row_count = tracks[leader].values.size();
    for (std::size_t row = 0; row < row_count; ++row) {
        std::vector<Candidate> candidates;
        const bool any = stands_still(tracks[leader].values, row, ranges[leader]);
        for (std::size_t track = 0; track < targets.size(); ++track)
            if (track == leader || (any && ranges[track] > 0))
                for (const double s : path.crossings(tracks[track].column, targets[track][row]))
                    candidates.push_back({s, distance(tracks, ranges, row, path.at(s))});
        if (candidates.empty()) continue;
        if (!rows.empty()) link(candidates, rows.back());
        reached.push_back(row);
        rows.push_back(std::move(candidates));
    }
    std::vector<double> positions(row_count, std::numeric_limits<double>::quiet_NaN());
    if (rows.empty()) return positions;
    const auto cheapest = std::min_element(rows.back().begin(), rows.back().end(),
                                           [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
    std::size_t choice = static_cast<std::size_t>(cheapest - rows.back().begin());
    for (std::size_t i = rows.size(); i-- > 0;) {
        positions[reached[i]] = rows[i][choice].s;
        choice = rows[i][choice].before;
    }
    return positions;
}

}  // namespace soft::post
