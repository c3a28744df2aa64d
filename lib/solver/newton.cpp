#include "solver/newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace soft::solver {

namespace {

/// Fraction of a correction's first force scale that bounds the scale from below: a correction may end in a state without any stress
/// (a prestressed body that is released), whose forces are no scale.
constexpr double vanishing_forces = 1e-3;
/// When the residual has fallen to this fraction since the last factorisation, that factor is used for the rest.
constexpr double little_left = 0.05;
/// Fraction of the required residual that the linear solves may leave.
constexpr double share_of_linear_solves = 0.1;
constexpr double loosest_linear_tolerance = 1e-2;
/// With a new factor; one iteration reaches it. Newton's method corrects the rest.
constexpr double tolerance_with_new_factor = 1e-5;
/// With a kept factor, where a change is accepted: far below the factor by which increments shrink.
constexpr double tolerance_of_comparison = 1e-4;
/// With more iterations than this in a solve a new factor is cheaper, unless all solves of a Newton iteration take less than this share of
/// the time of a factorisation.
constexpr int max_iterations_with_kept_factor = 6;
constexpr double share_of_factorization = 0.7;
/// The first correction after a predictor may raise the residual of a nearly incompressible solid before it falls.
constexpr double first_iteration_rise = 20.0;
/// Times change_by_digits: bound of a residual that is rounding (0.1 to 2 times it, in rubber stretched fivefold to fortyfold).
constexpr double rounding_margin = 4.0;

}  // namespace

std::string_view text_of(NewtonEnd end) {
    switch (end) {
        case NewtonEnd::converged: return "converged to another branch";
        case NewtonEnd::inverted: return "an element inverted";
        case NewtonEnd::iteration_limit: return "Newton's method did not converge";
        case NewtonEnd::no_descent: return "the line search finds no descent";
        case NewtonEnd::singular: return "the tangent is singular";
        case NewtonEnd::not_definite: return "the tangent is not positive definite, which cholmod requires";
        case NewtonEnd::linear_solver: return "the linear solver does not converge";
        case NewtonEnd::not_finite: return "the residual is not finite";
        case NewtonEnd::passes_through: return "it would pass through an obstacle";
    }
    return "";
}

Newton::Newton(fem::System& system, const model::SolverSettings& settings)
    : bordered_(system, settings), correction_(system.make_vector()) {
    if (settings.newton != model::NewtonMethod::bfgs) return;
    minus_R_before_ = system.make_vector();
    load_change_ = system.make_vector();
}

void Newton::set_loads(const StageLoads& loads) {
    bordered_.set_loads(loads);
    const fem::System& system = bordered_.system;
    if (rounding_N_ == 0.0)
        rounding_N_ = bordered_.change_by_digits({system.make_vector(), 0.0, {}}, fem::no_loads(system.input()));
}

double Newton::rounding_N() const { return rounding_margin * rounding_N_; }

PathTangent no_tangent(const State& state) {
    return {linalg::duplicate(state.x), 0.0, std::vector(state.pressures_Pa.size(), 0.0), std::nullopt, 0.0};
}

void scale(PathTangent& tangent, double factor) {
    SOFT_PETSC(VecScale(tangent.x, factor));
    tangent.load_factor *= factor;
    tangent.power *= factor;
    for (double& pressure : tangent.pressures) pressure *= factor;
}

void add(PathTangent& to, double factor, const PathTangent& term) {
    linalg::add(to.x, factor, term.x);
    to.load_factor += factor * term.load_factor;
    for (std::size_t k = 0; k < to.pressures.size(); ++k) to.pressures[k] += factor * term.pressures[k];
}

/// Where fibres become slack or taut, or surfaces slide or stick, K jumps and |R| may rise along a sequence of full steps that converges in the end (Newton's
/// method for semismooth equations: Qi and Sun, Math. Programming 58 (1993) 353). Full steps are tried before the correction fails.
NewtonResult Newton::correct(const Constraint& constraint, double target, State& state) {
    const bool may_jump = bordered_.settings.line_search == model::LineSearch::backtracking &&
                          (bordered_.system.has_kinks() || bordered_.system.contact().has_friction());
    if (!may_jump) return correct_by(bordered_.settings.line_search, constraint, target, state);
    State again = copy_of(state);
    NewtonResult result = correct_by(bordered_.settings.line_search, constraint, target, state);
    if (result.end != NewtonEnd::no_descent) return result;
    const NewtonResult second = correct_by(model::LineSearch::none, constraint, target, again);
    if (second.end == NewtonEnd::converged) {
        std::swap(state, again);
        result.end = second.end;
        result.residual = second.residual;
        result.worst_cell = second.worst_cell;
        result.min_jacobian = second.min_jacobian;
    }
    result.iterations += second.iterations;
    result.halvings += second.halvings;
    return result;
}

NewtonResult Newton::correct_by(model::LineSearch line_search, const Constraint& constraint, double target,
                                State& state) {
    Correction now;
    now.line_search = line_search;
    bordered_.factor_is_recent = std::exchange(keeps_factor_, false) && bordered_.factor_is_recent;
    bordered_.columns_are_recent = linear_limit_met_ = false;
    updates_.clear();
    now.evaluation = bordered_.evaluate_at(state);
    const auto report = [&](NewtonEnd end) {
        const bool inexact = linear_limit_met_ && (end == NewtonEnd::iteration_limit || end == NewtonEnd::no_descent);
        now.result.end = inexact ? NewtonEnd::linear_solver : end;
        now.result.worst_cell = now.evaluation.worst_cell;
        now.result.min_jacobian = now.evaluation.min_jacobian;
        return now.result;
    };
    if (!now.evaluation.admissible()) return report(NewtonEnd::inverted);
    State trial = copy_of(state);
    now.residual = linalg::norm(bordered_.R);
    now.first_force_scale = now.evaluation.force_scale;
    now.constraint_tolerance = bordered_.settings.residual_tolerance * std::max(std::abs(target), constraint.scale);
    if (constraint.kind == ConstraintKind::arc)  // a short arc is a small difference of large numbers
        now.constraint_tolerance =
            std::max(now.constraint_tolerance, std::numeric_limits<double>::epsilon() * linalg::norm(state.x));
    for (;;) {
        bordered_.evaluate_rows(constraint, state);
        now.missing = remaining(constraint, bordered_.system.input(), target, bordered_.constraint.value);
        now.loads_stay =
            constraint.kind == ConstraintKind::load_factor && bordered_.supply.empty() && now.missing == 0.0;
        if (const auto end = check_convergence(state, now)) {
            // A kept factor has the inertia of the state at the start of the correction.
            if (bordered_.settings.newton != model::NewtonMethod::full && now.result.iterations > 1)
                bordered_.factor_is_recent = false;
            return report(*end);
        }
        ++now.result.iterations;
        if (const auto failed = solve_blocks(state, now)) return report(*failed);
        const auto step = increment(now);
        if (!step) return report(NewtonEnd::singular);
        const Search found = move(*step, state, trial, now);
        now.result.halvings += found.halvings;
        if (found.end == SearchEnd::no_descent && is_rounding(state, now)) return report(NewtonEnd::converged);
        if (found.end != SearchEnd::found)
            return report(found.end == SearchEnd::inverted ? NewtonEnd::inverted : NewtonEnd::no_descent);
        now.residual = found.trial.residual;
        now.length = found.length;
        now.change_before = std::exchange(now.change, linalg::norm(correction_) / linalg::norm(trial.x));
        if (bordered_.settings.newton == model::NewtonMethod::bfgs) add_secant_pair(found.length);
        std::swap(state, trial);
    }
}

/// How the correction ends at the state last evaluated; nullopt if it continues.
std::optional<NewtonEnd> Newton::check_convergence(const State& state, Correction& now) {
    const double load_scale = std::abs(state.load_factor) * linalg::norm(bordered_.forces.back().out);
    const double scale = std::max({now.evaluation.force_scale, load_scale, vanishing_forces * now.first_force_scale});
    now.result.residual = scale > 0.0 ? now.residual / scale : 0.0;
    const double wanted = bordered_.settings.residual_tolerance * scale;
    now.aim = std::max(wanted, rounding_margin * rounding_N_);
    now.result.within_rounding = now.aim > wanted;
    const bool supplied = std::ranges::all_of(bordered_.supply, [&](const SupplyEquation& equation) {
        return std::abs(equation.value) <= bordered_.settings.residual_tolerance;
    });
    if (!std::isfinite(now.residual) || !std::isfinite(now.missing)) return NewtonEnd::not_finite;
    if (now.residual <= now.aim && supplied && std::abs(now.missing) <= now.constraint_tolerance)
        return NewtonEnd::converged;
    if (is_close(state, now)) return NewtonEnd::converged;
    if (now.result.iterations == bordered_.settings.newton_limit) return NewtonEnd::iteration_limit;
    return std::nullopt;
}

/// Whether the residual is no larger than its change when the unknowns change in their last digits: then the state is as close to
/// equilibrium as floating-point numbers allow. In highly stretched rubber the stiffness is so large relative to the forces that
/// this change exceeds the tolerance.
bool Newton::is_rounding(const State& state, const Correction& now) {
    if (std::abs(now.missing) > now.constraint_tolerance) return false;
    const auto levels = bordered_.loads().levels(state.load_factor, state.pressures_Pa);
    return now.residual <= rounding_margin * bordered_.change_by_digits(state, levels);
}

/// For accept_change(). Not in contact, whose forces change by themselves within its distance, a tiny part of the unknowns.
bool Newton::is_close(const State& state, const Correction& now) const {
    const bool is_full = bordered_.settings.newton == model::NewtonMethod::full && now.length == 1.0;
    if (now.result.iterations < 2 || accepted_change_ == 0.0 || !is_full) return false;
    const bool loads_are_close = std::ranges::all_of(
        bordered_.supply, [&](const SupplyEquation& equation) { return std::abs(equation.value) <= accepted_change_; });
    const double of_tolerance = accepted_change_ / bordered_.settings.residual_tolerance;
    return loads_are_close && std::abs(now.missing) <= of_tolerance * now.constraint_tolerance &&
           now.change * now.change <= accepted_change_ * (now.change_before - now.change) &&
           !bordered_.system.contact().touches(state.x);
}

linalg::LinearSolve Newton::solve_updated(Vec b, Vec x, double tolerance) {
    linalg::LinearSolve last;
    const bool usable = updates_.apply(b, x, [&](Vec q, Vec r) {
        last = bordered_.linear.solve(q, r, {.tolerance = tolerance});
        linear_limit_met_ = linear_limit_met_ || last.at_limit;
        return last.usable();
    });
    return usable ? last : linalg::LinearSolve{};
}

/// Solves for a = K^-1 (-R) and the columns, with a new K or that of the first iteration. R is -R afterwards.
std::optional<NewtonEnd> Newton::solve_blocks(const State& state, const Correction& now) {
    linear_limit_met_ = false;
    const bool full = bordered_.settings.newton == model::NewtonMethod::full;
    if (full && solve_with_kept_factor(now)) return std::nullopt;
    if (full || now.result.iterations == 1) {
        bordered_.differentiate(state);
        if (const auto failed = bordered_.factorize()) return failed;
        residual_at_factor_ = now.residual;
    }
    SOFT_PETSC(VecScale(bordered_.R, -1.0));
    const bool new_factor = full && bordered_.linear.is_direct();
    const double tolerance = new_factor ? tolerance_with_new_factor : 0.0;
    const auto solve = [&](Vec b, Vec x) { return solve_updated(b, x, tolerance); };
    if (solve(bordered_.R, correction_).usable() && (now.loads_stay || bordered_.solve_columns(solve)))
        return std::nullopt;
    return bordered_.solve_failure();
}

/// K is that of this iteration, the factor that of an earlier one.
bool Newton::solve_with_kept_factor(const Correction& now) {
    if (!bordered_.factor_is_recent || bordered_.uses_differences() || !bordered_.linear.is_direct() ||
        now.residual > little_left * residual_at_factor_)
        return false;
    const double exact =
                     now.residual > 0.0 ? share_of_linear_solves * now.aim / now.residual : loosest_linear_tolerance,
                 enough = accepted_change_ > 0.0 ? std::max(exact, tolerance_of_comparison) : exact;
    const auto solves = static_cast<double>(now.loads_stay ? 1 : 1 + bordered_.forces.size());
    const double cheap = share_of_factorization * bordered_.linear.iterations_per_factorization() / solves;
    const int limit = std::max(max_iterations_with_kept_factor, static_cast<int>(cheap));
    linalg::SolveSettings how{linalg::Factor::stale, std::min(enough, loosest_linear_tolerance), limit};
    SOFT_PETSC(VecScale(bordered_.R, -1.0));
    const auto solve = [&](Vec b, Vec x) { return bordered_.linear.solve(b, x, how); };
    bool served = solve(bordered_.R, correction_).converged;
    if (served && !now.loads_stay) {
        how.starts_from_x = bordered_.columns_are_recent;
        served = bordered_.solve_columns(solve);
    }
    if (!served) SOFT_PETSC(VecScale(bordered_.R, -1.0));
    return served;
}

/// Solves the border system; nullopt where it is singular.
std::optional<Newton::Increment> Newton::increment(const Correction& now) {
    if (now.loads_stay) return Increment{{0.0}, now.residual};
    bordered_.fill_border();
    std::vector<double> wanted;  // the right-hand side of the rows, then less the contribution of `a`
    for (const auto& equation : bordered_.supply) wanted.push_back(-equation.value);
    wanted.push_back(now.missing);
    const auto far = linalg::solve(bordered_.border, wanted);
    const auto done = bordered_.rows_times(correction_);
    for (std::size_t i = 0; i < wanted.size(); ++i) wanted[i] -= done[i];
    auto step = linalg::solve(bordered_.border, wanted);
    if (!far || !step) return std::nullopt;
    // What remains, as a force: the residual, and the loads that bring the rows to their targets.
    double pending = now.residual;
    for (std::size_t j = 0; j < far->size(); ++j)
        pending = std::hypot(pending, (*far)[j] * linalg::norm(bordered_.forces[j].out));
    for (std::size_t j = 0; j < step->size(); ++j)
        linalg::add(correction_, (*step)[j], bordered_.columns[j]);  // now dx
    return Increment{std::move(*step), pending};
}

/// Applies the increment with the length of the line search; the new state is in `trial`.
Search Newton::move(const Increment& step, const State& state, State& trial, Correction& now) {
    const auto work_of_loads = [&] {
        double work = 0;
        for (std::size_t j = 0; j < step.loads.size(); ++j)
            work += step.loads[j] * linalg::dot(bordered_.forces[j].out, correction_);
        return work;
    };
    const bool slopes = now.line_search == model::LineSearch::secant;
    const auto set = [&](State& there, double length) {
        linalg::copy(state.x, there.x);
        linalg::add(there.x, length, correction_);
        there.load_factor = state.load_factor + length * step.loads.back();
        for (std::size_t k = 0; k < there.pressures_Pa.size(); ++k)
            there.pressures_Pa[k] = state.pressures_Pa[k] + length * step.loads[k];
    };
    set(trial, 1.0);
    SearchStart start{step.pending, now.result.iterations == 1 ? first_iteration_rise : 1.0, 0.0,
                      bordered_.share_without_crossing(state, trial)};
    if (slopes) start.slope = -linalg::dot(bordered_.R, correction_) - work_of_loads();
    if (bordered_.settings.newton == model::NewtonMethod::bfgs) {
        linalg::copy(bordered_.R, minus_R_before_);
        SOFT_PETSC(VecZeroEntries(load_change_));
        for (std::size_t j = 0; j < step.loads.size(); ++j)
            linalg::add(load_change_, step.loads[j], bordered_.forces[j].out);
    }
    const auto what = bordered_.settings.newton == model::NewtonMethod::full ? BorderedSystem::Assemble::tangent
                                                                             : BorderedSystem::Assemble::forces;
    return search(now.line_search, start, [&](double length) {
        set(trial, length);
        now.evaluation = bordered_.evaluate_at(trial, what);
        if (!now.evaluation.admissible()) return Trial{.admissible = false};
        const double floor =
            std::max(bordered_.settings.residual_tolerance * now.evaluation.force_scale, rounding_margin * rounding_N_);
        Trial there{true, linalg::norm(bordered_.R), floor, 0.0};
        // R is linear in the loads: those not yet applied are added without another evaluation.
        if (slopes) there.slope = linalg::dot(bordered_.R, correction_) - (1.0 - length) * work_of_loads();
        return there;
    });
}

/// Adds the secant pair of a correction that was applied with `length`.
void Newton::add_secant_pair(double length) {
    linalg::Vector s = linalg::duplicate(bordered_.R), y = copy_of(bordered_.R);
    linalg::add(s, length, correction_);
    linalg::add(y, 1.0, minus_R_before_);
    linalg::add(y, length, load_change_);
    updates_.add(std::move(s), std::move(y));
}

}  // namespace soft::solver
