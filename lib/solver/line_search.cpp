#include "solver/line_search.hpp"

#include <algorithm>
#include <cmath>

namespace soft::solver {

namespace {

/// Armijo's constant: any decrease proportional to the step is accepted.
constexpr double sufficient_decrease = 1e-4;
constexpr int trial_limit = 6;
/// Fraction of g(0) that may remain: a closer search costs more than it gains (Matthies and Strang).
constexpr double slope_left = 0.5;
constexpr double shortest = 0.05, longest = 4.0;

/// Halves the length until `accept` returns true.
template <class Accept>
Search halve(double first, const std::function<Trial(double)>& at, Accept&& accept) {
    Search found;
    found.length = first;
    for (int attempt = 0;; ++attempt, found.length *= 0.5) {
        if (attempt == trial_limit) {
            found.end = found.trial.admissible ? SearchEnd::no_descent : SearchEnd::inverted;
            return found;
        }
        if (attempt > 0) ++found.halvings;
        found.trial = at(found.length);
        if (found.trial.admissible && accept(found.trial, found.length)) return found;
    }
}

Search whole(double first, const std::function<Trial(double)>& at) {
    return halve(first, at, [](const Trial&, double) { return true; });
}

/// Secant method on the last two lengths: between them, or beyond the last where g has not changed sign.
Search secant(const SearchStart& start, const std::function<Trial(double)>& at) {
    Search found = whole(start.longest, at);
    if (found.end != SearchEnd::found) return found;
    const auto is_done = [&] {
        return found.trial.admissible && (found.trial.residual <= found.trial.floor ||
                                          std::abs(found.trial.slope) <= slope_left * std::abs(start.slope));
    };
    double before = 0.0, slope_before = start.slope, best = found.length, best_slope = std::abs(found.trial.slope);
    while (!is_done() && found.trial.admissible && found.halvings < trial_limit) {
        const double length = found.length, slope = found.trial.slope;
        const double zero = length - slope * (length - before) / (slope - slope_before);
        if (!std::isfinite(zero)) break;
        before = length;
        slope_before = slope;
        found.length = std::clamp(zero, shortest * start.longest, longest * start.longest);
        ++found.halvings;
        found.trial = at(found.length);
        if (!found.trial.admissible || !(std::abs(found.trial.slope) < best_slope)) continue;
        best = found.length;
        best_slope = std::abs(found.trial.slope);
    }
    if (is_done() || found.length == best) return found;
    found.length = best;
    found.trial = at(best);
    return found;
}

}  // namespace

Search search(model::LineSearch kind, const SearchStart& start, const std::function<Trial(double)>& at) {
    switch (kind) {
        case model::LineSearch::backtracking:
            return halve(start.longest, at, [&](const Trial& trial, double length) {
                return trial.residual <=
                       std::max(trial.floor, start.allowed_rise * start.pending * (1.0 - sufficient_decrease * length));
            });
        case model::LineSearch::secant: return secant(start, at);
        case model::LineSearch::none: return whole(start.longest, at);
    }
    return {};
}

}  // namespace soft::solver
