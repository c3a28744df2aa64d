#include "solver/path_follower.hpp"

#include <algorithm>
#include <cmath>


namespace soft::solver {

using solution::StopReason;

namespace {

/// A step whose predictor errs by more than this part of the step is taken again, shorter: the corrector may have
/// landed on another branch.
constexpr double predictor_error_limit = 0.5;
/// Of a smooth path the tangent's error falls with the step, which is cut to 0.4 between two attempts.
constexpr double error_at_a_kink = 0.8;
/// Step changes from one step to the next.
constexpr double largest_growth = 2.5, smallest_shrink = 0.3, cut_after_failure = 0.4;
/// Newton iterations beyond which the step does not grow.
constexpr int many_iterations = 7;
/// Failures in a row under pressure control before the path is followed by arc length instead.
constexpr int failures_before_arc = 3;

}  // namespace

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

void PathFollower::advance() {
    if (rows_ > settings_.step_limit)
        return finish(StopReason::step_limit, std::to_string(settings_.step_limit) + " steps were not enough");
    if (rows_ > wanted_steps()) return finish(StopReason::done, "number of steps reached");
    const PathPoint* before = before_ ? &*before_ : nullptr;
    const auto crossing = first_predicted(goals_, before, *last_, last_->q + step_);
    State guess = predict(before, *last_, crossing ? crossing->q : last_->q + step_);
    linalg::Vector predicted = linalg::duplicate(guess.x);
    linalg::copy(guess.x, predicted);
    Constraint constraint = crossing ? crossing->goal->constraint : bind(control_, *last_);
    double target = crossing ? crossing->goal->target : last_->q + step_;
    if (constraint.kind == ConstraintKind::arc)
        target = evaluate(constraint, system_, guess.x, guess.load_factor, scratch_);
    auto point = solve_at(constraint, target, std::move(guess));
    if (!point) return handle_failure();

    linalg::add(predicted, -1.0, point->state.x);
    const double error = linalg::norm(predicted);
    linalg::copy(point->state.x, predicted);
    linalg::add(predicted, -1.0, last_->state.x);
    const double relative_error = error / linalg::norm(predicted);
    const bool jumped = control_.kind == ConstraintKind::load_factor && point->tangent.excess_pivots &&
                        last_->tangent.excess_pivots && *point->tangent.excess_pivots != *last_->tangent.excess_pivots;
    // At a kink of the law (fibres that start to pull) the tangent is one-sided: the error does not fall with the step.
    const bool kink = !jumped && rejected_error_ && relative_error > error_at_a_kink * *rejected_error_;
    if ((relative_error > predictor_error_limit && !kink) || jumped) {
        rejected_error_ = relative_error;
        newton_result_.end = NewtonEnd::no_descent;
        return handle_failure();
    }
    failures_ = 0;
    rejected_error_.reset();
    if (log_)
        log_("row " + std::to_string(rows_) + ": " + describe(*point) + ", predictor error " +
             short_text(relative_error) + ", " + std::to_string(iterations_since_row_) + " iterations" +
             (point->tangent.excess_pivots ? ", excess pivots " + std::to_string(*point->tangent.excess_pivots) : ""));
    if (!crossing)
        if (const auto passed = first_between(goals_, *last_, *point)) {
            auto met = solve_at(passed->goal->constraint, passed->goal->target, predict(&*last_, *point, passed->q));
            if (!met) return handle_failure();
            locate_limit_point(*last_, *met);
            append(*met);
            return finish(StopReason::done, passed->goal->text + " reached");
        }
    locate_limit_point(*last_, *point);
    if (finished()) return;
    accept(std::move(*point));
    if (crossing) return finish(StopReason::done, crossing->goal->text + " reached");
    adapt_step(relative_error);
}

void PathFollower::accept(PathPoint point) {
    append(point);
    before_ = std::move(last_);
    last_ = std::move(point);
}

/// The predictor's error goes with the fourth power of the step (tangent: second), the step itself divides it out once.
void PathFollower::adapt_step(double predictor_error) {
    const bool cubic = before_ && before_->q != last_->q && rows_ > 2;
    const double order = cubic ? 3.0 : 1.0;
    double factor = std::pow(settings_.step_accuracy / std::max(predictor_error, 1e-12), 1.0 / order);
    factor = std::clamp(0.9 * factor, smallest_shrink, largest_growth);
    if (newton_result_.iterations > many_iterations) factor = std::min(factor, 0.7);
    step_ = coarse(factor * (last_->q - before_->q));
    if (settings_.largest_step > 0.0) {
        const double bound = settings_.largest_step * std::abs(last_->q);
        step_ = std::clamp(step_, -bound, bound);
    }
}

void PathFollower::handle_failure() {
    ++failures_;
    if (log_)
        log_("row " + std::to_string(rows_) + ": step of " + short_text(step_) + " failed, residual " +
             short_text(newton_result_.residual) + ", least det F " + short_text(newton_result_.min_jacobian));
    step_ *= cut_after_failure;
    const bool too_short = std::abs(step_) < settings_.smallest_step * std::abs(first_step_);
    if (control_.kind == ConstraintKind::load_factor && (failures_ >= failures_before_arc || too_short))
        return switch_to_arc_length();
    if (failures_ > 1) before_.reset();   // a bad extrapolation: go back to the tangent
    if (!too_short) return;
    if (newton_result_.end == NewtonEnd::inverted)
        return finish(StopReason::inverted_element,
                      "a cell turns inside out (det F = " + short_text(newton_result_.min_jacobian) + ") " +
                          place_text(newton_result_.worst_cell, input_) + "; use a finer mesh there");
    finish(StopReason::diverged, "no equilibrium found beyond " + describe(*last_));
}

void PathFollower::switch_to_arc_length() {
    const double load_step = step_;
    control_ = {ConstraintKind::arc};
    before_.reset();
    failures_ = 0;
    const double length = linalg::norm(last_->tangent.x);
    PathPoint origin = std::move(*last_);
    last_.reset();
    last_ = measure(std::move(origin.state), std::move(origin.tangent));
    first_step_ = step_ = coarse(std::abs(load_step) * length);
    if (log_) log_("pressure steps fail: following the path by arc length to see why");
}

}  // namespace soft::solver
