#include "solver/stepping.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/mesh.hpp"
#include "solver/row_state.hpp"

namespace soft::solver {

namespace {

/// A step whose predictor error exceeds this fraction of the step is repeated, shorter: the corrector may have
/// converged to another branch.
constexpr double predictor_error_limit = 0.5;
/// A step along the tangent alone is repeated where the square of its error, an estimate of the error of the curve between its
/// rows, exceeds this multiple of step_accuracy, and one along a Taylor polynomial where its estimate does (between_rows); in contact,
/// where the curve may bend suddenly, also one along the cubic.
constexpr double coarse_curve = 2.0;
/// Error of the cubic beyond the first row, in a step as long as the first, of that of the Taylor polynomial at this row: 4 for a term of
/// fourth order alone, as measured for loads; 0.3 to 2.2 measured for states of bellows and fingers.
constexpr double state_after_series = 1.5, load_after_series = 4.0;
/// Error of the cubic between two rows, of that of the Taylor polynomial at the first of them.
constexpr double between_rows = 1.0 / 16.0;
/// Below this predictor error the state belongs to the same branch.
constexpr double predictor_error_without_jump = 0.05;
/// In contact, or with fibres, other branches are closer. Up to this error a change of the inertia is a bifurcation: refusing it would let the
/// path approach it in ever shorter steps.
constexpr double error_on_the_branch = 1e-4;
/// On a smooth path the tangent's error falls with the step, which is cut to 0.4 between two attempts.
constexpr double error_at_a_kink = 0.8;
/// The curve between two rows is the cubic through them: its load error is controlled as well, with this weight.
constexpr double load_share = 0.45;
/// Near a limit point the load's error is relative to this fraction of the load, not to its change.
constexpr double flat_load = 0.1;
/// With fibres and in contact, the error of the state is relative to at least this fraction of the state: each point whose fibres go
/// taut or slack, or which begins to touch, bends the path, and the error relative to a shorter step does not decrease.
constexpr double min_kinked_step = 0.1;
/// The same for fibres where the loads are prescribed, so that the path does not turn back: the curve between rows errs far less
/// than the predictor beyond them. With 0.1 a segment needs twice the steps for a curve that differs by less than 1e-4.
constexpr double min_fibre_step = 0.5;
/// In contact, the error of the state is relative to at least this motion of all nodes, as a fraction of the size of the body: a body at rest
/// that an obstacle touches moves by powers of ten before it is loaded.
constexpr double min_size_in_contact = 1e-5;
/// In time the body may hardly move, or return to rest: the error of the state is relative to at least this fraction of its largest size.
constexpr double min_step_in_time = 0.01;
/// Bounds of the step-size factor from one step to the next; in contact the path may bend suddenly.
constexpr double max_growth = 5.0, max_growth_in_contact = 2.5, max_growth_of_derivatives = 2.0,
                 growth_of_linear_steps = 100.0, min_shrink = 0.3, min_retake = 0.1;
/// Times the estimated error of the viscous stress, so that loads and outputs of stress that nearly cancels, and the balance of energies,
/// hold the accuracy too.
constexpr double safety_in_time = 4.0;
/// Times the error allowed in time: a step with a larger one is repeated.
constexpr double rejected_in_time = 2.0;
/// Newton iterations beyond which the step does not grow.
constexpr int many_iterations = 7;
/// Relative to the size of the body: a first step that moves its nodes by less, in the root mean square, is not cut further because
/// of the load.
constexpr double motionless = 1e-7;
/// Times step_accuracy, relative to the state and load: a smaller predictor error does not shorten the steps. Steps with such
/// errors are so short that the error may come from the tolerance of equilibrium where the body hardly resists a motion.
constexpr double negligible_error = 1e-3;
/// Value of a negligible error in units of step_accuracy, so that the next step is slightly longer.
constexpr double accepted_share = 0.5;
/// A goal beyond the end of a step is aimed at if it is this fraction of the step away, instead of a last short step.
constexpr double last_stretch = 0.3;
/// A repeated step, 0.9 of what its error allows, must not reach the same goal again.
static_assert(0.9 * (1.0 + last_stretch) < 1.25 && rejected_in_time >= 2.0 && coarse_curve >= 2.0);
/// A fraction of a step that counts as rounding: far above the rounding of sums, far below any step.
constexpr double sliver = 1e-6;

/// Norm of the unknowns where each is as large as this.
double norm_of_motion(const fem::System& system, double motion_m) {
    return std::sqrt(static_cast<double>(system.dofs().total)) * motion_m;
}

/// A constant step under load-factor control ends on its multiples, also after a step that was cut: rows at k x first_step.
double next_q(const PathState& path, bool constant) {
    const double last = path.last->q, end = last + path.step;
    if (!constant || path.control.kind != ConstraintKind::load_factor) return end;
    const double on_grid = path.first_step * (std::floor(last / path.first_step + sliver) + 1.0);
    const bool shortened = std::abs(path.step) < std::abs(path.first_step);
    return shortened && std::abs(end - last) < (1.0 - sliver) * std::abs(on_grid - last) ? end : on_grid;
}

/// Factor on the step for an error that is proportional to the power order + 1 of the step.
double factor_for(double error, double order, const model::SolverSettings& settings, const NewtonResult& result,
                  double growth) {
    const double factor = std::pow(settings.step_accuracy / std::max(error, 1e-12), 1.0 / order);
    const bool is_linear = result.iterations == 0 && result.within_rounding;
    const double bounded = std::clamp(0.9 * factor, min_shrink, is_linear ? growth_of_linear_steps : growth);
    return result.iterations > many_iterations ? std::min(bounded, 0.7) : bounded;
}

}  // namespace

Aim aim_of(const PathState& path, Corrector& corrector) {
    const model::SolverSettings& settings = corrector.input().solver;
    const bool constant = settings.steps == model::StepRule::constant;
    const bool straight = !path.before || settings.predictor == model::Predictor::tangent;
    const PathPoint *before = straight ? nullptr : &*path.before, &last = *path.last;
    const double end = next_q(path, constant);
    // With constant steps, rounding must not leave a tiny step before a goal that lies on the grid.
    const bool free = settings.steps == model::StepRule::error_adaptive && settings.max_step == 0.0 && !last.touches;
    const double reach = end + (constant ? sliver : free ? last_stretch : 0.0) * (end - last.q);
    Aim aim{.crossing = first_predicted(path.goals, before, last, reach),
            .straight = straight,
            .by_series = !straight && path.begins_stage()};
    aim.forecast = predict(before, last, aim.crossing ? aim.crossing->q : end);
    aim.constraint = aim.crossing ? aim.crossing->goal->constraint : bind(path.control, last);
    aim.target = aim.crossing ? aim.crossing->goal->target : end;
    if (!aim.crossing) aim.constraint.scale = std::abs(constant ? end - last.q : path.step);
    if (aim.constraint.kind == ConstraintKind::load_factor) aim.forecast.load_factor = aim.target;  // to the last digit
    if (aim.constraint.kind == ConstraintKind::arc)
        aim.target = corrector.value(aim.constraint, *path.loads, aim.forecast);
    return aim;
}

State guess_of(const Aim& aim, const PathState& path, model::Predictor predictor) {
    return copy_of(predictor == model::Predictor::none ? path.last->state : aim.forecast);
}

double PredictorError::larger() const { return std::max(state, load_share * load); }

bool may_have_kinks(const fem::System& system, const PathPoint& point) { return system.has_kinks() || point.touches; }

PredictorError error_of(const fem::System& system, const PathState& path, const Aim& aim, const PathPoint& point) {
    const model::SolverSettings& settings = system.input().solver;
    const double unknown = equilibrium_margin * settings.residual_tolerance;
    const double error = distance(aim.forecast.x, point.state.x), change = distance(point.state.x, path.last->state.x);
    const bool in_time = stage_of(system.input(), path).time_s.has_value();
    const double own_size = linalg::norm(point.state.x), size = in_time ? std::max(own_size, path.size) : own_size;
    const bool in_contact = point.touches || path.last->touches;  // also where it opens
    const double at_rest =
        in_contact ? norm_of_motion(system, min_size_in_contact * mesh::extent_m(system.input().mesh)) : 0.0;
    const double negligible = negligible_error * settings.step_accuracy;
    const bool is_prescribed = path.control.kind == ConstraintKind::load_factor;
    const double min_step = !in_contact && !system.has_kinks() ? 0.0
                            : in_contact || !is_prescribed     ? min_kinked_step
                                                               : min_fibre_step;
    const double step =
        std::max(change, (in_time ? std::max(min_step, min_step_in_time) : min_step) * std::max(size, at_rest));
    const double load = std::abs(point.leading);
    const double load_error = std::abs(leading_of(system.input(), *path.loads, aim.forecast) - point.leading);
    const double load_step = std::max(std::abs(point.leading - path.last->leading), flat_load * load);
    return {error > unknown * size ? error / step : 0.0, load_error > unknown * load ? load_error / load_step : 0.0,
            error <= negligible * size && load_error <= negligible * load};
}

bool is_refused(const fem::System& system, const PathState& path, const PredictorError& error, const PathPoint& point) {
    const auto &modes = point.tangent.unstable_modes, &modes_before = path.last->tangent.unstable_modes;
    const ConstraintKind kind = path.control.kind;
    const auto before = branch_index(path, *path.last), here = branch_index(path, point);
    const int change = before && here ? std::abs(*here - *before) : 0;
    // By arc length the load may turn twice within a short step, and its count of modes with it; but under a control of the user the path
    // ends at the first limit point, which must not be passed.
    const bool is_smooth = !may_have_kinks(system, *path.last) && !point.touches;
    const bool by_arc = kind == ConstraintKind::arc;
    const bool leaves = kind == ConstraintKind::load_factor
                            ? modes && modes_before && *modes != *modes_before
                            : is_smooth && (by_arc ? path.user_control && change > 1 : change > 0);
    if (leaves && error.state > predictor_error_without_jump) return true;
    const bool may_leave_branch = kind == ConstraintKind::arc
                                      ? may_have_kinks(system, *path.last)
                                      : kind != ConstraintKind::load_factor && path.last->touches;
    if (may_leave_branch && error.state > error_on_the_branch && path.attempts.failures < failures_before_kink &&
        change % 2 != 0)
        return true;
    if (system.input().solver.steps != model::StepRule::error_adaptive) return false;
    // At a kink of the law (fibres that become taut) the tangent is one-sided: the error does not fall with the step.
    const auto& rejected = path.attempts.rejected_error;
    const bool kink = rejected && error.state > error_at_a_kink * *rejected;
    return error.state > predictor_error_limit && !kink;
}

bool shorten_for_the_curve(const fem::System& system, PathState& path, const Aim& aim, double missed,
                           const PathPoint& point) {
    const double taken = point.q - path.last->q;
    const model::SolverSettings& settings = system.input().solver;
    const bool squared = aim.straight && settings.predictor != model::Predictor::tangent;
    if (settings.steps != model::StepRule::error_adaptive ||
        (!squared && !aim.by_series && !path.last->touches && !point.touches))
        return false;
    const double error = squared ? missed * missed : aim.by_series && !point.touches ? between_rows * missed : missed;
    const double order = squared ? 2.0 : 3.0;
    auto& rejected = path.attempts.rejected_curve_error;
    const bool kink = rejected && error > error_at_a_kink * *rejected;
    if (error <= coarse_curve * settings.step_accuracy || kink) return false;
    // A goal may lie farther away than predicted: the next attempt ends before the place predicted.
    const double predicted = aim.crossing ? std::abs(aim.crossing->q - path.last->q) : std::abs(taken);
    const double shorter = std::max(0.9 * std::pow(settings.step_accuracy / error, 1.0 / order), min_retake) *
                           std::copysign(std::min(std::abs(taken), predicted), taken);
    if (is_first_try(system, path, shorter))
        reduce_first_step(path, round_step_size(shorter));
    else if (std::abs(shorter / path.first_step) < settings.min_step)
        return false;
    rejected = error;
    path.step = round_step_size(shorter);
    return true;
}

bool limits_steps_in_time(const fem::System& system, const PathState& path) {
    return system.input().solver.steps != model::StepRule::constant && system.internal().shortest_time_s() > 0.0 &&
           stage_of(system.input(), path).time_s;
}

std::optional<double> error_in_time(fem::System& system, const PathState& path, const PathPoint& point) {
    if (!limits_steps_in_time(system, path)) return std::nullopt;
    system.prescribe(point.levels);
    const auto error = system.fields().error_in_time(point.state.x);
    return error ? std::optional(safety_in_time * *error / system.input().path.time_accuracy) : std::nullopt;
}

bool shorten_for_time(const fem::System& system, PathState& path, std::optional<double> error, const PathPoint& point) {
    if (!error || *error <= rejected_in_time) return false;
    const double shorter = (point.q - path.last->q) * std::max(0.9 / std::sqrt(*error), min_shrink);
    if (shorter < system.input().solver.min_step * path.first_step) return false;
    path.step = round_step_size(shorter);
    return true;
}

double longest_in_time(const PathState& path, std::optional<double> error) {
    const double taken = path.last->q - path.before->q;
    return round_step_size(taken * (error ? std::clamp(0.9 / std::sqrt(*error), min_shrink, max_growth) : 1.0));
}

bool is_first_try(const fem::System& system, const PathState& path, double step) {
    if (!path.begins_stage() || system.input().solver.steps == model::StepRule::constant) return false;
    return std::abs(step) * linalg::norm(path.last->tangent.x) >
           norm_of_motion(system, motionless * mesh::extent_m(system.input().mesh));
}

void reduce_first_step(PathState& path, double step) {
    if (std::abs(step) < std::abs(path.first_step)) path.first_step = step;
}

double next_step(const model::Case& input, const PathState& path, const Aim& aim, const PredictorError& error,
                 const NewtonResult& result) {
    const model::SolverSettings& settings = input.solver;
    double step = path.last->q - path.before->q;
    switch (settings.steps) {
        case model::StepRule::constant:  // grows back after a cut
            return std::abs(2.0 * path.step) < std::abs(path.first_step) ? 2.0 * path.step : path.first_step;
        case model::StepRule::iteration_adaptive: {  // Ramm 1981; Crisfield 1991 9.5.1
            const double iterations = std::max(result.iterations, 1);
            step *= std::clamp(std::sqrt(settings.wanted_iterations / iterations), 0.5, 2.0);
            break;
        }
        case model::StepRule::error_adaptive: {
            double missed =
                aim.by_series
                    ? PredictorError{state_after_series * error.state, load_after_series * error.load}.larger()
                    : error.larger();
            if (error.is_negligible) missed = std::min(missed, accepted_share * settings.step_accuracy);
            const bool by_tangent = settings.predictor == model::Predictor::tangent;
            // After a tangent the next predictor is the cubic: for a series with decreasing terms its error is 4 missed^3.
            const double next = aim.straight && !by_tangent ? missed * missed : missed;
            const double growth = !input.parameters.empty() ? max_growth_of_derivatives
                                  : path.last->touches      ? max_growth_in_contact
                                                            : max_growth;
            step *= factor_for(next, aim.straight && by_tangent ? 1.0 : 3.0, settings, result, growth);
        }
    }
    step = round_step_size(step);
    if (!(settings.max_step > 0.0)) return step;
    const double bound = settings.max_step * std::abs(path.last->q);
    return std::clamp(step, -bound, bound);
}

std::optional<int> branch_index(const PathState& path, const PathPoint& point) {
    if (!point.tangent.unstable_modes) return std::nullopt;
    return *point.tangent.unstable_modes - (path.load_falls(point) ? 1 : 0);
}

}  // namespace soft::solver
