#include "solver/path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"
#include "fem/rigid_motion.hpp"
#include "model/location.hpp"
#include "solver/control.hpp"
#include "solver/kink.hpp"
#include "solver/path_end.hpp"
#include "solver/path_follower.hpp"
#include "solver/row_state.hpp"
#include "solver/snap.hpp"
#include "solver/stages.hpp"
#include "solver/stepping.hpp"
#include "solver/work.hpp"

namespace soft::solver {

using model::StopReason;

namespace {

/// Factor on min_step under arc-length control. The arc length is that of the whole body: a fold in which only one cell snaps through
/// turns within a very small fraction of any other step.
constexpr double arc_of_one_cell = 1e-3;
/// Of the step in which the actuator touches something for the first time.
constexpr double step_after_contact = 0.05;
/// Of a failed step.
constexpr double cut_of_failed_step = 0.4;
/// Of steps in which a prescribed displacement meets an obstacle, until the path ends there.
constexpr int failures_before_driven = 6;

void check_case(const model::Case& input) {
    if (const auto motion = fem::free_rigid_motion(input))
        throw Error(ExitCode::bad_input, "supports", "no support prevents a rigid " + *motion,
                    "fix a face in that direction");
    if (input.path.stages.empty()) throw Error(ExitCode::bad_input, "path", "the load programme has no stages");
}

/// Where the next row will be.
model::LimitPoint location_of(const PathPoint& point, const PathState& path, const fem::System& system) {
    model::LimitPoint location{path.rows, point.leading, std::nullopt, point.outputs};
    if (!system.input().loads.empty() && system.volumes().has_volume(0)) location.volume_m3 = point.load_volumes_m3[0];
    return location;
}

}  // namespace

PathFollower::PathFollower(fem::System& system, const Listeners& listeners, Sensitivities* sensitivities)
    : system_(system),
      input_(system.input()),
      listeners_(listeners),
      corrector_(system),
      recorder_(corrector_, listeners, sensitivities) {
    path_.undeformed_volumes_m3 = undeformed_volumes_m3(system);
    require_gas(input_, path_.undeformed_volumes_m3);
}

model::PathEnd PathFollower::run(const model::Checkpoint* from) {
    if (from != nullptr) {
        restore(*from, corrector_, path_);
        recorder_.resume(*from);
        recorder_.report_control(path_);
    } else {
        start();
    }
    while (!path_.finished) {
        const int rows = path_.rows;
        step();
        if (!path_.finished && path_.rows > rows) recorder_.keep_checkpoint(path_);
    }
    return recorder_.end_of(path_);
}

void PathFollower::start() {
    system_.prescribe(fem::no_loads(input_));
    system_.contact().set_resting(!system_.contact().has_friction() && !system_.has_initial_stress() &&
                                  !system_.contact().touches(system_.make_vector()));
    set_stage(0, unloaded(input_, path_.undeformed_volumes_m3), corrector_, path_);
    if (!path_.loads->changes() && input_.path.stages.size() == 1)
        throw Error(ExitCode::bad_input, "loads", "no load acts on the body", "set loads.cavity.pressure");
    State state{system_.make_vector(), 0.0, std::vector(path_.loads->free_supplies().size(), 0.0)};
    if (system_.has_initial_stress()) {  // row 0 is the unloaded equilibrium, not the undeformed state
        const NewtonEnd end = corrector_.newton().correct({ConstraintKind::load_factor}, 0.0, state).end;
        if (end != NewtonEnd::converged)
            throw start_error(end, "no equilibrium without load under the law's initial stress");
    }
    begin(std::move(state));
    recorder_.append(path_, *path_.last);
    pass_hold();
}

/// One step of the path: predict, correct, check; events; record; adapt.
void PathFollower::step() {
    if (auto stop = stop_before_step(path_, system_)) return finish(std::move(*stop));
    if (path_.rows > last_row_of_stage(path_, input_)) return end_stage("number of steps");

    corrector_.newton().couple_contact(path_.last->state);
    Aim aim = aim_of(path_, corrector_);
    std::optional<Event> touch;
    auto point = solve_step(aim, touch);
    if (!point) return recover();
    if (auto stop = stop_before_row(path_, *point, system_)) return finish(std::move(*stop));

    const PredictorError error = error_of(system_, path_, aim, *point);
    if (is_refused(system_, path_, error, *point)) {
        path_.attempts.rejected_error = error.state;
        if (touch) path_.step = point->q - path_.last->q;
        return recover();
    }
    path_.attempts.crossing = find_crossing(corrector_, listeners_, *point);
    if (path_.attempts.crossing) {
        path_.refused = {path_.rows, *path_.attempts.crossing};
        return recover();
    }
    const bool has_friction = system_.contact().has_friction();
    const bool stays_in_contact = point->touches && path_.last->touches && !has_friction;
    const bool may_jump =
        stays_in_contact || ((system_.has_kinks() || has_friction) && path_.attempts.failures < failures_before_kink);
    if (may_jump && breaks_energy_balance(corrector_, path_, *point)) return recover();
    const double taken = point->q - path_.last->q;
    if (shorten_for_the_curve(system_, path_, aim, error.larger(), *point))
        return report_row("step of " + short_text(taken) + " is too long for the curve (predictor error " +
                          short_text(error.larger()) + "): repeated with a shorter step");
    const auto late = error_in_time(system_, path_, *point);
    if (shorten_for_time(system_, path_, late, *point))
        return report_row("step of " + short_text(taken) + " has " + short_text(*late) +
                          " times the error in time allowed: repeated with a shorter step");
    if (touch && is_first_try(system_, path_, taken)) reduce_first_step(path_, round_step_size(taken));
    path_.attempts = {};
    report_row(describe(*point) + row_text(*point, error, corrector_.last_result().iterations));

    const auto contact = find_contact(corrector_, path_, listeners_, *point);
    if (contact) touch.reset();  // the path ends before it
    const Goal* goal = aim.crossing && !contact ? aim.crossing->goal : nullptr;
    if (pass_goals(point, goal)) touch.reset();
    if (!point) return recover();
    const bool may_snap = !contact && !touch && goal == nullptr && point->touches == path_.last->touches;
    if (auto found = may_snap ? snap_over(*point, corrector_, path_, listeners_) : std::nullopt)
        return go_on_after_snap(std::move(*found), "a small part snaps to ");
    Events events = events_before(*point, corrector_, path_, listeners_);
    if (auto found = may_snap ? snap_off(*point, events, corrector_, path_, listeners_) : std::nullopt)
        return go_on_after_snap(std::move(*found), "contact snaps to ");
    const bool is_located = touch.has_value();
    if (!is_located) touch = first_contact_before(*point, corrector_, path_, WithContact::yes);
    const bool at_goal = !is_located && touch && goal != nullptr && is_beside(*touch, *point, taken);
    if (is_located || at_goal) touch->point = std::move(*point);
    if (touch) events.add(std::move(*touch), path_.direction());
    if (pass_events(std::move(events), at_goal ? goal : nullptr)) return;

    commit(std::move(*point));
    if (goal != nullptr) return end_stage(goal->text);
    if (contact) return finish({contact->reason, contact->end_at(describe(*path_.last))});
    if (auto stop = stop_at_row(path_, system_)) return finish(std::move(*stop));

    path_.step = next_step(input_, path_, aim, error, corrector_.last_result());
    if (limits_steps_in_time(system_, path_)) path_.step = std::min(path_.step, longest_in_time(path_, late));
    if (const auto change = better_control(system_, path_)) change_control(*change);
}

/// Moves `point` back to a goal that has been passed; one without a slope may lie before that which is aimed at or has been found. Whether it has
/// moved; no point where that fails.
bool PathFollower::pass_goals(std::optional<PathPoint>& point, const Goal*& goal) {
    bool moves = false;
    for (std::size_t tried = 0; tried < path_.goals.size() && point; ++tried) {
        const auto passed = first_between(path_.goals, *path_.last, *point);
        if (!passed || passed->goal == goal || (goal != nullptr && passed->goal->has_slope)) break;
        goal = passed->goal;
        State guess = predict(&*path_.last, *point, passed->q);
        point = corrector_.solve_goal(frame_of(path_), *passed, *path_.last, std::move(*point), std::move(guess));
        moves = true;
    }
    return moves;
}

std::optional<PathPoint> PathFollower::solve_step(Aim& aim, std::optional<Event>& touch) {
    const Frame frame = frame_of(path_);
    State guess = guess_of(aim, path_, input_.solver.predictor);
    if (!frame.last.touches) {
        const Corrector::Memory memory = corrector_.memory();
        auto point = corrector_.solve_at(frame, aim.constraint, aim.target, copy_of(guess), WithContact::no);
        if (!point || !corrector_.wake_contact_if_met(frame, *point)) return point;
        touch = first_contact_before(*point, corrector_, path_, WithContact::no);
        if (touch) {
            aim = Aim{.straight = aim.straight, .by_series = aim.by_series};
            aim.forecast = predict(aim.straight ? nullptr : &*path_.before, *path_.last, touch->point.q);
            return std::move(touch->point);
        }
        corrector_.restore(memory);
    }
    return corrector_.solve_at(frame, aim.constraint, aim.target, std::move(guess), WithContact::yes);
}

void PathFollower::commit(PathPoint point) {
    recorder_.append(path_, point);
    path_.before = std::move(path_.last);
    go_from(std::move(point));
}

void PathFollower::go_from(PathPoint point) {
    path_.last = std::move(point);
    path_.size = std::max(path_.size, linalg::norm(path_.last->state.x));
    system_.prescribe(path_.last->levels);
    let_contact_rest(system_, *path_.last, *path_.last);
    system_.accept_step(path_.last->state.x);
    recorder_.accept_step();
}

void PathFollower::add_first_contact(const Event& event) {
    const auto& contact = path_.end.first_contacts.emplace_back(
        model::FirstContact{location_of(event.point, path_, system_), event.obstacle, event.location_m});
    listeners_.report("first contact at " + describe(event.point) + ": " + model::contact_text(input_, contact));
}

void PathFollower::go_on_after_snap(Snap found, const std::string& how) {
    if (found.point.touches && !path_.last->touches) {
        Event contact = first_contact_at(std::move(found.point), corrector_, path_);
        add_first_contact(contact);
        found.point = std::move(contact.point);
    }
    const std::string lost = ", energy set free " + short_text(found.point.lost_J) + " J";
    go_on_from(std::move(found.point), found.goal, how, lost);
}

bool PathFollower::pass_events(Events events, const Goal* at_contact) {
    for (Event& event : events.list) {
        const model::LimitPoint location = location_of(event.point, path_, system_);
        if (event.kind == Event::Kind::limit_point) path_.end.limit_points.push_back(location);
        if (event.kind == Event::Kind::bifurcation) {
            path_.end.bifurcations.push_back({location, event.modes, {}});
            if (event.mode) {
                system_.prescribe(fem::no_loads(input_));
                path_.end.bifurcations.back().mode = system_.fields().gather_displacements(*event.mode);
            }
        }
        if (event.kind == Event::Kind::first_contact) add_first_contact(event);
        recorder_.append(path_, event.point);
        if (event.kind == Event::Kind::first_contact) {  // the path bends here: it is not predicted from before
            go_from(std::move(event.point));
            path_.before.reset();
            path_.step = round_step_size(step_after_contact * path_.step);
            if (at_contact != nullptr) end_stage(at_contact->text);
            return true;
        }
        if (event.kind == Event::Kind::bifurcation) {
            if (take_branch(event)) return true;
        } else if (!events.control_ends.empty()) {
            finish({StopReason::limit_point, events.control_ends + " at " + describe(event.point) +
                                                 ": this control cannot pass it; use path.control: auto to continue"});
            return true;
        }
    }
    return false;
}

/// Perturbs the state along the mode, with largest displacement `imperfection`, then re-equilibrates at this arc length: a point of
/// the branch, from which the path continues.
bool PathFollower::take_branch(Event& bifurcation) {
    if (input_.path.branch != model::Branch::follow || path_.on_branch || !bifurcation.mode) return false;
    const linalg::Vector& mode = *bifurcation.mode;
    const double imperfection_m = input_.path.imperfection_m, length = linalg::norm(mode);
    const Constraint arc{ConstraintKind::arc};
    PathPoint origin = std::move(bifurcation.point);
    origin.q = 0.0;
    origin.tangent = {linalg::duplicate(mode), 0.0, std::vector(origin.state.pressures_Pa.size(), 0.0), {}, 0.0};
    linalg::add(origin.tangent.x, 1.0 / length, mode);
    origin.level_slopes = fem::no_loads(input_);
    State guess = copy_of(origin.state);
    linalg::add(guess.x, imperfection_m, mode);
    Constraint perturbed = bind(arc, origin);
    perturbed.scale = imperfection_m * length;
    auto point = corrector_.solve_at({*path_.loads, arc, origin}, perturbed, perturbed.scale, std::move(guess));
    if (!point) {
        listeners_.report(
            "no branch is found at path.imperfection from the bifurcation: the path continues without it");
        return false;
    }
    listeners_.report("on the branch: " + describe(*point));
    path_.on_branch = true;
    path_.control = arc;
    path_.step = path_.first_step = perturbed.scale;
    recorder_.report_control(path_);
    go_from(std::move(origin));
    commit(std::move(*point));
    path_.before.reset();
    return true;
}

/// The recovery strategy: a shorter step (the line search has already acted inside each attempt), then another control, and finally
/// the end of the path with the location where smaller cells would help.
void PathFollower::recover() {
    const NewtonResult attempt = corrector_.last_result();
    const int failures = ++path_.attempts.failures;
    const double failed = std::exchange(path_.step, path_.step * cut_of_failed_step);
    report_row(path_.attempts.crossing
                   ? path_.attempts.crossing->text + ", and walls pass through each other: step cut to " +
                         short_text(path_.step)
                   : attempt_text(failed, path_.step, attempt));
    if (is_first_try(system_, path_, path_.step)) reduce_first_step(path_, path_.step);
    const double share = std::abs(path_.step / path_.first_step) / input_.solver.min_step;
    const bool too_short = share < 1.0;
    const bool may_be_kink = may_have_kinks(system_, *path_.last) && attempt.end != NewtonEnd::not_finite &&
                             (failures >= failures_before_kink || too_short);
    const bool may_snap = may_be_kink && path_.last->touches && (failures == failures_before_kink || too_short);
    if (path_.attempts.crossing && path_.attempts.crossing->is_driven && failures >= failures_before_driven)
        return finish(unresolved(*path_.attempts.crossing, describe(*path_.last)));
    const double first_attempt = failed / std::pow(cut_of_failed_step, failures - 1);
    if (auto found = may_snap ? snap(corrector_, path_, listeners_, first_attempt) : std::nullopt)
        return go_on_after_snap(std::move(*found), "contact snaps to ");
    // Walls that have passed through each other are no kink: the direction beyond it would lead back.
    if (auto point = may_be_kink && !path_.attempts.crossing ? pass_kink(corrector_, path_, failed) : std::nullopt;
        point && !breaks_energy_balance(corrector_, path_, *point) && !find_crossing(corrector_, listeners_, *point)) {
        const Goal* goal = nullptr;
        if (const auto crossing = first_between(path_.goals, *path_.last, *point)) {
            const double way = (crossing->q - path_.last->q) / (point->q - path_.last->q);
            goal = crossing->goal;
            State guess = between(path_.last->state, point->state, way);
            point = corrector_.solve_goal(frame_of(path_), *crossing, *path_.last, std::move(*point), std::move(guess));
        }
        if (point) return go_on_from(std::move(*point), goal, "passed a kink to ");
    }
    if (const auto change = control_after_failure(system_, path_, attempt.end, too_short))
        return change_control(*change);
    if (failures > 1) path_.before.reset();  // the cubic extrapolates badly: return to the tangent
    // A step below the accuracy of a state has no reliable direction: it may lead back.
    const double known = equilibrium_margin * input_.solver.residual_tolerance * linalg::norm(path_.last->state.x);
    if (!too_short || (share >= arc_of_one_cell && std::abs(path_.step) >= known && !is_nearly_inverted(attempt)))
        return;
    if (const auto& crossing = path_.attempts.crossing) return finish(unresolved(*crossing, describe(*path_.last)));
    listeners_.report("no step converges: use smaller cells (mesh.size)");
    finish(stop_without_step(path_, system_, attempt));
}

void PathFollower::go_on_from(PathPoint point, const Goal* goal, const std::string& how, const std::string& what) {
    if (auto stop = stop_before_row(path_, point, system_)) return finish(std::move(*stop));
    report_row(how + describe(point) + what);
    if (path_.control.kind == ConstraintKind::arc && path_.step < 0.0)
        rescale(system_, *path_.loads, *path_.last, -1.0);
    path_.step = point.q - path_.last->q;
    path_.attempts = {};
    commit(std::move(point));
    path_.before.reset();
    if (goal != nullptr) return end_stage(goal->text);
    if (auto stop = stop_at_row(path_, system_)) finish(std::move(*stop));
}

void PathFollower::begin(State state) {
    if (auto stop = begin_stage(corrector_, path_, std::move(state))) return finish(std::move(*stop));
    recorder_.report_control(path_);
}

void PathFollower::end_stage(const std::string& text) {
    if (static_cast<std::size_t>(path_.stage) + 1 == input_.path.stages.size())
        return finish({StopReason::done, text + " reached"});
    listeners_.report("stage " + stage_of(input_, path_).name + " ends: " + text + " reached at " +
                      describe(*path_.last));
    begin(next_stage(corrector_, path_));
    pass_hold();
}

void PathFollower::pass_hold() {
    if (path_.finished || path_.loads->changes()) return;
    path_.last->state.load_factor = 1.0;  // nothing changes: the same state again, without a direction
    path_.last->tangent.load_factor = 0.0;
    recorder_.append(path_, *path_.last);
    end_stage("end of a stage without load changes");
}

void PathFollower::change_control(const ControlChange& change) {
    listeners_.report(change.reason + ": following the path by " + std::string(name(change.control.kind)));
    if (stage_of(input_, path_).control != model::Control::automatic) path_.user_control = path_.control;
    if (change.control.kind == ConstraintKind::load_factor) path_.load_control_at = path_.rows;
    set_control(system_, path_, change.control);
    recorder_.report_control(path_);
}

void PathFollower::finish(Stop stop) {
    path_.end.reason = stop.reason;
    path_.end.detail = std::move(stop.detail);
    path_.finished = true;
}

model::PathEnd follow_path(fem::System& system, const Listeners& listeners, const model::Checkpoint* from,
                           Sensitivities* sensitivities) {
    check_case(system.input());
    return PathFollower(system, listeners, sensitivities).run(from);
}

}  // namespace soft::solver
