#include "solver/snap.hpp"

#include <algorithm>
#include <cmath>

#include "fem/mass.hpp"
#include "solver/control.hpp"
#include "solver/stepping.hpp"
#include "solver/work.hpp"

namespace soft::solver {

namespace {

/// Times the mean stiffness of the undeformed body: the first drag, those that end the motion, and factors on it.
constexpr double first_drag = 0.1, no_drag = 1e-9, too_large_drag = 1e6;
constexpr double after_success = 0.3, after_failure = 5.0;
constexpr int most_corrections = 200;
/// Of the failed step, until a snap is found: a part of a prescribed motion may itself be longer than a correction may be.
constexpr double parts_of_step[] = {1.0, 0.1, 0.01};
/// Of the displacements: the largest motion in one correction.
constexpr double longest = 0.01;
/// Curvature from which on a fold is sharp: of a quantity over the length of the path, each relative to its value.
constexpr double sharp = 20.0;
/// Volume ratio at a point of the rubber below which it may crease: creases are searched there alone.
constexpr double crushed = 0.75;
/// At a fold: largest change of the load and of volumes, and of the displacements.
constexpr double small_jump = 0.01, small_motion = 0.03;
/// Of a quantity: the least change beyond a fold. Of the stored energy: what a snap sets free, in contrast to a step on the same path.
constexpr double least_change = 1e-4, least_energy = 1e-6;
/// Of the mean displacement: an output below is rounding, as of a symmetric body.
constexpr double no_displacement = 0.01;

/// Lengths of displacements, without the pressures of mixed cells, which change most where a crease forms.
class DisplacementNorm {
public:
    explicit DisplacementNorm(const fem::System& system) : mask_(fem::displacement_mask(system)) {}
    [[nodiscard]] double operator()(Vec x) const {
        const linalg::Vector part = copy_of(x);
        SOFT_PETSC(VecPointwiseMult(part, part, mask_));
        return linalg::norm(part);
    }
    [[nodiscard]] double distance(Vec a, Vec b) const {
        const linalg::Vector change = copy_of(a);
        linalg::add(change, -1.0, b);
        return (*this)(change);
    }
    [[nodiscard]] double mean(Vec x) const { return (*this)(x) / linalg::norm(mask_); }

private:
    linalg::Vector mask_;
};

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

/// `held` with the value `target`, to which it changes along the path.
std::optional<PathPoint> snap_to(Corrector& corrector, const PathState& path, Constraint held, double target,
                                 double farthest) {
    const PathPoint& last = *path.last;
    const int modes = held_modes(path, held);
    const bool is_on_the_way = held.kind != ConstraintKind::load_factor || !path.load_falls(last);
    if (!last.tangent.unstable_modes || *last.tangent.unstable_modes > modes || !is_on_the_way) return std::nullopt;
    const double change = target - controlled_value(held, last, 0.0);
    held.scale = std::abs(change);
    std::optional<State> state = settle(corrector, last.state, held, target, farthest);
    std::optional<PathTangent> tangent;
    if (state) tangent = corrector.newton().tangent(bind(path.control, last), *state);
    if (!tangent || !tangent->unstable_modes || *tangent->unstable_modes > modes) return std::nullopt;
    PathPoint point = corrector.measure(frame_of(path), std::move(*state), std::move(*tangent));
    if (path.control.kind == ConstraintKind::arc && control_slope(held, point) * change < 0.0)
        rescale(corrector.system(), *path.loads, point, -1.0);
    return point;
}

/// As before a snap that is not taken.
void restore(Corrector& corrector, const Corrector::Memory& memory, const PathPoint& last) {
    corrector.restore(memory);
    let_contact_rest(corrector.system(), last, last);
}

/// What may be held while the body snaps: what the user controls, or a volume or the displacements, and the load.
std::vector<Constraint> held_quantities(const fem::System& system, const PathState& path) {
    const model::Case& input = system.input();
    if (path.user_control) return {*path.user_control};
    if (stage_of(input, path).control != model::Control::automatic) return {};  // arc length
    std::vector<Constraint> held;
    if (const Constraint softer = softer_control(system, *path.loads); softer.kind != ConstraintKind::arc)
        held.push_back(softer);
    else
        for (std::size_t i = 0; i < input.outputs.size(); ++i)
            if (is_displacement(input.outputs[i])) held.push_back({ConstraintKind::output, i});
    held.push_back({ConstraintKind::load_factor});
    return held;
}

bool is_crushed(fem::System& system, const PathPoint& point) {
    model::Step step;
    read_rubber(system, point, 1.0, step);
    return step.min_jacobian < crushed;
}

/// A quantity at a point, from its value in the undeformed body on, and its slope.
struct Quantity {
    double value, slope;
};

Quantity quantity_at(const Constraint& held, const PathPoint& point, const PathState& path) {
    if (held.kind == ConstraintKind::load_factor) return {point.leading, point.leading_slope};
    const double undeformed = held.kind == ConstraintKind::volume ? path.undeformed_volumes_m3[held.index] : 0.0;
    return {value_of(held, point) - undeformed, control_slope(held, point)};
}

/// The value that a quantity passes where it turns back between two points, if it does so within a small motion.
std::optional<double> beyond_fold(const Constraint& held, const PathPoint& last, const PathPoint& beyond,
                                  const PathState& path, const fem::System& system) {
    const Quantity from = quantity_at(held, last, path), to = quantity_at(held, beyond, path);
    if (!(from.slope * to.slope < 0.0)) return std::nullopt;
    const DisplacementNorm norm(system);
    const double turn = std::abs(to.slope / norm(beyond.tangent.x) - from.slope / norm(last.tangent.x)),
                 way = norm.distance(last.state.x, beyond.state.x), size = norm(last.state.x);
    const bool is_rounding =
        held.kind == ConstraintKind::output && std::abs(from.value) < no_displacement * norm.mean(last.state.x);
    if (is_rounding || !(turn * size * size > sharp * std::abs(from.value) * way)) return std::nullopt;
    // Twice the rise of the parabola with these slopes.
    const double slope = control_slope(held, last), step = beyond.q - last.q;
    const double rise = slope * step * slope / (slope - control_slope(held, beyond));
    return value_of(held, last) + rise + std::copysign(least_change * std::abs(value_of(held, last)), rise);
}

/// Whether the load and volumes hardly change, but the body is in another state.
bool is_local(const PathPoint& from, const PathPoint& to, const PathState& path, const fem::System& system) {
    double largest = 0.0, change = 0.0;  // of all volumes
    for (std::size_t i = 0; i < from.load_volumes_m3.size(); ++i) {
        largest = std::max(largest, std::abs(from.load_volumes_m3[i] - path.undeformed_volumes_m3[i]));
        change = std::max(change, std::abs(to.load_volumes_m3[i] - from.load_volumes_m3[i]));
    }
    const bool sets_energy_free = !system.has_energy() || to.lost_J > least_energy * *to.stored_J;
    return sets_energy_free && change <= small_jump * largest &&
           std::abs(to.leading - from.leading) <= small_jump * std::abs(from.leading);
}

/// The snap to `held` at `target`, or to a goal before it.
std::optional<Snap> snap_towards(Corrector& corrector, PathState& path, const Listeners& listeners,
                                 const Constraint& held, double target, double farthest) {
    PathPoint& last = *path.last;
    const Goal* goal = nullptr;
    const Corrector::Memory memory = corrector.memory();
    corrector.system().contact().set_resting(false);  // a crease may close
    auto point = snap_to(corrector, path, held, target, farthest);
    if (const auto passed = point ? first_between(path.goals, last, *point) : std::nullopt) {
        goal = passed->goal;
        if (goal->has_slope) {  // else it has jumped over its target
            corrector.restore(memory);
            point = snap_to(corrector, path, goal->constraint, goal->target, farthest);
        }
    }
    if (point && !corrector.newton().passes_through_obstacle(last.state, point->state) &&
        !walls_at(corrector, listeners, *point) && find_work_of_jump(corrector, last, *point))
        return Snap{std::move(*point), goal};
    restore(corrector, memory, last);
    return std::nullopt;
}

}  // namespace

std::optional<State> settle(Corrector& corrector, const State& from, const Constraint& held, double target,
                            double farthest) {
    const DisplacementNorm norm(corrector.system());
    const double size = norm(from.x);
    State state = copy_of(from);
    double drag = first_drag;
    bool settled = false;
    for (int i = 0; i < most_corrections && !settled; ++i) {
        State next = copy_of(state);
        corrector.newton().set_drag(drag, state.x);
        const bool found = corrector.correct(held, target, next) && norm.distance(next.x, state.x) <= longest * size;
        if (found) state = std::move(next);
        settled = found && drag == 0.0;
        if (!found && drag == 0.0) drag = no_drag;
        drag *= found ? after_success : after_failure;
        if (drag > too_large_drag || norm.distance(state.x, from.x) > farthest * size) break;
        if (drag < no_drag) drag = 0.0;
    }
    corrector.newton().set_drag(0.0, nullptr);
    if (!settled) return std::nullopt;
    return state;
}

std::optional<Snap> snap(Corrector& corrector, PathState& path, const Listeners& listeners, double step) {
    const Constraint held = held_constraint(corrector, path);
    const PathPoint& last = *path.last;
    const double start = controlled_value(held, last, 0.0), change = control_slope(held, last) * step;
    // A change below the accuracy of a state leads nowhere.
    const double known = equilibrium_margin * corrector.input().solver.residual_tolerance * std::abs(start);
    for (const double part : parts_of_step) {
        if (!(std::abs(part * change) > known)) break;
        if (auto found = snap_towards(corrector, path, listeners, held, start + part * change, farthest_snap))
            return found;
        if (corrector.system().contact().has_friction()) break;  // which turns round within a small part of the step
    }
    return std::nullopt;
}

std::optional<Snap> snap_off(const PathPoint& beyond, const Events& events, Corrector& corrector, PathState& path,
                             const Listeners& listeners) {
    const PathPoint& last = *path.last;
    const auto before = branch_index(path, last), after = branch_index(path, beyond);
    const auto bifurcates = [](const Event& event) { return event.kind == Event::Kind::bifurcation; };
    if (!last.touches || !beyond.touches || !before || !after || *after <= *before ||
        std::ranges::any_of(events.list, bifurcates) || held_quantities(corrector.system(), path).empty())
        return std::nullopt;
    return snap(corrector, path, listeners, beyond.q - last.q);
}

std::optional<Snap> snap_over(const PathPoint& beyond, Corrector& corrector, PathState& path,
                              const Listeners& listeners) {
    if (path.control.kind != ConstraintKind::arc) return std::nullopt;
    const PathPoint& last = *path.last;
    const Corrector::Memory memory = corrector.memory();
    for (const Constraint& held : held_quantities(corrector.system(), path)) {
        const auto target = beyond_fold(held, last, beyond, path, corrector.system());
        if (!target || !is_crushed(corrector.system(), last)) continue;
        auto found = snap_towards(corrector, path, listeners, held, *target, small_motion);
        if (found && is_local(last, found->point, path, corrector.system())) return found;
        if (found) restore(corrector, memory, last);
    }
    return std::nullopt;
}

}  // namespace soft::solver
