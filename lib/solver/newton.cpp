#include "solver/newton.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

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

linalg::Symmetry symmetry_of(const assembly::System& system) {
    return system.has_symmetric_tangent() ? linalg::Symmetry::symmetric : linalg::Symmetry::general;
}

}  // namespace

void scale(PathTangent& tangent, double factor) {
    SOFT_PETSC(VecScale(tangent.x, factor));
    tangent.load_factor *= factor;
    tangent.power *= factor;
    for (double& pressure : tangent.pressures) pressure *= factor;
}

Newton::Newton(assembly::System& system, const model::SolverSettings& settings)
    : system_(system), settings_(settings), K_(system.make_matrix()), solver_(K_, symmetry_of(system)),
      R_(system.make_vector()), toward_equilibrium_(system.make_vector()) {}

void Newton::set_loads(const StageLoads& loads) {
    loads_ = &loads;
    const std::size_t count = loads.free_supplies().size() + 1;
    for (auto* list : {&forces_, &columns_, &gradients_})
        while (list->size() < count) list->push_back(system_.make_vector());
    wanted_.clear();
    for (std::size_t k = 0; k + 1 < count; ++k) wanted_.push_back({loads.unit_pressure(k), forces_[k]});
    wanted_.push_back({loads.rate(), forces_[count - 1]});
    factor_is_recent_ = false;
}

assembly::Evaluation Newton::evaluate_at(const State& state) {
    return system_.evaluate(state.x, loads_->levels(state.load_factor, state.pressures_Pa), R_, K_, wanted_);
}

void Newton::evaluate_rows(const Constraint& constraint, const State& state) {
    const auto& free = loads_->free_supplies();
    supply_.clear();
    volume_by_load_factor_.clear();
    const auto& motions = loads_->rate().motions;
    for (std::size_t k = 0; k < free.size(); ++k) {
        std::vector<double> by_motion(motions.size(), 0.0);
        const double volume = system_.load_volume(free[k], state.x, gradients_[k], by_motion);
        supply_.push_back(loads_->equation(k, volume, state.pressures_Pa[k], state.load_factor));
        volume_by_load_factor_.push_back(std::inner_product(by_motion.begin(), by_motion.end(), motions.begin(), 0.0));
    }
    constraint_ = evaluate(constraint, system_, *loads_, state, gradients_[free.size()]);
}

std::vector<double> Newton::rows_times(Vec x) const {
    std::vector<double> product;
    for (std::size_t k = 0; k < supply_.size(); ++k)
        product.push_back(supply_[k].by_volume * linalg::dot(gradients_[k], x));
    product.push_back(linalg::dot(gradients_[supply_.size()], x));
    return product;
}

void Newton::fill_border() {
    const int n = static_cast<int>(wanted_.size()), last = n - 1;
    border_ = linalg::SmallMatrix(n);
    for (int j = 0; j < n; ++j) {
        const auto column = rows_times(columns_[static_cast<std::size_t>(j)]);
        for (int i = 0; i < n; ++i) border_.at(i, j) = column[static_cast<std::size_t>(i)];
    }
    for (std::size_t k = 0; k < supply_.size(); ++k) {
        const int row = static_cast<int>(k);
        border_.at(row, row) += supply_[k].by_pressure;
        border_.at(row, last) += supply_[k].by_load_factor + supply_[k].by_volume * volume_by_load_factor_[k];
        border_.at(last, row) += constraint_.by_pressures[k];
    }
    border_.at(last, last) += constraint_.by_load_factor;
}

bool Newton::solve_columns(linalg::Factor factor) {
    for (std::size_t j = 0; j < wanted_.size(); ++j) {
        if (linalg::norm(wanted_[j].out) == 0.0) {   // only volumes or masses change with the load factor
            SOFT_PETSC(VecZeroEntries(columns_[j]));
            continue;
        }
        const auto solve = solver_.solve(wanted_[j].out, columns_[j], factor);
        if (!solve.converged) return false;
        if (factor == linalg::Factor::stale && solve.iterations > many_iterations_for_a_recent_factor) return false;
    }
    return true;
}

NewtonResult Newton::correct(const Constraint& constraint, double target, State& state) {
    NewtonResult result;
    factor_is_recent_ = false;
    auto evaluation = evaluate_at(state);
    State trial{linalg::duplicate(state.x), state.load_factor, state.pressures_Pa};
    const auto report = [&](NewtonEnd end) {
        result.end = end;
        result.worst_cell = evaluation.worst_cell;
        result.min_jacobian = evaluation.min_jacobian;
        return result;
    };
    if (!evaluation.admissible()) return report(NewtonEnd::inverted);
    double residual = linalg::norm(R_);
    const double first_force_scale = evaluation.force_scale;
    const double constraint_scale = std::max(std::abs(target), constraint.scale);
    for (;;) {
        evaluate_rows(constraint, state);
        const double missing = remaining(constraint, system_.input(), target, constraint_.value);
        const double load_scale = std::abs(state.load_factor) * linalg::norm(wanted_.back().out);
        const double scale = std::max({evaluation.force_scale, load_scale, vanishing_forces * first_force_scale});
        result.residual = scale > 0.0 ? residual / scale : 0.0;
        const bool supplied = std::ranges::all_of(supply_, [&](const SupplyEquation& equation) {
            return std::abs(equation.value) <= settings_.residual_tolerance;
        });
        if (!std::isfinite(residual) || !std::isfinite(missing)) return report(NewtonEnd::not_finite);
        if (residual <= settings_.residual_tolerance * scale && supplied &&
            std::abs(missing) <= settings_.residual_tolerance * constraint_scale)
            return report(NewtonEnd::converged);
        if (result.iterations == settings_.newton_limit) return report(NewtonEnd::iteration_limit);
        ++result.iterations;

        factor_ = solver_.factorize();
        if (!factor_.succeeded) return report(NewtonEnd::singular);
        factor_is_recent_ = true;
        SOFT_PETSC(VecScale(R_, -1.0));
        if (!solver_.solve(R_, toward_equilibrium_).converged || !solve_columns(linalg::Factor::fresh))
            return report(NewtonEnd::singular);
        fill_border();
        std::vector<double> wanted;   // what the rows still lack, then what `a` leaves of it
        for (const auto& equation : supply_) wanted.push_back(-equation.value);
        wanted.push_back(missing);
        const auto far = linalg::solve(border_, wanted);
        const auto done = rows_times(toward_equilibrium_);
        for (std::size_t i = 0; i < wanted.size(); ++i) wanted[i] -= done[i];
        const auto step = linalg::solve(border_, wanted);
        if (!far || !step) return report(NewtonEnd::singular);
        // What is still to be done, as a force: the residual, and the loads that move the rows to their targets.
        double pending = residual;
        for (std::size_t j = 0; j < far->size(); ++j)
            pending = std::hypot(pending, (*far)[j] * linalg::norm(wanted_[j].out));
        for (std::size_t j = 0; j < step->size(); ++j) linalg::add(toward_equilibrium_, (*step)[j], columns_[j]);   // now dx

        double length = 1.0;
        const double allowed_rise = result.iterations == 1 ? first_iteration_rise : 1.0;
        for (int attempt = 0;; ++attempt, length *= 0.5) {
            if (attempt == line_search_limit)
                return report(evaluation.admissible() ? NewtonEnd::no_descent : NewtonEnd::inverted);
            if (attempt > 0) ++result.halvings;
            linalg::copy(state.x, trial.x);
            linalg::add(trial.x, length, toward_equilibrium_);
            trial.load_factor = state.load_factor + length * step->back();
            for (std::size_t k = 0; k < trial.pressures_Pa.size(); ++k)
                trial.pressures_Pa[k] = state.pressures_Pa[k] + length * (*step)[k];
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

std::optional<PathTangent> Newton::tangent(const Constraint& constraint, const State& state) {
    if (!evaluate_at(state).admissible()) return std::nullopt;
    if (!factor_is_recent_ || !solve_columns(linalg::Factor::stale)) {
        factor_ = solver_.factorize();
        factor_is_recent_ = factor_.succeeded;
        if (!factor_.succeeded || !solve_columns(linalg::Factor::fresh)) return std::nullopt;
    }
    evaluate_rows(constraint, state);
    fill_border();
    std::vector<double> unit(wanted_.size(), 0.0);
    unit.back() = 1.0;
    auto rates = linalg::solve(border_, unit);
    if (!rates) return std::nullopt;
    PathTangent tangent;
    tangent.x = linalg::duplicate(R_);
    for (std::size_t j = 0; j < rates->size(); ++j) linalg::add(tangent.x, (*rates)[j], columns_[j]);
    tangent.load_factor = rates->back();
    rates->pop_back();
    tangent.pressures = std::move(*rates);
    tangent.unstable_modes = unstable_modes();
    tangent.power = linalg::dot(wanted_.back().out, tangent.x);
    return tangent;
}

std::optional<int> Newton::excess_pivots() {
    const auto pressures = system_.dofs().pressures;   // one negative pivot each belongs to the saddle point
    if (factor_.negative_pivots) {
        const int count = static_cast<int>(*factor_.negative_pivots - pressures);
        if (count != confirmed_pivots_) {
            const auto negative = solver_.determinant_is_negative();
            const auto agrees = [&](int pivots) { return *negative == ((pressures + pivots) % 2 != 0); };
            if (negative && !agrees(count) && agrees(confirmed_pivots_)) return confirmed_pivots_;
        }
        return confirmed_pivots_ = count;
    }
    if (factor_.determinant_is_negative) return *factor_.determinant_is_negative != (pressures % 2 == 1) ? 1 : 0;
    return std::nullopt;
}

std::optional<int> Newton::unstable_modes() {
    const auto modes = excess_pivots();
    if (!modes) return std::nullopt;
    const int free = static_cast<int>(supply_.size());
    linalg::SmallMatrix held(free);   // compliance of the gas + grad V . K^-1 f
    for (int i = 0; i < free; ++i)
        for (int j = 0; j < free; ++j) held.at(i, j) = border_.at(i, j) / supply_[static_cast<std::size_t>(i)].by_volume;
    const int freed = linalg::negative_eigenvalues(held);
    return factor_.negative_pivots ? *modes - freed : (*modes + freed) % 2;
}

std::optional<linalg::Vector> Newton::bordered_solve(Vec b) {
    linalg::Vector v = linalg::duplicate(b);
    if (!solver_.solve(b, v, linalg::Factor::stale).converged) return std::nullopt;
    auto rows = rows_times(v);
    for (double& row : rows) row = -row;
    const auto border = linalg::solve(border_, rows);
    if (!border) return std::nullopt;
    for (std::size_t j = 0; j < border->size(); ++j) linalg::add(v, (*border)[j], columns_[j]);
    return v;
}

}  // namespace soft::solver
