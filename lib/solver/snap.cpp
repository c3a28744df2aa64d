#include "solver/snap.hpp"

#include <algorithm>
#include <cmath>

#include "fem/mass.hpp"
#include "solver/control.hpp"
#include "solver/work.hpp"

namespace soft::solver {

namespace {

/// Times the mean stiffness of the undeformed body: the first drag, those that end the motion, and factors on it.
constexpr double first_drag = 0.1, no_drag = 1e-9, too_large_drag = 1e6;
constexpr double after_success = 0.3, after_failure = 5.0;
constexpr int most_corrections = 200;
/// Of the displacements: a larger motion is no local snap.
constexpr double farthest = 0.1, longest = 0.01;
/// A fold in which the slope along the path, relative to the secant from its origin, changes by one within 1 / sharp of the displacements.
constexpr double sharp = 20.0;
/// Of the value of a quantity: it hardly jumps.
constexpr double small_jump = 0.01;
/// Of a quantity: the least change beyond a fold.
constexpr double least_change = 1e-4;

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

/// The equilibrium at which the overdamped motion from a state ends; the drag is that of the last correction.
std::optional<State> settle_with_drag(Corrector& corrector, const State& from, const Constraint& held, double target) {
    const Vec start = from.x;
    const linalg::Vector displacements = fem::displacement_mask(corrector.system());
    const auto length = [&](Vec x) {
        const linalg::Vector part = copy_of(x);
        SOFT_PETSC(VecPointwiseMult(part, part, displacements));
        return linalg::norm(part);
    };
    const auto distance = [&](Vec a, Vec b) {
        const linalg::Vector change = copy_of(a);
        linalg::add(change, -1.0, b);
        return length(change);
    };
    const double size = length(start);
    State state = copy_of(from);
    double drag = first_drag;
    for (int i = 0; i < most_corrections; ++i) {
        State next = copy_of(state);
        corrector.newton().set_drag(drag, state.x);
        bool found = corrector.correct(held, target, next);
        found = found && distance(next.x, state.x) <= longest * size;
        if (found) state = std::move(next);
        if (distance(state.x, start) > farthest * size) return std::nullopt;
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
    std::optional<State> state = settle(corrector, last.state, held, target);
    std::optional<PathTangent> tangent;
    if (state) tangent = corrector.newton().tangent(bind(path.control, last), *state);
    if (!tangent || !tangent->unstable_modes || *tangent->unstable_modes > modes) return std::nullopt;
    PathPoint point = corrector.measure(frame_of(path), std::move(*state), std::move(*tangent));
    if (path.control.kind == ConstraintKind::arc && control_slope(held, point) * change < 0.0)
        rescale(corrector.system(), *path.loads, point, -1.0);
    return point;
}

bool is_displacement(const model::Output& output) {
    return !model::is_reaction(output.measure) && output.obstacle.empty();
}

/// Whether a quantity turns back between two points, within a small motion.
bool turns_sharply(const Constraint& quantity, const PathPoint& last, const PathPoint& beyond) {
    const double size = linalg::norm(last.state.x), secant = value_of(quantity, last) / size;
    const auto slope = [&](const PathPoint& at) { return control_slope(quantity, at) / linalg::norm(at.tangent.x); };
    return slope(last) * slope(beyond) < 0.0 && std::abs(slope(beyond) - slope(last)) * size >
                                                    sharp * std::abs(secant) * distance(last.state.x, beyond.state.x);
}

/// Whether the load, the volumes and the displacements of the outputs do.
bool hardly_jumps(const PathPoint& from, const PathPoint& to, const PathState& path, const model::Case& input) {
    const auto stays = [](double a, double b, double origin = 0.0) {
        return std::abs(b - a) <= small_jump * std::abs(a - origin);
    };
    for (std::size_t i = 0; i < from.load_volumes_m3.size(); ++i)
        if (!stays(from.load_volumes_m3[i], to.load_volumes_m3[i], path.undeformed_volumes_m3[i])) return false;
    for (std::size_t i = 0; i < from.outputs.size(); ++i)
        if (is_displacement(input.outputs[i]) && !stays(from.outputs[i], to.outputs[i])) return false;
    return stays(from.leading, to.leading);
}

/// What may be held while the body snaps: what the user controls, or a volume or displacement, and the load.
std::vector<Constraint> held_quantities(const fem::System& system, const PathState& path) {
    const model::Case& input = system.input();
    if (path.user_control) return {*path.user_control};
    if (stage_of(input, path).control != model::Control::automatic) return {};  // arc length
    std::vector<Constraint> held;
    const Constraint softer = softer_control(system, *path.loads);
    const auto output = std::ranges::find_if(input.outputs, is_displacement);
    if (softer.kind != ConstraintKind::arc)
        held.push_back(softer);
    else if (output != input.outputs.end())
        held.push_back({ConstraintKind::output, static_cast<std::size_t>(output - input.outputs.begin())});
    held.push_back({ConstraintKind::load_factor});
    return held;
}

/// The snap to `held` at `target`, or to a goal before it.
std::optional<Snap> snap_towards(Corrector& corrector, PathState& path, const Listeners& listeners,
                                 const Constraint& held, double target) {
    PathPoint& last = *path.last;
    const Corrector::Memory memory = corrector.memory();
    const Goal* goal = nullptr;
    corrector.system().contact().set_resting(false);  // a crease may close
    auto point = snap_to(corrector, path, held, target);
    if (const auto passed = point ? first_between(path.goals, last, *point) : std::nullopt) {
        goal = passed->goal;
        if (goal->has_slope) {  // else it has jumped over its target
            corrector.restore(memory);
            point = snap_to(corrector, path, goal->constraint, goal->target);
        }
    }
    if (!point || find_crossing(corrector, listeners, *point) || !find_work_of_jump(corrector, last, *point)) {
        corrector.restore(memory);
        let_contact_rest(corrector.system(), last, last);
        return std::nullopt;
    }
    return Snap{std::move(*point), goal};
}

}  // namespace

std::optional<State> settle(Corrector& corrector, const State& from, const Constraint& held, double target) {
    std::optional<State> state = settle_with_drag(corrector, from, held, target);
    corrector.newton().set_drag(0.0, nullptr);
    return state;
}

std::optional<Snap> snap(Corrector& corrector, PathState& path, const Listeners& listeners, double step) {
    const Constraint held = held_constraint(corrector, path);
    const PathPoint& last = *path.last;
    return snap_towards(corrector, path, listeners, held,
                        controlled_value(held, last, 0.0) + control_slope(held, last) * step);
}

std::optional<Snap> snap_over(const PathPoint& beyond, Corrector& corrector, PathState& path,
                              const Listeners& listeners) {
    if (path.control.kind != ConstraintKind::arc) return std::nullopt;
    const PathPoint& last = *path.last;
    const Corrector::Memory memory = corrector.memory();
    for (const Constraint& held : held_quantities(corrector.system(), path)) {
        if (!turns_sharply(held, last, beyond)) continue;
        const double from = value_of(held, last), to = value_of(held, beyond),
                     sense = control_slope(held, last) * path.step;
        const double extreme = sense > 0.0 ? std::max(from, to) : std::min(from, to);
        const double target = extreme + std::copysign(least_change * std::abs(from), sense);
        auto found = snap_towards(corrector, path, listeners, held, target);
        if (found && hardly_jumps(last, found->point, path, corrector.input())) return found;
        if (!found) continue;
        corrector.restore(memory);
        let_contact_rest(corrector.system(), last, last);
    }
    return std::nullopt;
}

}  // namespace soft::solver
