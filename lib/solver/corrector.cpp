#include "solver/corrector.hpp"

#include <cmath>

#include "solver/control.hpp"
#include "solver/row_state.hpp"

namespace soft::solver {

namespace {

/// Relative, of a quantity without a slope; that many states are solved for at most.
constexpr double goal_accuracy = 1e-9;
constexpr int goal_solves = 60;

}  // namespace

Constraint bind(const Constraint& constraint, const PathPoint& origin) {
    Constraint bound = constraint;
    if (constraint.kind == ConstraintKind::arc) {
        bound.arc_origin = origin.state.x;
        bound.arc_direction = origin.tangent.x;
    }
    return bound;
}

bool Corrector::correct(const Constraint& constraint, double target, State& state) {
    last_result_ = newton_.correct(constraint, target, state);
    iterations_ += last_result_.iterations;
    return last_result_.end == NewtonEnd::converged;
}

std::optional<PathPoint> Corrector::solve_at(const Frame& frame, const Constraint& constraint, double target,
                                             State guess, WithContact contact) {
    if (contact == WithContact::if_met && !frame.last.touches) {
        const Memory before = memory();
        auto point = solve_at(frame, constraint, target, copy_of(guess), WithContact::no);
        if (!point || !wake_contact_if_met(frame, *point)) return point;
        restore(before);
    }
    system_.contact().set_resting(contact == WithContact::no);
    auto point = solve_from(frame, constraint, target, std::move(guess));
    if (point && contact != WithContact::no && newton_.passes_through_obstacle(frame.last.state, point->state)) {
        last_result_.end = NewtonEnd::passes_through;
        point.reset();
    }
    if (!point && system_.contact().has_friction()) system_.contact().set_resting(false);
    return point;
}

bool Corrector::wake_contact_if_met(const Frame& frame, const PathPoint& point) {
    system_.contact().set_resting(false);
    // A step may be longer than an obstacle is thick.
    const bool meets = point.touches || (!input().obstacles.empty() &&
                                         newton_.share_without_crossing(frame.last.state, point.state) < 1.0);
    system_.contact().set_resting(!meets && !system_.contact().has_friction());
    return meets;
}

std::optional<PathPoint> Corrector::solve_from(const Frame& frame, const Constraint& constraint, double target,
                                               State guess) {
    if (const double share = newton_.share_without_crossing(frame.last.state, guess); share < 1.0)
        guess = between(frame.last.state, guess, share);
    if (!correct(constraint, target, guess)) return std::nullopt;
    auto tangent = newton_.tangent(bind(frame.control, frame.last), guess);
    if (!tangent) {
        last_result_.end = NewtonEnd::singular;
        return std::nullopt;
    }
    return measure(frame, std::move(guess), std::move(*tangent));
}

std::optional<PathPoint> Corrector::solve_between(const Frame& frame, const PathPoint& a, const PathPoint& b, double q,
                                                  WithContact contact) {
    State guess = predict(&a, b, q);
    Constraint constraint = bind(frame.control, a);
    constraint.scale = std::abs(b.q - a.q);
    const bool by_arc = constraint.kind == ConstraintKind::arc;
    const double target = by_arc ? value(constraint, frame.loads, guess) : q;
    auto point = solve_at(frame, constraint, target, std::move(guess), contact);
    if (point && by_arc) point->q = q;
    return point;
}

std::optional<PathPoint> Corrector::solve_goal(const Frame& frame, const Crossing& crossing, const PathPoint& from,
                                               PathPoint to, State guess) {
    const Goal& goal = *crossing.goal;
    if (goal.has_slope) return solve_at(frame, goal.constraint, goal.target, std::move(guess));
    const auto missing = [&](const PathPoint& point) { return value_of(goal.constraint, point) - goal.target; };
    const double accurate = goal_accuracy * (std::abs(goal.target) + std::abs(missing(from))),
                 shortest = goal_accuracy * std::abs(to.q - from.q);
    const double side = missing(to);
    std::optional<PathPoint> before;
    std::optional<double> root;
    for (int i = 0; i < goal_solves && std::abs(missing(to)) > accurate; ++i) {
        const PathPoint& low = before ? *before : from;
        if (std::abs(to.q - low.q) <= shortest) break;
        const double q = next_between({low.q, missing(low)}, {to.q, missing(to)}, root);
        auto point = solve_between(frame, low, to, q);
        if (!point) return std::nullopt;
        if (missing(*point) * side >= 0.0)
            to = std::move(*point);
        else
            before = std::move(point);
    }
    return to;
}

PathPoint Corrector::measure(const Frame& frame, State state, PathTangent tangent) {
    if (frame.control.kind == ConstraintKind::arc) scale(tangent, 1.0 / linalg::norm(tangent.x));
    PathPoint point{std::move(state), std::move(tangent)};
    read_values(system_, frame.loads, &frame.last, point);
    const double length = distance(point.state.x, frame.last.state.x);
    point.q = controlled_value(frame.control, point, frame.last.q + length);
    return point;
}

double Corrector::value(const Constraint& constraint, const StageLoads& loads, const State& state) {
    return evaluate(constraint, system_, loads, state, scratch_).value;
}

void Corrector::restore(const Memory& memory) {
    last_result_ = memory.first;
    newton_.confirm_pivots(memory.second);
}

}  // namespace soft::solver
