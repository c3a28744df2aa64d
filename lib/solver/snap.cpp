#include "solver/snap.hpp"

#include <algorithm>
#include <cmath>

#include "solver/control.hpp"
#include "solver/row_state.hpp"

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

/// Work of the loads less the gain of stored energy.
double lost_energy(fem::System& system, const PathPoint& from, const PathPoint& to, double work_J) {
    const auto stored = [&](const PathPoint& point) {
        system.prescribe(point.levels);
        return system.fields().stored_energy(point.state.x);
    };
    return std::max(work_J - (stored(to) - stored(from)), 0.0);
}

/// By the mean of the loads at both ends.
double work_of_jump(fem::System& system, const PathPoint& from, const PathPoint& to) {
    const linalg::Vector motion = copy_of(to.state.x);
    linalg::add(motion, -1.0, from.state.x);
    const fem::LoadLevels change = fem::moved(to.levels, -1.0, from.levels);
    return 0.5 * (system.assembler().load_power(from.state.x, motion, from.levels, change) +
                  system.assembler().load_power(to.state.x, motion, to.levels, change));
}

/// `held` with the value `target`, to which it changes along the path.
std::optional<PathPoint> snap_to(Corrector& corrector, const PathState& path, Constraint held, double target) {
    const PathPoint& last = *path.last;
    const int modes = held_modes(path, held);
    const bool is_on_the_way = held.kind != ConstraintKind::load_factor || !path.load_falls(last);
    if (!last.tangent.unstable_modes || *last.tangent.unstable_modes > modes || !is_on_the_way) return std::nullopt;
    const double change = target - controlled_value(held, last, 0.0);
    held.scale = std::abs(change);
    const Corrector::Memory memory = corrector.memory();
    std::optional<State> state = settle(corrector, path, held, target);
    corrector.newton().set_drag(0.0, nullptr);
    std::optional<PathTangent> tangent;
    if (state) tangent = corrector.newton().tangent(bind(path.control, last), *state);
    if (!tangent || !tangent->unstable_modes || *tangent->unstable_modes > modes) {
        corrector.restore(memory);
        return std::nullopt;
    }
    PathPoint point = corrector.measure(frame_of(path), std::move(*state), std::move(*tangent));
    if (path.control.kind == ConstraintKind::arc && control_slope(held, point) * change < 0.0)
        rescale(corrector.system(), *path.loads, point, -1.0);
    point.step_work_J = work_of_jump(corrector.system(), last, point);
    if (corrector.system().has_symmetric_tangent())
        point.lost_J = lost_energy(corrector.system(), last, point, *point.step_work_J);
    return point;
}

}  // namespace

std::optional<Snap> snap(Corrector& corrector, const PathState& path, double step) {
    const Constraint held = held_constraint(corrector, path);
    const PathPoint& last = *path.last;
    auto point = snap_to(corrector, path, held, controlled_value(held, last, 0.0) + control_slope(held, last) * step);
    if (!point) return std::nullopt;
    const auto passed = first_between(path.goals, last, *point);
    if (!passed) return Snap{std::move(*point)};
    point = snap_to(corrector, path, passed->goal->constraint, passed->goal->target);
    if (!point) return std::nullopt;
    return Snap{std::move(*point), passed->goal};
}

}  // namespace soft::solver
