#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "model/cavity_surface.hpp"
#include "solver/path_follower.hpp"

namespace soft::solver {

using solution::StopReason;

namespace {

/// A step whose predictor errs by more than this part of the step is taken again, shorter: the corrector may have
/// landed on another branch.
constexpr double predictor_error_limit = 0.5;
/// A step along the tangent alone, whose error says as its square how far the curve between its rows may be off, is taken again
/// where that is more than so many times step_accuracy.
constexpr double coarse_curve = 2.0;
/// Below this the state is the path's next one.
constexpr double predictor_error_without_jump = 0.05;
/// Of a smooth path the tangent's error falls with the step, which is cut to 0.4 between two attempts.
constexpr double error_at_a_kink = 0.8;
/// The curve between two rows is the cubic through them: its load is held as well, to as many times the error.
constexpr double load_share = 0.45;
/// Near a limit point the load's error is measured by this part of the load, not by its change.
constexpr double flat_load = 0.1;
/// Times the tolerance of equilibrium, of the state or load: what a predictor differs from a state no better known than that
/// says nothing about the step.
constexpr double equilibrium_margin = 10.0;
/// Step changes from one step to the next.
constexpr double max_growth = 2.5, growth_of_linear_steps = 100.0, min_shrink = 0.3, min_retake = 0.1,
                 cut_after_failure = 0.4;
/// Newton iterations beyond which the step does not grow.
constexpr int many_iterations = 7;
/// Failures in a row before the path is followed by another control.
constexpr int failures_before_other_control = 3;
/// ... and before a body with fibres is taken to be at a corner of its path.
constexpr int failures_before_corner = 3;
/// The arc is that of the whole body: a fold in which but one cell snaps turns within so small a part of any other step.
constexpr double arc_of_one_cell = 1e-3;
/// In lengths of the body: a first step that moves its nodes by less, in the mean, is not cut any further for the load alone.
constexpr double motionless = 1e-7;
/// Times step_accuracy, of the state and load: an error of the predictor below this part of the whole does not shorten the steps,
/// which are so short that it may come from the tolerance of equilibrium where the body hardly resists a motion.
constexpr double negligible_error = 1e-3;
/// Of step_accuracy: what a negligible error counts for, so that the next step is a little longer.
constexpr double accepted_share = 0.5;
/// A part of a step that is rounding: far above that of sums, far below any step.
constexpr double sliver = 1e-6;

}  // namespace

/// The arc constraint of a step runs along the tangent of the state it starts from.
Constraint PathFollower::bind(const Constraint& constraint, const PathPoint& origin) const {
    Constraint bound = constraint;
    if (constraint.kind == ConstraintKind::arc) {
        bound.arc_origin = origin.state.x;
        bound.arc_direction = origin.tangent.x;
    }
    return bound;
}

std::optional<PathPoint> PathFollower::solve_at(const Constraint& constraint, double target, State guess) {
    newton_result_ = newton_.correct(constraint, target, guess);
    iterations_since_row_ += newton_result_.iterations;
    end_.newton_iterations += newton_result_.iterations;
    if (newton_result_.end != NewtonEnd::converged) return std::nullopt;
    auto tangent = newton_.tangent(bind(control_, *last_), guess);
    if (!tangent) {
        newton_result_.end = NewtonEnd::singular;
        return std::nullopt;
    }
    return measure(std::move(guess), std::move(*tangent));
}

/// The state at q between two points of the path.
std::optional<PathPoint> PathFollower::solve_between(const PathPoint& a, const PathPoint& b, double q) {
    State guess = predict(&a, b, q);
    Constraint constraint = bind(control_, a);
    constraint.scale = std::abs(b.q - a.q);
    const double target =
        constraint.kind == ConstraintKind::arc ? evaluate(constraint, system_, *loads_, guess, scratch_).value : q;
    auto point = solve_at(constraint, target, std::move(guess));
    if (point && control_.kind == ConstraintKind::arc) point->q = q;
    return point;
}

/// A constant step under the load factor ends on its multiples, also after one that had to be cut: rows at k x first_step.
double PathFollower::next_q() const {
    const double end = last_->q + step_;
    if (settings_.steps != model::StepRule::constant || control_.kind != ConstraintKind::load_factor) return end;
    const double on_grid = first_step_ * (std::floor(last_->q / first_step_ + sliver) + 1.0);
    const bool shortened = std::abs(step_) < std::abs(first_step_);
    return shortened && std::abs(end - last_->q) < (1.0 - sliver) * std::abs(on_grid - last_->q) ? end : on_grid;
}

/// Where the step is to end: by the cubic (or tangent) at the end of the step, or at the first goal it meets.
PathFollower::Aim PathFollower::aim() {
    const bool straight = !before_ || settings_.predictor == model::Predictor::tangent;
    const PathPoint* before = straight ? nullptr : &*before_;
    const double end = next_q();
    // Of a constant step, rounding must not leave a sliver before a goal that lies on its grid.
    const double reach = settings_.steps == model::StepRule::constant ? end + sliver * (end - last_->q) : end;
    Aim aim{.crossing = first_predicted(goals_, before, *last_, reach), .straight = straight};
    const double q = aim.crossing ? aim.crossing->q : end;
    aim.forecast = predict(before, *last_, q);
    aim.constraint = aim.crossing ? aim.crossing->goal->constraint : bind(control_, *last_);
    aim.target = aim.crossing ? aim.crossing->goal->target : end;
    if (!aim.crossing)
        aim.constraint.scale = std::abs(settings_.steps == model::StepRule::constant ? end - last_->q : step_);
    if (aim.constraint.kind == ConstraintKind::load_factor) aim.forecast.load_factor = aim.target;  // to the last digit
    if (aim.constraint.kind == ConstraintKind::arc)
        aim.target = evaluate(aim.constraint, system_, *loads_, aim.forecast, scratch_).value;
    return aim;
}

/// What Newton's method starts from.
State PathFollower::start_of(const Aim& aim) const {
    const State& from = settings_.predictor == model::Predictor::none ? last_->state : aim.forecast;
    State start{linalg::duplicate(from.x), from.load_factor, from.pressures_Pa};
    linalg::copy(from.x, start.x);
    return start;
}

PathFollower::PredictorError PathFollower::error_of(const Aim& aim, const PathPoint& point) const {
    linalg::Vector change = linalg::duplicate(point.state.x);
    linalg::copy(aim.forecast.x, change);
    linalg::add(change, -1.0, point.state.x);
    const double error = linalg::norm(change);
    const double unknown = equilibrium_margin * settings_.residual_tolerance;
    linalg::copy(point.state.x, change);
    linalg::add(change, -1.0, last_->state.x);
    const double step = linalg::norm(change), load_error = std::abs(leading_of(aim.forecast) - point.leading);
    const double load_step = std::max(std::abs(point.leading - last_->leading), flat_load * std::abs(point.leading));
    const double size = linalg::norm(point.state.x), negligible = negligible_error * settings_.step_accuracy;
    return {error > unknown * size ? error / step : 0.0,
            load_error > unknown * std::abs(point.leading) ? load_error / load_step : 0.0,
            error <= negligible * size && load_error <= negligible * std::abs(point.leading)};
}

/// Another inertia is another branch, unless the predictor says that the path has just passed a bifurcation. And steps that
/// are chosen by the predictor's error are taken again where it is large.
bool PathFollower::is_refused(const PredictorError& error, const PathPoint& point) const {
    const bool jumped = control_.kind == ConstraintKind::load_factor && error.state > predictor_error_without_jump &&
                        point.tangent.unstable_modes && last_->tangent.unstable_modes &&
                        *point.tangent.unstable_modes != *last_->tangent.unstable_modes;
    if (jumped) return true;
    if (system_.has_fibers() && control_.kind == ConstraintKind::arc && failures_ < failures_before_corner) {
        const auto before = branch_index(*last_), here = branch_index(point);
        if (before && here && (*before - *here) % 2 != 0) return true;
    }
    if (settings_.steps != model::StepRule::error_adaptive) return false;
    // At a kink of the law (fibres that start to pull) the tangent is one-sided: the error does not fall with the step.
    const bool kink = rejected_error_ && error.state > error_at_a_kink * *rejected_error_;
    return error.state > predictor_error_limit && !kink;
}

/// The first step's length comes from the loads, which may lie far beyond what the path is followed to: its rows would be exact
/// and the curve between them read off far from the path. Not where the error does not fall with the step, at a kink.
bool PathFollower::is_too_long(const Aim& aimed, double missed, double taken) {
    const bool squared = aimed.straight && settings_.predictor != model::Predictor::tangent;
    if (settings_.steps != model::StepRule::error_adaptive || !squared) return false;
    const double error = missed * missed;
    const bool kink = rejected_curve_error_ && error > error_at_a_kink * *rejected_curve_error_;
    const double shorter = std::max(0.9 * std::sqrt(settings_.step_accuracy / error), min_retake);
    if (error <= coarse_curve * settings_.step_accuracy || kink) return false;
    if (is_first_try(shorter * taken))
        first_step_ = coarse(shorter * taken);
    else if (std::abs(shorter * taken / first_step_) < settings_.min_step)
        return false;
    log("row " + std::to_string(rows_) + ": step of " + short_text(taken) +
        " is too long for the curve (predictor error " + short_text(missed) + "): taken again");
    rejected_curve_error_ = error;
    step_ = coarse(shorter * taken);
    return true;
}

void PathFollower::advance() {
    if (rows_ > settings_.step_limit)
        return finish(StopReason::step_limit, core::counted(settings_.step_limit, "step") +
                                                  (settings_.step_limit == 1 ? " was" : " were") +
                                                  " not enough; a larger solver.step_limit goes on");
    if (is_stalled()) {
        const std::string where = ": the last " + std::to_string(stalled_rows) +
                                  " steps are less than a hundredth of the path, at " + describe(*last_);
        return is_past_a_maximum()
                   ? finish(StopReason::limit_point,
                            "the load asked for is not reached: its maximum lies behind, and the path stalls" + where)
                   : finish(StopReason::diverged, "the path stalls" + where + "; another mesh.size may go on");
    }
    if (rows_ > wanted_steps()) return end_stage("number of steps");
    const Aim aimed = aim();
    auto point = solve_at(aimed.constraint, aimed.target, start_of(aimed));
    if (!point) return handle_failure();
    const PredictorError error = error_of(aimed, *point);
    if (is_refused(error, *point)) {
        rejected_error_ = error.state;
        return handle_failure();
    }
    double missed = std::max(error.state, load_share * error.load);
    if (is_too_long(aimed, missed, point->q - last_->q)) return;
    if (error.is_negligible) missed = std::min(missed, accepted_share * settings_.step_accuracy);
    failures_ = 0;
    rejected_error_.reset();
    rejected_curve_error_.reset();
    log("row " + std::to_string(rows_) + ": " + describe(*point) + ", predictor error " + short_text(error.state) +
        " (load " + short_text(error.load) + "), " + core::counted(newton_result_.iterations, "iteration") +
        (point->tangent.unstable_modes ? ", unstable modes " + std::to_string(*point->tangent.unstable_modes) : ""));
    if (!arrive(std::move(*point), aimed.crossing ? aimed.crossing->goal : nullptr)) return;
    if (!aimed.straight)
        adapt_step(missed, 3.0);
    else if (settings_.predictor == model::Predictor::tangent)
        adapt_step(missed, 1.0);
    else
        adapt_step(missed * missed,
                   3.0);  // the cubic comes next: of a series whose terms go on falling so it errs by 4 missed^3
    soften();
}

/// The rest of a step that Newton's method has found: contact, goals passed by, events, the row. True where the path goes on
/// from there in the same stage.
bool PathFollower::arrive(PathPoint point, const Goal* goal) {
    const auto contact = find_contact(point);
    std::string reached = goal != nullptr && !contact ? goal->text : "";
    if (const auto passed = goal != nullptr && !contact ? std::nullopt : first_between(goals_, *last_, point)) {
        auto met = solve_at(passed->goal->constraint, passed->goal->target, predict(&*last_, point, passed->q));
        if (!met) {
            handle_failure();
            return false;
        }
        point = std::move(*met);
        reached = passed->goal->text;
    }
    if (pass_events(*last_, point)) return false;
    accept(std::move(point));
    if (!reached.empty())
        end_stage(reached);
    else if (contact)
        finish(contact->reason, contact->end_at(describe(*last_)));
    else if (std::string returned = return_text(); !returned.empty())
        finish(StopReason::limit_point, std::move(returned));
    else if (is_out_of_reach())
        finish(StopReason::limit_point, "the load asked for is never reached: it tends to little more than at " +
                                            describe(*last_) +
                                            ", and the rubber is stretched by more than path.stretch_limit");
    else if (is_goal_unreachable())
        finish(StopReason::limit_point,
               "the load asked for is never reached: its maximum lies behind, and the rubber is stretched by more than "
               "path.stretch_limit at " +
                   describe(*last_));
    else
        return true;
    return false;
}

void PathFollower::accept(PathPoint point) {
    append(point);
    before_ = std::move(last_);
    last_ = std::move(point);
}

void PathFollower::adapt_step(double predictor_error, double order) {
    const double taken = last_->q - before_->q;
    switch (settings_.steps) {
        case model::StepRule::constant:  // grows back where it had to be cut
            step_ = std::abs(2.0 * step_) < std::abs(first_step_) ? 2.0 * step_ : first_step_;
            return;
        case model::StepRule::iteration_adaptive: {  // Ramm 1981; Crisfield 1991 9.5.1
            const double iterations = std::max(newton_result_.iterations, 1);
            step_ = coarse(std::clamp(std::sqrt(settings_.wanted_iterations / iterations), 0.5, 2.0) * taken);
            break;
        }
        case model::StepRule::error_adaptive: {  // the error goes with the power order + 1 of the step
            double factor = std::pow(settings_.step_accuracy / std::max(predictor_error, 1e-12), 1.0 / order);
            const bool is_linear = newton_result_.iterations == 0 && newton_result_.within_rounding;
            factor = std::clamp(0.9 * factor, min_shrink, is_linear ? growth_of_linear_steps : max_growth);
            if (newton_result_.iterations > many_iterations) factor = std::min(factor, 0.7);
            step_ = coarse(factor * taken);
        }
    }
    if (settings_.max_step > 0.0) {
        const double bound = settings_.max_step * std::abs(last_->q);
        step_ = std::clamp(step_, -bound, bound);
    }
}

/// The first step comes from the load asked for, which may be beyond all that the body takes: it is cut as far as it still moves
/// the body, by the root mean square of the unknowns.
bool PathFollower::is_first_try(double step) const {
    if (!begins_at_rest() || settings_.steps == model::StepRule::constant) return false;
    const double unknowns = static_cast<double>(system_.dofs().total);
    const double moves = std::abs(step) * linalg::norm(last_->tangent.x) / std::sqrt(unknowns);
    return moves > motionless * model::extent_m(input_.mesh);
}

/// The ladder: a shorter step (the line search has had its turn inside each attempt), another control, and at last the
/// reason with the place where smaller cells would help.
void PathFollower::handle_failure() {
    ++failures_;
    const double next = step_ * cut_after_failure;
    log("row " + std::to_string(rows_) + ": step of " + short_text(step_) + " failed (" +
        std::string(text_of(newton_result_.end)) + ", " + core::counted(newton_result_.iterations, "iteration") + ", " +
        core::counted(newton_result_.halvings, "halving") + " of the line search, residual " +
        short_text(newton_result_.residual) + ", least det F " + short_text(newton_result_.min_jacobian) +
        "): cut to " + short_text(next));
    const double failed = step_;
    step_ = next;
    if (is_first_try(step_)) first_step_ = step_;
    const double share = std::abs(step_ / first_step_) / settings_.min_step;
    const bool too_short = share < 1.0;
    const bool may_be_corner = system_.has_fibers() && newton_result_.end != NewtonEnd::not_finite &&
                               (failures_ >= failures_before_corner || too_short);
    if (may_be_corner && pass_kink(failed)) return;
    const bool automatic = stage().control == model::Control::automatic;
    if (control_.kind != ConstraintKind::arc && (too_short || failures_ >= failures_before_other_control ||
                                                 (automatic && control_.kind == ConstraintKind::load_factor))) {
        if (automatic && control_.kind == ConstraintKind::load_factor)
            return change_control(softer_control(), "a step under the load factor fails");
        if (!automatic) chosen_ = control_;
        return change_control({ConstraintKind::arc}, "steps under the " + std::string(name(control_.kind)) + " fail");
    }
    if (failures_ > 1) before_.reset();  // a bad extrapolation: go back to the tangent
    // A step of no more than a state is known to has no direction: it may as well lead back.
    const double known = equilibrium_margin * settings_.residual_tolerance * linalg::norm(last_->state.x);
    const bool lost = share < arc_of_one_cell || std::abs(step_) < known || is_crushed();
    if (too_short && lost) give_up();
}

}  // namespace soft::solver
