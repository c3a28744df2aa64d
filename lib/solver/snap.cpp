#include "solver/snap.hpp"

#include <cmath>

#include "solver/control.hpp"
#include "solver/work.hpp"

namespace soft::solver {

namespace {

/// Times the mean stiffness of the undeformed body: the first drag, those that end the motion, and factors on it.
constexpr double first_drag = 0.1, no_drag = 1e-9, too_large_drag = 1e6;
constexpr double after_success = 0.3, after_failure = 5.0;
constexpr int most_corrections = 200;
/// Of the displacements: a larger motion is no local snap.
constexpr double farthest = 0.1;

/// The constraint under which the body snaps: the control, in place of the arc length the volume where that is possible, or the load.
Constraint held_constraint(const Corrector& corrector, const PathState& path) {
    if (path.control.kind != ConstraintKind::arc) return path.control;
    const Constraint softer = softer_control(corrector.system(), *path.loads);
    return softer.kind == ConstraintKind::arc ? Constraint{ConstraintKind::load_factor} : softer;
}

/// Unstable directions that the constraint holds: one where the load falls, unless the load itself is held.
int held_modes(const PathState& path, const Constraint& held) {
    return held.kind != ConstraintKind::load_factor && path.load_falls(*path.last) ? 1 : 0;
}

/// The equilibrium at which the overdamped motion ends.
std::optional<State> settle(Corrector& corrector, const PathState& path, const Constraint& held, double target) {
    const Vec start = path.last->state.x;
    State state = copy_of(path.last->state);
    double drag = first_drag;
    for (int i = 0; i < most_corrections; ++i) {
        State next = copy_of(state);
        corrector.newton().set_drag(drag, state.x);
        const bool found = corrector.correct(held, target, next);
        if (found) state = std::move(next);
        if (distance(state.x, start) > farthest * linalg::norm(start)) return std::nullopt;
        if (found && drag == 0.0) return state;
        if (!found && drag == 0.0) drag = no_drag;
        drag *= found ? after_success : after_failure;
        if (drag > too_large_drag) return std::nullopt;
        if (drag < no_drag) drag = 0.0;
    }
    return std::nullopt;
}

/// `held` with the value `target`, to which it changes along the path.
std::optional<PathPoint> snap_to(Corrector& corrector, const PathState& path, Constraint held, double target) {
    const PathPoint& last = *path.last;
    const int modes = held_modes(path, held);
    const bool is_on_the_way = held.kind != ConstraintKind::load_factor || !path.load_falls(last);
    if (!last.tangent.unstable_modes || *last.tangent.unstable_modes > modes || !is_on_the_way) return std::nullopt;
    const double change = target - controlled_value(held, last, 0.0);
    held.scale = std::abs(change);
    std::optional<State> state = settle(corrector, path, held, target);
    corrector.newton().set_drag(0.0, nullptr);
    std::optional<PathTangent> tangent;
    if (state) tangent = corrector.newton().tangent(bind(path.control, last), *state);
    if (!tangent || !tangent->unstable_modes || *tangent->unstable_modes > modes) return std::nullopt;
    PathPoint point = corrector.measure(frame_of(path), std::move(*state), std::move(*tangent));
    if (path.control.kind == ConstraintKind::arc && control_slope(held, point) * change < 0.0)
        rescale(corrector.system(), *path.loads, point, -1.0);
    return point;
}

}  // namespace

std::optional<Snap> snap(Corrector& corrector, PathState& path, const Listeners& listeners, double step) {
    const Constraint held = held_constraint(corrector, path);
    PathPoint& last = *path.last;
    const Corrector::Memory memory = corrector.memory();
    const Goal* goal = nullptr;
    auto point = snap_to(corrector, path, held, controlled_value(held, last, 0.0) + control_slope(held, last) * step);
    if (const auto passed = point ? first_between(path.goals, last, *point) : std::nullopt) {
        goal = passed->goal;
        if (goal->has_slope) {  // else it has jumped over its target
            corrector.restore(memory);
            point = snap_to(corrector, path, goal->constraint, goal->target);
        }
    }
    if (!point || find_crossing(corrector, listeners, *point) || !find_work_of_jump(corrector, last, *point)) {
        corrector.restore(memory);
        return std::nullopt;
    }
    return Snap{std::move(*point), goal};
}

}  // namespace soft::solver
