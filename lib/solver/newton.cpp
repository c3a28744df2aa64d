#include "solver/newton.hpp"

#include <algorithm>
#include <cmath>

namespace soft::solver {

namespace {

/// Armijo's constant: any decrease proportional to the step is accepted.
constexpr double sufficient_decrease = 1e-4;
constexpr int line_search_limit = 6;
/// Where a correction ends in a state without any stress (a prestressed body set free) its forces are no scale any more.
constexpr double vanishing_forces = 1e-3;
/// A tangent solved with the last correction's factor takes 2 or 3 iterations; beyond this a new factor is cheaper.
constexpr int many_iterations_for_a_recent_factor = 5;
/// The first correction after a predictor may raise the residual of a nearly incompressible solid before it falls.
constexpr double first_iteration_rise = 20.0;

}  // namespace

Newton::Newton(assembly::System& system, const model::SolverSettings& settings)
    : system_(system), settings_(settings), K_(system.make_matrix()), solver_(K_, system.has_symmetric_tangent() ? linalg::Symmetry::symmetric : linalg::Symmetry::general), R_(system.make_vector()),
      load_(system.make_vector()), gradient_(system.make_vector()), toward_equilibrium_(system.make_vector()),
      along_load_(system.make_vector()) {}

assembly::Evaluation Newton::evaluate_at(const State& state) {
    return system_.evaluate(state.x, state.load_factor, R_, load_, K_);
}

bool Newton::solve_directions() {
    factor_ = solver_.factorize();
    if (!factor_.succeeded) return false;
    factor_is_recent_ = true;
    SOFT_PETSC(VecScale(R_, -1.0));
    const bool solved =
        solver_.solve(R_, toward_equilibrium_).converged && solver_.solve(load_, along_load_).converged;
    SOFT_PETSC(VecScale(R_, -1.0));
    return solved;
}

NewtonResult Newton::correct(const Constraint& constraint, double target, State& state) {
    NewtonResult result;
    factor_is_recent_ = false;
    auto evaluation = evaluate_at(state);
    State trial{linalg::duplicate(state.x), state.load_factor};
    const auto report = [&](NewtonEnd end) {
        result.end = end;
        result.worst_cell = evaluation.worst_cell;
        result.min_jacobian = evaluation.min_jacobian;
        return result;
    };
    if (!evaluation.admissible()) return report(NewtonEnd::inverted);
    double residual = linalg::norm(R_);
    const double first_force_scale = evaluation.force_scale;
    for (;;) {
        const double value = evaluate(constraint, system_, state.x, state.load_factor, gradient_);
        const double scale = std::max({evaluation.force_scale, std::abs(state.load_factor) * linalg::norm(load_),
                                       vanishing_forces * first_force_scale});
        result.residual = scale > 0.0 ? residual / scale : 0.0;
        if (!std::isfinite(residual)) return report(NewtonEnd::no_descent);
        if (residual <= settings_.residual_tolerance * scale &&
            std::abs(value - target) <= settings_.residual_tolerance * std::abs(target))
            return report(NewtonEnd::converged);
        if (result.iterations == settings_.newton_limit) return report(NewtonEnd::iteration_limit);
        ++result.iterations;
        if (!solve_directions()) return report(NewtonEnd::singular);
        const double denominator = load_slope(constraint) + linalg::dot(gradient_, along_load_);
        const double load_step =
            (target - value - linalg::dot(gradient_, toward_equilibrium_)) / denominator;
        if (!std::isfinite(load_step)) return report(NewtonEnd::singular);
        // What is still to be done, as a force: the residual, and the load that moves c to its target.
        const double pending =
            std::hypot(residual, std::abs((target - value) / denominator) * linalg::norm(load_));
        linalg::add(toward_equilibrium_, load_step, along_load_);   // now dx

        double length = 1.0;
        const double allowed_rise = result.iterations == 1 ? first_iteration_rise : 1.0;
        for (int attempt = 0;; ++attempt, length *= 0.5) {
            if (attempt == line_search_limit)
                return report(evaluation.admissible() ? NewtonEnd::no_descent : NewtonEnd::inverted);
            linalg::copy(state.x, trial.x);
            linalg::add(trial.x, length, toward_equilibrium_);
            trial.load_factor = state.load_factor + length * load_step;
            evaluation = evaluate_at(trial);
            if (!evaluation.admissible()) continue;
            const double next = linalg::norm(R_);
            const double floor = settings_.residual_tolerance * evaluation.force_scale;
            if (next <= std::max(floor, allowed_rise * pending * (1.0 - sufficient_decrease * length))) {
                residual = next;
                break;
            }
        }
        std::swap(state, trial);
    }
}

bool Newton::solve_along_load() {
    if (factor_is_recent_) {
        const auto solve = solver_.solve(load_, along_load_, linalg::Factor::stale);
        if (solve.converged && solve.iterations <= many_iterations_for_a_recent_factor) return true;
    }
    factor_ = solver_.factorize();
    return factor_.succeeded && solver_.solve(load_, along_load_).converged;
}

std::optional<PathTangent> Newton::tangent(const Constraint& constraint, const State& state) {
    if (!evaluate_at(state).admissible()) return std::nullopt;
    if (!solve_along_load()) return std::nullopt;
    (void)evaluate(constraint, system_, state.x, state.load_factor, gradient_);
    PathTangent tangent;
    tangent.load_factor = 1.0 / (load_slope(constraint) + linalg::dot(gradient_, along_load_));
    if (!std::isfinite(tangent.load_factor)) return std::nullopt;
    tangent.x = linalg::duplicate(along_load_);
    linalg::add(tangent.x, tangent.load_factor, along_load_);
    if (factor_.negative_pivots)
        tangent.excess_pivots = static_cast<int>(*factor_.negative_pivots - system_.dofs().pressures);
    return tangent;
}

}  // namespace soft::solver
