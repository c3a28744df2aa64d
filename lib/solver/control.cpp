#include "solver/control.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "solver/path.hpp"

namespace soft::solver {

using model::Control;

namespace {

/// A relative change of the volume over the whole stage below this is lost in rounding.
constexpr double min_volume_change = 1e-6;
/// Consecutive failures before the path is followed by another control.
constexpr int failures_before_other_control = 3;

[[noreturn]] void refuse_control(const char* problem, const char* remedy) {
    throw Error(ExitCode::bad_input, "path.control", problem, remedy);
}

/// Relative change, over the last step, of the path's tangent per unit of a control.
double bend_under(const Constraint& control, const PathPoint& before, const PathPoint& last) {
    const linalg::Vector change = copy_of(last.tangent.x);
    linalg::add(change, -control_slope(control, last) / control_slope(control, before), before.tangent.x);
    return linalg::norm(change) / linalg::norm(last.tangent.x);
}

/// In such a stage the body follows where contact closes, and rests once it has opened: then no other control than the load reaches the end.
bool moves_obstacles_alone(const model::Case& input, const StageLoads& loads) {
    const LoadLevels& rate = loads.rate();
    const auto stays = [](double r) { return r == 0.0; };
    bool moves = loads.free_supplies().empty() && std::ranges::all_of(rate.pressures_Pa, stays) &&
                 std::ranges::all_of(rate.dead_loads, stays);
    for (std::size_t i = 0; i < rate.motions.size(); ++i)
        moves = moves && (stays(rate.motions[i]) || model::moves_obstacle(input, input.motions[i]));
    return moves;
}

/// Whether the load reaches its maximum within a few steps, estimated from the decrease of its slope over the path length, and the
/// steps are already short.
bool is_near_maximum(const PathState& path) {
    if (!path.before || std::abs(path.step) > short_step_of_load * std::abs(path.last->q)) return false;
    const double length = distance(path.last->state.x, path.before->state.x);
    const auto slope = [](const PathPoint& point) {
        return 1.0 / linalg::norm(point.tangent.x);
    };  // d load factor / d length
    const double fall = slope(*path.before) - slope(*path.last);
    return length > 0.0 && slope(*path.last) < steps_to_a_maximum * fall;
}

}  // namespace

bool is_displacement(const model::Output& output) {
    return !model::is_reaction(output.measure) && output.obstacle.empty();
}

Constraint first_control(const fem::System& system, const model::Stage& stage) {
    const model::Case& input = system.input();
    if (stage.time_s) return {ConstraintKind::load_factor};
    switch (stage.control) {
        case Control::automatic:
        case Control::pressure: return {ConstraintKind::load_factor};
        case Control::arc_length: return {ConstraintKind::arc};
        case Control::volume:
            for (std::size_t load = 0; load < input.loads.size(); ++load) {
                const bool encloses = system.volumes().has_volume(load);
                if (stage.controlled.empty() ? !encloses : input.loads[load].name != stage.controlled) continue;
                if (encloses) return {ConstraintKind::volume, load};
            }
            refuse_control("volume control needs a loaded cavity", "use pressure, displacement or arc-length");
        case Control::displacement:
            for (std::size_t output = 0; output < input.outputs.size(); ++output)
                if (stage.controlled.empty() ? is_displacement(input.outputs[output])
                                             : input.outputs[output].name == stage.controlled)
                    return {ConstraintKind::output, output};
            refuse_control("displacement control needs an output", "define one under outputs");
    }
    return {};
}

Constraint softer_control(const fem::System& system, const StageLoads& loads) {
    std::size_t growing = 0, others = loads.free_supplies().size();
    std::optional<std::size_t> load;
    const LoadLevels& rate = loads.rate();
    for (std::size_t i = 0; i < rate.pressures_Pa.size(); ++i)
        if (rate.pressures_Pa[i] != 0.0) {
            ++growing;
            load = i;
        }
    for (const auto* list : {&rate.dead_loads, &rate.motions})
        for (const double r : *list) others += r != 0.0 ? 1 : 0;
    if (growing != 1 || others > 0 || !system.volumes().has_volume(*load)) return {ConstraintKind::arc};
    return {ConstraintKind::volume, *load};
}

bool is_lost_in_rounding(const Constraint& control, const StageLoads& loads, const PathPoint& by_load) {
    if (control.kind != ConstraintKind::volume || !loads.free_supplies().empty()) return false;
    const double slope = slope_of(control, by_load) / by_load.tangent.load_factor;
    return std::abs(slope) < min_volume_change * std::abs(value_of(control, by_load));
}

double controlled_value(const Constraint& control, const PathPoint& point, double arc_length) {
    return control.kind == ConstraintKind::arc ? arc_length : value_of(control, point);
}

double control_slope(const Constraint& control, const PathPoint& point) {
    return control.kind == ConstraintKind::arc ? linalg::norm(point.tangent.x) : slope_of(control, point);
}

double first_step(const model::SolverSettings& settings, const Constraint& control, double slope, double sense) {
    if (settings.steps != model::StepRule::constant) return round_step_size(settings.first_step * sense * slope);
    return control.kind == ConstraintKind::load_factor ? settings.first_step : settings.first_step * sense * slope;
}

std::optional<ControlChange> better_control(const fem::System& system, const PathState& path) {
    const model::SolverSettings& settings = system.input().solver;
    if (path.control.kind != ConstraintKind::load_factor || stage_of(system.input(), path).time_s) return std::nullopt;
    if (stage_of(system.input(), path).control != Control::automatic) {
        if (settings.steps != model::StepRule::error_adaptive || !is_near_maximum(path)) return std::nullopt;
        return ControlChange{{ConstraintKind::arc}, "the load nears a maximum"};
    }
    if (moves_obstacles_alone(system.input(), *path.loads)) return std::nullopt;  // the motion is prescribed
    const Constraint other = softer_control(system, *path.loads);
    if (path.first_slope > 0.0 && linalg::norm(path.last->tangent.x) > softening * path.first_slope)
        return ControlChange{other, "the body softens"};
    const double bend = bend_under(path.control, *path.before, *path.last);
    if (bend > settings.step_accuracy * straight_enough &&
        bend_under(other, *path.before, *path.last) < straighter * bend)
        return ControlChange{other, "the path is straighter there"};
    return std::nullopt;
}

std::optional<ControlChange> control_after_failure(const fem::System& system, const PathState& path, NewtonEnd failure,
                                                   bool too_short) {
    if (stage_of(system.input(), path).time_s) return std::nullopt;
    const bool is_automatic = stage_of(system.input(), path).control == Control::automatic;
    if (path.control.kind == ConstraintKind::arc) {
        // Where contact opens, an obstacle that moves on moves nothing else: the bordered matrix is singular, K is not.
        const bool may_open = is_automatic && path.last->touches && failure == NewtonEnd::singular &&
                              path.last->tangent.unstable_modes.value_or(0) == 0 &&
                              path.last->tangent.load_factor != 0.0 && path.load_control_at != path.rows;
        return may_open ? std::optional(ControlChange{{ConstraintKind::load_factor}, "the loads may move nothing"})
                        : std::nullopt;
    }
    const bool is_free = path.control.kind == ConstraintKind::load_factor && is_automatic;
    const bool leaves_at_once = is_free && !moves_obstacles_alone(system.input(), *path.loads);
    if (!leaves_at_once && !too_short && path.attempts.failures < failures_before_other_control) return std::nullopt;
    const Constraint other = is_free ? softer_control(system, *path.loads) : Constraint{ConstraintKind::arc};
    if (control_slope(other, *path.last) == 0.0) return std::nullopt;
    return ControlChange{other, is_free ? "a step under the load factor fails"
                                        : "steps under the " + std::string(name(path.control.kind)) + " fail"};
}

void set_control(fem::System& system, PathState& path, const Constraint& control) {
    const double sense = path.direction(), reach = std::abs(path.step) * linalg::norm(path.last->tangent.x);
    for (auto* point : {&path.before, &path.last})
        if (*point) rescale(system, *path.loads, **point, sense);  // now in the direction of travel
    path.control = control;
    double span = 0;
    if (path.before) {
        span = distance(path.last->state.x, path.before->state.x);
        if (control_slope(control, *path.before) * control_slope(control, *path.last) <= 0.0) path.before.reset();
    }
    const double direction = control_slope(control, *path.last) < 0.0 ? -1.0 : 1.0;
    for (auto* point : {&path.before, &path.last})
        if (*point) {
            rescale(system, *path.loads, **point, 1.0 / control_slope(control, **point));
            (*point)->q = controlled_value(control, **point, point == &path.before ? -span : 0.0);
        }
    const double step = direction * reach / linalg::norm(path.last->tangent.x);
    const bool constant = system.input().solver.steps == model::StepRule::constant;
    path.step = path.first_step = constant ? step : round_step_size(step);
    path.attempts = {};
}

void rescale(fem::System& system, const StageLoads& loads, PathPoint& point, double factor) {
    scale(point.tangent, factor);
    auto outputs = std::move(point.outputs);  // angles stay beyond half a turn
    read_values(system, loads, nullptr, point);
    point.outputs = std::move(outputs);
}

}  // namespace soft::solver
