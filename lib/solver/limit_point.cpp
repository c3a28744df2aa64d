#include "solver/path_follower.hpp"

#include <algorithm>
#include <cmath>

namespace soft::solver {

using solution::StopReason;

namespace {

/// A limit point is located until its load is known to this relative accuracy (estimated from the slope's parabola).
constexpr double limit_point_tolerance = 1e-8;
constexpr int limit_point_solves = 12;

}  // namespace

void PathFollower::locate_limit_point(const PathPoint& from, const PathPoint& to) {
    if (control_.kind == ConstraintKind::load_factor || from.tangent.load_factor * to.tangent.load_factor >= 0.0)
        return;
    std::optional<PathPoint> left, right;
    for (int solve = 0; solve < limit_point_solves; ++solve) {
        const PathPoint& a = left ? *left : from;
        const PathPoint& b = right ? *right : to;
        // Zero of the slope by the secant through both ends; bisection where that would hug an end.
        const double span = b.q - a.q;
        double share = a.tangent.load_factor / (a.tangent.load_factor - b.tangent.load_factor);
        share = std::clamp(share, 0.02, 0.98);
        const double q = a.q + share * span;
        State guess = predict(&a, b, q);
        const Constraint constraint = bind(control_, a);
        const double target = constraint.kind == ConstraintKind::arc
                                  ? evaluate(constraint, system_, guess.x, guess.load_factor, scratch_)
                                  : q;
        auto point = solve_at(constraint, target, std::move(guess));
        if (!point) return;   // the path goes on without the located point; the sign change stays in the rows
        if (control_.kind == ConstraintKind::arc) point->q = q;
        const double curvature = (b.tangent.load_factor - a.tangent.load_factor) / span;
        const double slope = point->tangent.load_factor;
        const bool located = slope * slope <=
                             2.0 * limit_point_tolerance * std::abs(curvature * point->state.load_factor);
        if (located || solve + 1 == limit_point_solves) {
            end_.limit_points.push_back({rows_, point->state.load_factor * model::leading_load(input_).value_Pa,
                                         point->volume_m3, point->outputs_m});
            append(*point);
            if (stop_at_limit_point_)
                finish(StopReason::limit_point,
                       "the pressure has a maximum at " + describe(*point) +
                           ": no equilibrium beyond under pressure control; path.control: volume goes on");
            return;
        }
        (slope * from.tangent.load_factor > 0.0 ? left : right) = std::move(point);
    }
}

/// Under a controlled quantity the tangent may have one more negative pivot than at fixed load, exactly where the load
/// falls: the bordered matrix is then still definite on the constraint.
bool PathFollower::is_stable(const PathPoint& point) const {
    const bool load_rises = point.tangent.load_factor * step_ >= 0.0;
    if (!point.tangent.excess_pivots) return !stop_at_limit_point_ || load_rises;
    const int excess = *point.tangent.excess_pivots;
    if (stop_at_limit_point_) return excess == 0;
    return excess == (load_rises ? 0 : 1);
}

}  // namespace soft::solver
