#include "solver/path.hpp"

#include <algorithm>
#include <cmath>

#include "assembly/rigid_motion.hpp"
#include "core/error.hpp"
#include "solver/goals.hpp"
#include "solver/history.hpp"
#include "solver/path_text.hpp"

namespace soft::solver {

namespace {

using solution::PathEnd;
using solution::StopReason;

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
/// A limit point is located until its load is known to this relative accuracy (estimated from the slope's parabola).
constexpr double limit_point_tolerance = 1e-8;
constexpr int limit_point_solves = 12;

Constraint control_constraint(const model::Case& input, bool has_volume) {
    switch (input.path.control) {
        case model::Control::pressure: return {ConstraintKind::load_factor};
        case model::Control::volume:
            if (!has_volume)
                throw Error(ExitCode::bad_input, "path.control", "volume control needs a loaded cavity",
                            "use pressure, displacement or arc-length");
            return {ConstraintKind::volume};
        case model::Control::displacement:
            if (input.outputs.empty())
                throw Error(ExitCode::bad_input, "path.control", "displacement control needs an output",
                            "name one under outputs");
            return {ConstraintKind::output};
        case model::Control::arc_length: return {ConstraintKind::arc};
    }
    return {};
}

class PathFollower {
public:
    PathFollower(assembly::System& system, const StepSink& sink, const Log& log)
        : system_(system), input_(system.input()), settings_(input_.solver), newton_(system, settings_), sink_(sink),
          log_(log), scratch_(system.make_vector()) {}

    PathEnd run();

private:
    void start();
    [[nodiscard]] bool finished() const { return finished_; }
    void advance();
    [[nodiscard]] std::optional<PathPoint> solve_at(const Constraint& constraint, double target, State guess);
    [[nodiscard]] PathPoint measure(State state, PathTangent tangent);
    [[nodiscard]] Constraint bind(const Constraint& constraint, const PathPoint& origin) const;
    void locate_limit_point(const PathPoint& from, const PathPoint& to);
    void accept(PathPoint point);
    void handle_failure();
    void adapt_step(double predictor_error);
    void append(const PathPoint& point);
    void finish(StopReason reason, std::string detail);
    void switch_to_arc_length();
    [[nodiscard]] bool is_stable(const PathPoint& point) const;
    [[nodiscard]] std::string describe(const PathPoint& point) const { return state_text(point, input_); }
    [[nodiscard]] int wanted_steps() const;

    assembly::System& system_;
    const model::Case& input_;
    model::SolverSettings settings_;
    Newton newton_;
    const StepSink& sink_;
    const Log& log_;
    linalg::Vector scratch_;

    Constraint control_;
    bool stop_at_limit_point_ = false;
    std::vector<Goal> goals_;
    std::optional<PathPoint> before_, last_;
    double step_ = 0, first_step_ = 0;          // of q, signed
    int failures_ = 0;                          // in a row
    std::optional<double> rejected_error_;      // of the predictor, at the last attempt from here
    NewtonResult newton_result_;
    int iterations_since_row_ = 0, factorizations_at_row_ = 0;
    int rows_ = 0;
    bool finished_ = false;
    PathEnd end_;
};

/// Steps of few digits, so that rounding, which differs with the number of ranks, does not move the rows of the path.
double coarse(double step) {
    int exponent = 0;
    const double mantissa = std::frexp(step, &exponent);
    constexpr double divisions = 256;
    return std::ldexp(std::round(mantissa * divisions) / divisions, exponent);
}

PathEnd PathFollower::run() {
    start();
    while (!finished()) advance();
    end_.factorizations = newton_.factorizations();
    return std::move(end_);
}

void PathFollower::start() {
    if (const auto motion = assembly::free_rigid_motion(input_))
        throw Error(ExitCode::bad_input, "supports", "nothing holds the body against a rigid " + *motion,
                    "hold a face in that direction");
    State state{system_.make_vector(), 0.0};
    const auto volume = system_.enclosed_volume(state.x, nullptr);
    control_ = control_constraint(input_, volume.has_value());
    stop_at_limit_point_ = control_.kind == ConstraintKind::load_factor;
    goals_ = make_goals(input_, volume);
    if (system_.starts_under_stress()) {   // row 0 is the body free of load, not the undeformed one
        newton_result_ = newton_.correct({ConstraintKind::load_factor}, 0.0, state);
        if (newton_result_.end != NewtonEnd::converged)
            throw Error(ExitCode::bad_input, "materials", "no equilibrium without load under the law's initial stress",
                        "check the moduli of the materials");
    }
    auto tangent = newton_.tangent({ConstraintKind::load_factor}, state);
    if (!tangent || !std::isfinite(linalg::norm(tangent->x)))
        throw Error(ExitCode::bad_input, "materials", "the undeformed body has a singular stiffness",
                    "check the moduli of the materials");
    // The linear response gives the first step: first_step of the full load.
    last_ = measure(std::move(state), std::move(*tangent));
    if (control_.kind != ConstraintKind::load_factor) {
        auto along_control = newton_.tangent(bind(control_, *last_), last_->state);
        if (!along_control) throw Error(ExitCode::bad_input, "path.control", "the load does not move the controlled quantity");
        State undeformed = std::move(last_->state);
        last_.reset();
        last_ = measure(std::move(undeformed), std::move(*along_control));
    }
    first_step_ = step_ = coarse(settings_.first_step / last_->tangent.load_factor);
    append(*last_);
}

/// The arc constraint of a step runs along the tangent of the state it starts from.
Constraint PathFollower::bind(const Constraint& constraint, const PathPoint& origin) const {
    Constraint bound = constraint;
    if (constraint.kind == ConstraintKind::arc) {
        bound.arc_origin = origin.state.x;
        bound.arc_direction = origin.tangent.x;
    }
    return bound;
}

PathPoint PathFollower::measure(State state, PathTangent tangent) {
    PathPoint point{std::move(state), std::move(tangent), 0, std::nullopt, {}, 0, {}};
    if (control_.kind == ConstraintKind::arc) {
        const double length = linalg::norm(point.tangent.x);
        // Travel on in the direction of the step before; at the start in the direction of growing load.
        const bool forward = last_ && last_->q > 0.0 ? linalg::dot(point.tangent.x, last_->tangent.x) > 0.0
                                                     : point.tangent.load_factor > 0.0;
        const double scale = (forward ? 1.0 : -1.0) / length;
        SOFT_PETSC(VecScale(point.tangent.x, scale));
        point.tangent.load_factor *= scale;
    }
    point.volume_m3 = system_.enclosed_volume(point.state.x, scratch_);
    point.volume_slope = linalg::dot(scratch_, point.tangent.x);
    for (std::size_t i = 0; i < system_.output_count(); ++i) {
        point.outputs_m.push_back(linalg::dot(system_.output_weights(i), point.state.x));
        point.output_slopes.push_back(linalg::dot(system_.output_weights(i), point.tangent.x));
    }
    switch (control_.kind) {
        case ConstraintKind::load_factor: point.q = point.state.load_factor; break;
        case ConstraintKind::volume: point.q = *point.volume_m3; break;
        case ConstraintKind::output: point.q = point.outputs_m[control_.output]; break;
        case ConstraintKind::arc:
            if (last_) {
                linalg::copy(point.state.x, scratch_);
                linalg::add(scratch_, -1.0, last_->state.x);
                point.q = last_->q + linalg::norm(scratch_);
            }
            break;
    }
    return point;
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

void PathFollower::locate_limit_point(const PathPoint& from, const PathPoint& to) {
    if (control_.kind == ConstraintKind::load_factor || from.tangent.load_factor * to.tangent.load_factor >= 0.0)
        return;
    std::optional<PathPoint> left, right;
    for (int solve = 0; solve < limit_point_solves; ++solve) {
        const PathPoint& a = left ? *left : from;
        const PathPoint& b = right ? *right : to;
        // Zero of the slope by the secant through both ends; bisection where that would hug an end.
        const double span = b.q - a.q;
        double share = a.tangent.load_factor / (a.tangent.load_factor - b.tangent.load_factor);
        share = std::clamp(share, 0.02, 0.98);
        const double q = a.q + share * span;
        State guess = predict(&a, b, q);
        const Constraint constraint = bind(control_, a);
        const double target = constraint.kind == ConstraintKind::arc
                                  ? evaluate(constraint, system_, guess.x, guess.load_factor, scratch_)
                                  : q;
        auto point = solve_at(constraint, target, std::move(guess));
        if (!point) return;   // the path goes on without the located point; the sign change stays in the rows
        if (control_.kind == ConstraintKind::arc) point->q = q;
        const double curvature = (b.tangent.load_factor - a.tangent.load_factor) / span;
        const double slope = point->tangent.load_factor;
        const bool located = slope * slope <=
                             2.0 * limit_point_tolerance * std::abs(curvature * point->state.load_factor);
        if (located || solve + 1 == limit_point_solves) {
            end_.limit_points.push_back({rows_, point->state.load_factor * model::leading_load(input_).value_Pa,
                                         point->volume_m3, point->outputs_m});
            append(*point);
            if (stop_at_limit_point_)
                finish(StopReason::limit_point,
                       "the pressure has a maximum at " + describe(*point) +
                           ": no equilibrium beyond under pressure control; path.control: volume goes on");
            return;
        }
        (slope * from.tangent.load_factor > 0.0 ? left : right) = std::move(point);
    }
}

/// Under a controlled quantity the tangent may have one more negative pivot than at fixed load, exactly where the load
/// falls: the bordered matrix is then still definite on the constraint.
bool PathFollower::is_stable(const PathPoint& point) const {
    const bool load_rises = point.tangent.load_factor * step_ >= 0.0;
    if (!point.tangent.excess_pivots) return !stop_at_limit_point_ || load_rises;
    const int excess = *point.tangent.excess_pivots;
    if (stop_at_limit_point_) return excess == 0;
    return excess == (load_rises ? 0 : 1);
}

void PathFollower::append(const PathPoint& point) {
    solution::Step step;
    const double pressure_Pa = model::leading_load(input_).value_Pa;
    step.load_factor = point.state.load_factor;
    step.pressure_Pa = step.load_factor * pressure_Pa;
    step.volume_m3 = point.volume_m3;
    step.outputs_m = point.outputs_m;
    const double direction = step_ < 0.0 ? -1.0 : 1.0;   // tangents point in the direction of travel
    step.tangent_load_factor = direction * point.tangent.load_factor;
    step.tangent_pressure = step.tangent_load_factor * pressure_Pa;
    step.tangent_volume = direction * point.volume_slope;
    for (const double slope : point.output_slopes) step.tangent_outputs.push_back(direction * slope);
    step.newton_iterations = iterations_since_row_;
    step.factorizations = newton_.factorizations() - factorizations_at_row_;
    step.stable = is_stable(point);
    const auto stretch = system_.stretches(point.state.x);
    step.stretch_p99 = stretch.p99;
    step.max_stretch = stretch.largest;
    step.min_jacobian = stretch.min_jacobian;
    iterations_since_row_ = 0;
    factorizations_at_row_ = newton_.factorizations();
    ++rows_;
    sink_(step, point.state.x);
}

void PathFollower::finish(StopReason reason, std::string detail) {
    end_.reason = reason;
    end_.detail = std::move(detail);
    finished_ = true;
}

int PathFollower::wanted_steps() const {
    for (const auto& until : input_.path.until)
        if (until.quantity == "steps") return static_cast<int>(until.value);
    return settings_.step_limit;
}

}  // namespace

PathEnd follow_path(assembly::System& system, const StepSink& sink, const Log& log) {
    if (model::leading_load(system.input()).value_Pa == 0.0)
        throw Error(ExitCode::bad_input, "loads", "nothing loads the body", "give loads.cavity.pressure");
    return PathFollower(system, sink, log).run();
}

}  // namespace soft::solver
