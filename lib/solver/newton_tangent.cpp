/// The tangent of the path, and its stability from the inertia of the factor.
#include <algorithm>
#include <cmath>

#include "solver/newton.hpp"

namespace soft::solver {

namespace {

/// A path tangent solved with the last correction's factor takes 2 or 3 iterations; with more than this a new factor is cheaper, and the
/// inertia of the old one may not be that of K. From the columns of that correction, half of the digits remain.
constexpr int max_iterations_with_recent_factor = 5, max_iterations_from_recent_columns = 3;
/// How often a Krylov method may reach its iteration limit for the path tangent, which must be accurate.
constexpr int rounds_for_a_direction = 10;
/// Motion of the tangent by the whole load, relative to the state, from which on a solve with K alone loses digits: next to a limit point.
constexpr double soft_response = 1e3;
/// A difference below this fraction of its terms is within the linear solver's tolerance.
constexpr double of_differences = 1e-6;

/// PathTangent::power per unit of the load factor; nullopt where the small system of the supplies is singular.
std::optional<double> power_with_supplies_held(const BorderedSystem& bordered) {
    const auto free = static_cast<int>(bordered.supply.size());
    const Vec force = bordered.forces.back().out, response = bordered.columns[bordered.forces.size() - 1];
    double power = linalg::dot(force, response), largest = std::abs(power);
    if (free == 0) return power;
    linalg::SmallMatrix supply_block(free);
    for (int i = 0; i < free; ++i)
        for (int j = 0; j < free; ++j) supply_block.at(i, j) = bordered.border.at(i, j);
    std::vector<double> missing = bordered.rows_times(response);
    missing.pop_back();
    const auto pressures = linalg::solve(supply_block, missing);
    if (!pressures) return std::nullopt;
    for (std::size_t k = 0; k < pressures->size(); ++k) {
        const double taken_back = (*pressures)[k] * linalg::dot(force, bordered.columns[k]);
        largest = std::max(largest, std::abs(taken_back));
        power -= taken_back;
    }
    return std::abs(power) > of_differences * largest ? power : 0.0;  // the body cannot move at constant volume
}

/// Negative pivots of K in excess of one per pressure unknown (with LU their parity), of the last factor.
std::optional<int> pivots_of_factor(const BorderedSystem& bordered) {
    const auto pressures = bordered.system.dofs().pressures;  // one negative pivot each belongs to the saddle point
    if (bordered.factor.negative_pivots) return static_cast<int>(*bordered.factor.negative_pivots - pressures);
    if (bordered.factor.determinant_is_negative)
        return *bordered.factor.determinant_is_negative != (pressures % 2 == 1) ? 1 : 0;
    return std::nullopt;
}

}  // namespace

linalg::LinearSolve Newton::solve_accurately(Vec b, Vec x, linalg::SolveSettings how) {
    auto solve = bordered_.linear.solve(b, x, how);
    how.starts_from_x = true;
    for (int round = 1; solve.at_limit && round < rounds_for_a_direction; ++round)
        solve = bordered_.linear.solve(b, x, how);
    if (!solve.converged) return {};
    return solve;
}

std::optional<NewtonEnd> Newton::solve_tangent_columns() {
    const bool starts = bordered_.columns_are_recent;
    const int limit = starts ? max_iterations_from_recent_columns : max_iterations_with_recent_factor;
    const linalg::SolveSettings how{.factor = linalg::Factor::stale,
                                    .max_iterations = bordered_.linear.is_krylov() ? 0 : limit,
                                    .starts_from_x = starts};
    const auto with_the_last = [&](Vec b, Vec x) { return solve_accurately(b, x, how); };
    const auto with_a_new = [this](Vec b, Vec x) { return solve_accurately(b, x, {}); };
    // The factor may be that of a slightly earlier state: its inertia is used only if it has not changed since the last tangent.
    const auto inertia_is_unchanged = [this] {
        const auto pivots = pivots_of_factor(bordered_);
        return !pivots || (bordered_.factor.negative_pivots ? *pivots == confirmed_pivots_
                                                            : (*pivots - confirmed_pivots_) % 2 == 0);
    };
    if (bordered_.factor_is_recent && inertia_is_unchanged() && bordered_.solve_columns(with_the_last))
        return std::nullopt;
    if (const auto failed = bordered_.factorize()) return failed;
    if (!bordered_.solve_columns(with_a_new)) return bordered_.solve_failure();
    return std::nullopt;
}

std::optional<PathTangent> Newton::tangent(const Constraint& constraint, const State& state) {
    tangent_end_ = NewtonEnd::singular;
    if (bordered_.is_assembled_at(state))
        bordered_.system.prescribe(bordered_.loads().levels(state.load_factor, state.pressures_Pa));
    else if (!bordered_.evaluate_at(state).admissible())
        return std::nullopt;
    bordered_.differentiate(state);
    bordered_.add_time_force(state);
    const auto failed = solve_tangent_columns();
    bordered_.columns_are_recent = false;  // the next tangent may be that of another state
    if (failed) {
        tangent_end_ = *failed;
        return std::nullopt;
    }
    bordered_.evaluate_rows(constraint, state);
    bordered_.fill_border();
    std::vector<double> unit(bordered_.forces.size(), 0.0);
    unit.back() = 1.0;
    auto rates = linalg::solve(bordered_.border, unit);
    if (!rates) return std::nullopt;
    tangent_end_ = NewtonEnd::converged;
    PathTangent tangent;
    tangent.x = linalg::duplicate(bordered_.R);
    for (std::size_t j = 0; j < rates->size(); ++j) linalg::add(tangent.x, (*rates)[j], bordered_.columns[j]);
    tangent.load_factor = rates->back();
    loses_digits_ =
        std::abs(state.load_factor) * linalg::norm(bordered_.columns.back()) > soft_response * linalg::norm(state.x);
    rates->pop_back();
    tangent.pressures = std::move(*rates);
    tangent.unstable_modes = unstable_modes();
    tangent.power =
        bordered_.loads_move() ? 0.0 : tangent.load_factor * power_with_supplies_held(bordered_).value_or(0.0);
    return tangent;
}

std::optional<int> Newton::excess_pivots() {
    const auto count = pivots_of_factor(bordered_);
    if (!count) return std::nullopt;
    if (bordered_.factor.negative_pivots && *count != confirmed_pivots_) {
        const auto negative = bordered_.linear.determinant_is_negative();
        const auto agrees = [&](int pivots) {
            return *negative == ((bordered_.system.dofs().pressures + pivots) % 2 != 0);
        };
        if (negative && !agrees(*count) && agrees(confirmed_pivots_)) return confirmed_pivots_;
    }
    confirmed_pivots_ = *count;
    return count;
}

std::optional<int> Newton::unstable_modes() {
    const auto modes = excess_pivots();
    if (!modes) return std::nullopt;
    const int free = static_cast<int>(bordered_.supply.size());
    linalg::SmallMatrix supply_block(free);  // compliance of the gas + grad V . K^-1 f
    for (int i = 0; i < free; ++i)
        for (int j = 0; j < free; ++j)
            supply_block.at(i, j) = bordered_.border.at(i, j) / bordered_.supply[static_cast<std::size_t>(i)].by_volume;
    const int freed = linalg::negative_eigenvalues(supply_block);
    return bordered_.factor.negative_pivots ? *modes - freed : (*modes + freed) % 2;
}

/// Near a limit point K^-1 is large: one step of iterative refinement with M returns the digits that cancel.
std::optional<PathTangent> Newton::bordered_solve(Vec b, std::span<const double> rows) {
    auto solution = eliminate(b, rows);
    if (!solution || !loses_digits_ || bordered_.uses_differences()) return solution;
    const linalg::Vector left = linalg::duplicate(b);
    SOFT_PETSC(MatMult(bordered_.K, solution->x, left));
    SOFT_PETSC(VecAYPX(left, -1.0, b));
    std::vector<double> border = solution->pressures, missing = bordered_.rows_times(solution->x);
    border.push_back(solution->load_factor);
    for (std::size_t i = 0; i < missing.size(); ++i) {
        missing[i] = (i < rows.size() ? rows[i] : 0.0) - missing[i];
        for (std::size_t j = 0; j < border.size(); ++j)
            missing[i] -= bordered_.by_loads.at(static_cast<int>(i), static_cast<int>(j)) * border[j];
        linalg::add(left, border[i], bordered_.forces[i].out);
    }
    if (const auto rest = eliminate(left, missing)) add(*solution, 1.0, *rest);
    return solution;
}

std::optional<PathTangent> Newton::eliminate(Vec b, std::span<const double> rows) {
    PathTangent solution{linalg::duplicate(b), 0, {}, {}, 0};
    if (!solve_accurately(b, solution.x, {.factor = linalg::Factor::stale}).converged) return std::nullopt;
    auto missing = bordered_.rows_times(solution.x);
    for (std::size_t k = 0; k < missing.size(); ++k) missing[k] = (k < rows.size() ? rows[k] : 0.0) - missing[k];
    auto border = linalg::solve(bordered_.border, missing);
    if (!border) return std::nullopt;
    for (std::size_t j = 0; j < border->size(); ++j) linalg::add(solution.x, (*border)[j], bordered_.columns[j]);
    solution.load_factor = border->back();
    border->pop_back();
    solution.pressures = std::move(*border);
    return solution;
}

void Newton::evaluate_rows(const Constraint& constraint, const State& state) {
    bordered_.system.prescribe(bordered_.loads().levels(state.load_factor, state.pressures_Pa));
    bordered_.evaluate_rows(constraint, state);
    bordered_.fill_border();
}

std::optional<Newton::Miss> Newton::miss(const Constraint& constraint, double target, const State& state) {
    bordered_.forget_assembly();
    const auto levels = bordered_.loads().levels(state.load_factor, state.pressures_Pa);
    if (!bordered_.system.evaluate(state.x, levels, bordered_.R, nullptr).admissible()) return std::nullopt;
    Miss miss{copy_of(bordered_.R), {}};
    SOFT_PETSC(VecScale(miss.R, -1.0));
    bordered_.evaluate_rows(constraint, state);
    for (const auto& equation : bordered_.supply) miss.rows.push_back(-equation.value);
    miss.rows.push_back(remaining(constraint, bordered_.system.input(), target, bordered_.constraint.value));
    return miss;
}

double Newton::rounding_of_loads(const PathTangent& tangent) const {
    double force = std::abs(tangent.load_factor) * linalg::norm(bordered_.forces.back().out);
    for (std::size_t k = 0; k < tangent.pressures.size(); ++k)
        force += std::abs(tangent.pressures[k]) * linalg::norm(bordered_.forces[k].out);
    return rounding_N_ / force;
}

std::optional<Newton::Adjoint> Newton::adjoint_solve(Vec by_x, std::span<const double> by_loads) {
    if (bordered_.uses_differences()) return std::nullopt;
    std::vector<double> wanted(by_loads.begin(), by_loads.end());
    wanted.resize(static_cast<std::size_t>(bordered_.border.size), 0.0);
    auto adjoint = eliminate_transposed(by_x, wanted);
    if (adjoint && loses_digits_) {
        const linalg::Vector left = linalg::duplicate(by_x);
        SOFT_PETSC(MatMultTranspose(bordered_.K, adjoint->psi, left));
        SOFT_PETSC(VecAYPX(left, -1.0, by_x));
        bordered_.subtract_rows(adjoint->mu, left);
        for (std::size_t j = 0; j < wanted.size(); ++j) {
            wanted[j] += linalg::dot(bordered_.forces[j].out, adjoint->psi);
            for (std::size_t i = 0; i < wanted.size(); ++i)
                wanted[j] -= bordered_.by_loads.at(static_cast<int>(i), static_cast<int>(j)) * adjoint->mu[i];
        }
        if (const auto rest = eliminate_transposed(left, wanted)) {
            linalg::add(adjoint->psi, 1.0, rest->psi);
            for (std::size_t i = 0; i < wanted.size(); ++i) adjoint->mu[i] += rest->mu[i];
        }
    }
    if (adjoint) adjoint->mu.pop_back();
    return adjoint;
}

/// M = [[K, -F], [rows, D]]; with the border S = D + rows C and C = K^-1 F, M^-1 (b, r) is x = K^-1 b + C l, S l = r - rows K^-1 b.
std::optional<Newton::Adjoint> Newton::eliminate_transposed(Vec by_x, std::vector<double> by_border) {
    const int n = bordered_.border.size;
    linalg::SmallMatrix transposed(n);
    for (int i = 0; i < n; ++i) {
        by_border[static_cast<std::size_t>(i)] += linalg::dot(by_x, bordered_.columns[static_cast<std::size_t>(i)]);
        for (int j = 0; j < n; ++j) transposed.at(i, j) = bordered_.border.at(j, i);
    }
    auto mu = linalg::solve(transposed, by_border);
    if (!mu) return std::nullopt;
    const linalg::Vector rest = copy_of(by_x);
    bordered_.subtract_rows(*mu, rest);
    Adjoint adjoint{linalg::duplicate(by_x), std::move(*mu)};
    if (!bordered_.linear.solve_transposed(rest, adjoint.psi).converged) return std::nullopt;
    return adjoint;
}

}  // namespace soft::solver
