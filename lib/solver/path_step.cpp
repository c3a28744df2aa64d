#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "model/cavity_surface.hpp"
#include "solver/path_follower.hpp"

namespace soft::solver {

using model::StopReason;

namespace {

/// A step whose predictor error exceeds this fraction of the step is repeated, shorter: the corrector may have
/// converged to another branch.
constexpr double predictor_error_limit = 0.5;
/// A step along the tangent alone is repeated where the square of its error, an estimate of the error of the curve between its
/// rows, exceeds this multiple of step_accuracy.
constexpr double coarse_curve = 2.0;
/// Below this predictor error the state belongs to the same branch.
constexpr double predictor_error_without_jump = 0.05;
/// On a smooth path the tangent's error falls with the step, which is cut to 0.4 between two attempts.
constexpr double error_at_a_kink = 0.8;
/// The curve between two rows is the cubic through them: its load error is controlled as well, with this weight.
constexpr double load_share = 0.45;
/// Near a limit point the load's error is relative to this fraction of the load, not to its change.
constexpr double flat_load = 0.1;
/// With fibres the error of the state is relative to at least this fraction of the state: each point whose fibres go taut or slack
/// puts a kink into the path, beside which the error relative to a shorter step does not decrease.
constexpr double min_kinked_step = 0.1;
/// Times the tolerance of equilibrium, relative to the state or load: a predictor error below the accuracy of the state itself
/// gives no information about the step.
constexpr double equilibrium_margin = 10.0;
/// Bounds of the step-size factor from one step to the next.
constexpr double max_growth = 2.5, growth_of_linear_steps = 100.0, min_shrink = 0.3, min_retake = 0.1,
                 cut_after_failure = 0.4;
/// Newton iterations beyond which the step does not grow.
constexpr int many_iterations = 7;
/// Consecutive failures before the path is followed by another control.
constexpr int failures_before_other_control = 3;
/// Consecutive failures before a body with fibres is assumed to be at a kink of its path.
constexpr int failures_before_kink = 3;
/// Factor on min_step under arc-length control. The arc length is that of the whole body: a fold in which only one cell snaps through
/// turns within a very small fraction of any other step.
constexpr double arc_of_one_cell = 1e-3;
/// Relative to the size of the body: a first step that moves its nodes by less, in the root mean square, is not cut further because
/// of the load.
constexpr double motionless = 1e-7;
/// Times step_accuracy, relative to the state and load: a smaller predictor error does not shorten the steps. Steps with such
/// errors are so short that the error may come from the tolerance of equilibrium where the body hardly resists a motion.
constexpr double negligible_error = 1e-3;
/// Value of a negligible error in units of step_accuracy, so that the next step is slightly longer.
constexpr double accepted_share = 0.5;
/// A fraction of a step that counts as rounding: far above the rounding of sums, far below any step.
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

/// A constant step under load-factor control ends on its multiples, also after a step that was cut: rows at k x first_step.
double PathFollower::next_q() const {
    const double end = last_->q + step_;
    if (settings_.steps != model::StepRule::constant || control_.kind != ConstraintKind::load_factor) return end;
    const double on_grid = first_step_ * (std::floor(last_->q / first_step_ + sliver) + 1.0);
    const bool shortened = std::abs(step_) < std::abs(first_step_);
    return shortened && std::abs(end - last_->q) < (1.0 - sliver) * std::abs(on_grid - last_->q) ? end : on_grid;
}

/// The target of the step: its end by the cubic (or tangent), or the first goal it reaches.
PathFollower::Aim PathFollower::aim() {
    const bool straight = !before_ || settings_.predictor == model::Predictor::tangent;
    const PathPoint* before = straight ? nullptr : &*before_;
    const double end = next_q();
    // With constant steps, rounding must not leave a tiny step before a goal that lies on the grid.
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

/// The initial guess of Newton's method.
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
    const double size = linalg::norm(point.state.x), negligible = negligible_error * settings_.step_accuracy;
    const double step = std::max(linalg::norm(change), system_.has_fibers() ? min_kinked_step * size : 0.0);
    const double load_error = std::abs(leading_of(aim.forecast) - point.leading);
    const double load_step = std::max(std::abs(point.leading - last_->leading), flat_load * std::abs(point.leading));
    return {error > unknown * size ? error / step : 0.0,
            load_error > unknown * std::abs(point.leading) ? load_error / load_step : 0.0,
            error <= negligible * size && load_error <= negligible * std::abs(point.leading)};
}

/// A changed inertia means another branch, unless the predictor shows that the path has just passed a bifurcation. Steps that
/// are chosen by the predictor's error are also repeated where it is large.
bool PathFollower::is_refused(const PredictorError& error, const PathPoint& point) const {
    const bool jumped = control_.kind == ConstraintKind::load_factor && error.state > predictor_error_without_jump &&
                        point.tangent.unstable_modes && last_->tangent.unstable_modes &&
                        *point.tangent.unstable_modes != *last_->tangent.unstable_modes;
    if (jumped) return true;
    if (system_.has_fibers() && control_.kind == ConstraintKind::arc && failures_ < failures_before_kink) {
        const auto before = branch_index(*last_), here = branch_index(point);
        if (before && here && (*before - *here) % 2 != 0) return true;
    }
    if (settings_.steps != model::StepRule::error_adaptive) return false;
    // At a kink of the law (fibres that become taut) the tangent is one-sided: the error does not fall with the step.
    const bool kink = rejected_error_ && error.state > error_at_a_kink * *rejected_error_;
    return error.state > predictor_error_limit && !kink;
}

/// The first step's length comes from the loads, which may lie far beyond the end of the path: its rows would be exact, but
/// the curve between them would be far from the path. Not applied where the error does not fall with the step, at a kink.
bool PathFollower::is_too_long(const Aim& aimed, double missed, double taken) {
    const bool squared = aimed.straight && settings_.predictor != model::Predictor::tangent;
    if (settings_.steps != model::StepRule::error_adaptive || !squared) return false;
    const double error = missed * missed;
    const bool kink = rejected_curve_error_ && error > error_at_a_kink * *rejected_curve_error_;
    const double shorter = std::max(0.9 * std::sqrt(settings_.step_accuracy / error), min_retake);
    if (error <= coarse_curve * settings_.step_accuracy || kink) return false;
    if (is_first_try(shorter * taken))
        first_step_ = round_step_size(shorter * taken);
    else if (std::abs(shorter * taken / first_step_) < settings_.min_step)
        return false;
    log("row " + std::to_string(rows_) + ": step of " + short_text(taken) +
        " is too long for the curve (predictor error " + short_text(missed) + "): repeated with a shorter step");
    rejected_curve_error_ = error;
    step_ = round_step_size(shorter * taken);
    return true;
}

void PathFollower::advance() {
    if (rows_ > settings_.step_limit)
        return finish(StopReason::step_limit, core::counted(settings_.step_limit, "step") +
                                                  (settings_.step_limit == 1 ? " was" : " were") +
                                                  " not enough; increase solver.step_limit");
    if (is_stalled()) {
        const std::string where = ": the last " + std::to_string(stalled_rows) +
                                  " steps cover less than 1 % of its length, at " + describe(*last_);
        return is_past_limit_point()
                   ? finish(StopReason::limit_point,
                            "the requested load is not reached: the path is past the limit point and stalls" + where)
                   : finish(StopReason::diverged, "the path stalls" + where + "; try another mesh.size");
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
    if (system_.has_fibers() && failures_ < failures_before_kink && breaks_energy_balance(*last_, *point))
        return handle_failure();
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
                   3.0);  // the next predictor is the cubic: for a series with decreasing terms its error is 4 missed^3
    leave_load_control();
}

/// Completes a step that Newton's method has solved: contact, goals passed, events, the row. True where the path continues
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
        finish(StopReason::limit_point, "the requested load is never reached: the load tends to little more than at " +
                                            describe(*last_) + ", and the stretch exceeds path.stretch_limit");
    else if (is_goal_unreachable())
        finish(StopReason::limit_point,
               "the requested load is never reached: the path is past the limit point, and the stretch exceeds "
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
        case model::StepRule::constant:  // grows back after a cut
            step_ = std::abs(2.0 * step_) < std::abs(first_step_) ? 2.0 * step_ : first_step_;
            return;
        case model::StepRule::iteration_adaptive: {  // Ramm 1981; Crisfield 1991 9.5.1
            const double iterations = std::max(newton_result_.iterations, 1);
            step_ = round_step_size(std::clamp(std::sqrt(settings_.wanted_iterations / iterations), 0.5, 2.0) * taken);
            break;
        }
        case model::StepRule::error_adaptive: {  // the error is proportional to the power order + 1 of the step
            double factor = std::pow(settings_.step_accuracy / std::max(predictor_error, 1e-12), 1.0 / order);
            const bool is_linear = newton_result_.iterations == 0 && newton_result_.within_rounding;
            factor = std::clamp(0.9 * factor, min_shrink, is_linear ? growth_of_linear_steps : max_growth);
            if (newton_result_.iterations > many_iterations) factor = std::min(factor, 0.7);
            step_ = round_step_size(factor * taken);
        }
    }
    if (settings_.max_step > 0.0) {
        const double bound = settings_.max_step * std::abs(last_->q);
        step_ = std::clamp(step_, -bound, bound);
    }
}

/// The first step comes from the requested load, which may exceed what the body can carry: it is cut as long as it still moves
/// the body, by the root mean square of the unknowns.
bool PathFollower::is_first_try(double step) const {
    if (!begins_at_rest() || settings_.steps == model::StepRule::constant) return false;
    const double unknowns = static_cast<double>(system_.dofs().total);
    const double moves = std::abs(step) * linalg::norm(last_->tangent.x) / std::sqrt(unknowns);
    return moves > motionless * model::extent_m(input_.mesh);
}

/// The recovery strategy: a shorter step (the line search has already acted inside each attempt), then another control, and finally
/// the end of the path with the location where smaller cells would help.
void PathFollower::handle_failure() {
    ++failures_;
    const double next = step_ * cut_after_failure;
    log("row " + std::to_string(rows_) + ": step of " + short_text(step_) + " failed (" +
        std::string(text_of(newton_result_.end)) + ", " + core::counted(newton_result_.iterations, "iteration") + ", " +
        core::counted(newton_result_.halvings, "halving") + " of the line search, residual " +
        short_text(newton_result_.residual) + ", min det F " + short_text(newton_result_.min_jacobian) + "): cut to " +
        short_text(next));
    const double failed = step_;
    step_ = next;
    if (is_first_try(step_)) first_step_ = step_;
    const double share = std::abs(step_ / first_step_) / settings_.min_step;
    const bool too_short = share < 1.0;
    const bool may_be_kink = system_.has_fibers() && newton_result_.end != NewtonEnd::not_finite &&
                             (failures_ >= failures_before_kink || too_short);
    if (may_be_kink && pass_kink(failed)) return;
    const bool automatic = stage().control == model::Control::automatic;
    if (control_.kind != ConstraintKind::arc && (too_short || failures_ >= failures_before_other_control ||
                                                 (automatic && control_.kind == ConstraintKind::load_factor))) {
        if (automatic && control_.kind == ConstraintKind::load_factor)
            return change_control(softer_control(), "a step under the load factor fails");
        if (!automatic) chosen_ = control_;
        return change_control({ConstraintKind::arc}, "steps under the " + std::string(name(control_.kind)) + " fail");
    }
    if (failures_ > 1) before_.reset();  // the cubic extrapolates badly: return to the tangent
    // A step below the accuracy of a state has no reliable direction: it may lead back.
    const double known = equilibrium_margin * settings_.residual_tolerance * linalg::norm(last_->state.x);
    const bool lost = share < arc_of_one_cell || std::abs(step_) < known || is_nearly_inverted();
    if (too_short && lost) abandon_path();
}

}  // namespace soft::solver
