#include "solver/stage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fem/element_levels.hpp"
#include "mesh/mesh.hpp"

namespace soft::solver {

namespace {

constexpr int inversion_halvings = 4;
/// Relative to the body's extent: for cells down to a hundredth of it, the squares of the strains are below rounding.
constexpr double linear_share = 1e-11;
/// Times the measured rounding error, which differs from state to state.
constexpr double second_difference_margin = 10.0;
/// Fraction of the largest force scale of the motion so far: a body in free flight has no forces.
constexpr double free_flight_forces = 1e-3;

/// J is assembled with mass and damping: the Jacobian-free method becomes a Krylov method with this matrix.
model::LinearSettings with_a_matrix(model::LinearSettings settings) {
    if (settings.method == model::LinearMethod::jacobian_free) settings.method = model::LinearMethod::krylov;
    return settings;
}

}  // namespace

StageSolver::StageSolver(MotionEquations& equations)
    : equations_(equations),
      settings_(equations.system().input().solver),
      J_(equations.system().make_matrix()),
      solver_(J_, symmetry_of(equations.system()),
              with_a_matrix(fem::choose_linear(settings_.linear, equations.system().input(),
                                               equations.system().dofs().total, symmetry_of(equations.system()))),
              settings_.threads),
      r_(equations.system().make_vector()),
      dx_(equations.system().make_vector()),
      inertia_(equations.system().make_vector()),
      masked_(equations.system().make_vector()) {
    fem::configure_preconditioner(solver_, equations.system(), J_);
    for (std::size_t k = 0; k < equations.lines().count(); ++k) {
        columns_.push_back(equations.system().make_vector());
        gradients_.push_back(equations.system().make_vector());
    }
}

std::vector<double> StageSolver::read_volumes(Vec x) {
    std::vector<double> volumes;
    for (std::size_t k = 0; k < gradients_.size(); ++k)
        volumes.push_back(equations_.lines().volume(k, x, gradients_[k]));
    return volumes;
}

/// p - P(V(x), m0 + share dm/dt(p)) = 0.
std::vector<LineRow> StageSolver::line_rows(const StageMap& map, const MotionState& state,
                                            std::span<const double> pressures) {
    const auto volumes = read_volumes(state.x);
    std::vector<LineRow> rows;
    for (std::size_t k = 0; k < volumes.size(); ++k) {
        const double mass = map.masses_kg[k] + map.flow_share * equations_.lines().flow(k, state.time_s, pressures[k]);
        const auto gas = equations_.lines().pressure(k, volumes[k], mass);
        rows.push_back({1.0 + gas.by_mass * map.flow_share * equations_.lines().conductance(k), -gas.by_volume,
                        gas.value_Pa - pressures[k]});
    }
    return rows;
}

void StageSolver::move(const StageMap& map, double length, Vec dx, MotionState& state) {
    linalg::add(state.x, length, dx);
    SOFT_PETSC(VecPointwiseMult(masked_, equations_.mask(), dx));
    linalg::add(state.v, length * map.by_velocity, masked_);
    linalg::add(state.a, length * map.by_acceleration, masked_);
}

bool StageSolver::factorize_here(double by_velocity, double by_acceleration) {
    equations_.add_matrices(J_, by_velocity, by_acceleration);
    return solver_.factorize().succeeded;
}

bool StageSolver::factorize(Vec x, const fem::LoadLevels& levels, double by_velocity, double by_acceleration) {
    const auto evaluation = equations_.evaluate(x, levels, J_);
    if (evaluation.pattern_grew) solver_.pattern_changed();
    return evaluation.admissible() && factorize_here(by_velocity, by_acceleration);
}

bool StageSolver::solve_linear(Vec b, std::span<const LineRow> rows, Vec dx, std::vector<double>& dp) {
    if (!solver_.solve(b, dx).usable()) return false;
    const int n = static_cast<int>(rows.size());
    dp.assign(rows.size(), 0.0);
    if (n == 0) return true;
    linalg::SmallMatrix border(n);
    std::vector<double> wanted;
    for (int k = 0; k < n; ++k) {
        const auto row = static_cast<std::size_t>(k);
        if (!solver_.solve(equations_.line_force(row), columns_[row]).usable()) return false;
        wanted.push_back(rows[row].rhs - rows[row].by_volume * linalg::dot(gradients_[row], dx));
    }
    for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j) {
            const auto row = static_cast<std::size_t>(k), column = static_cast<std::size_t>(j);
            border.at(k, j) = rows[row].by_volume * linalg::dot(gradients_[row], columns_[column]) +
                              (k == j ? rows[row].by_pressure : 0.0);
        }
    const auto solution = linalg::solve(border, wanted);
    if (!solution) return false;
    dp = *solution;
    for (std::size_t k = 0; k < dp.size(); ++k) linalg::add(dx, dp[k], columns_[k]);
    return true;
}

double StageSolver::force_scale(const fem::Evaluation& evaluation, Vec inertia) {
    const double scale =
        std::max({evaluation.force_scale, linalg::norm(equations_.load_force()), linalg::norm(inertia)});
    max_scale_ = std::max(max_scale_, scale);
    return std::max(scale, free_flight_forces * max_scale_);
}

double StageSolver::relative_residual(Vec forces, double scale) {
    const double norm = linalg::norm(forces);
    return scale > 0.0 ? norm / scale : norm > 0.0 ? 1.0 : 0.0;  // an obstacle pushes on a body at rest
}

bool StageSolver::is_rounding(double residual_N, Vec x, const fem::LoadLevels& levels) {
    if (probe_.get() == nullptr) {
        probe_ = equations_.system().make_vector();
        fill_with_waves(probe_);
        SOFT_PETSC(VecPointwiseMult(probe_, equations_.mask(), probe_));
        SOFT_PETSC(VecScale(probe_, linear_share * mesh::extent_m(equations_.system().input().mesh)));
    }
    linalg::Vector moved = linalg::duplicate(x), difference = linalg::duplicate(x);
    SOFT_PETSC(VecZeroEntries(difference));
    for (const auto& [steps, weight] : {std::pair{2.0, 1.0}, std::pair{1.0, -2.0}, std::pair{0.0, 1.0}}) {
        SOFT_PETSC(VecWAXPY(moved, steps, probe_, x));
        if (!equations_.evaluate(moved, levels, nullptr).admissible()) return false;
        linalg::add(difference, weight, equations_.residual());
    }
    return residual_N <= second_difference_margin * linalg::norm(difference);
}

/// Computes r_ = M a + C v + R at the state last evaluated; returns its norm over the force scale.
double StageSolver::balance(const MotionState& state, const fem::Evaluation& evaluation) {
    linalg::copy(equations_.residual(), r_);
    SOFT_PETSC(VecZeroEntries(inertia_));
    equations_.add_inertia(inertia_, 1.0, state.a);
    linalg::add(r_, 1.0, inertia_);
    equations_.add_damping(r_, 1.0, state.v);
    return relative_residual(r_, force_scale(evaluation, inertia_));
}

fem::Evaluation StageSolver::evaluate(const MotionState& state, std::span<const double> pressures, Mat K,
                                      NewtonResult& result) {
    const auto evaluation = equations_.evaluate(state.x, equations_.levels(state.time_s, pressures), K);
    if (evaluation.pattern_grew) solver_.pattern_changed();
    result.min_jacobian = evaluation.min_jacobian;
    result.worst_cell = evaluation.worst_cell;
    return evaluation;
}

/// Newton's correction of the state, halved while an element is inverted.
NewtonEnd StageSolver::correct(const StageMap& map, std::span<const LineRow> rows, MotionState& state,
                               std::vector<double>& pressures, NewtonResult& result) {
    if (!factor_is_of_stage_ || settings_.newton == model::NewtonMethod::full) {
        (void)evaluate(state, pressures, J_, result);
        if (!factorize_here(map.by_velocity, map.by_acceleration)) return NewtonEnd::singular;
        factor_is_of_stage_ = true;
    }
    std::vector<double> dp;
    SOFT_PETSC(VecScale(r_, -1.0));
    if (!solve_linear(r_, rows, dx_, dp)) return NewtonEnd::linear_solver;
    double length = 1.0;
    for (int halvings = 0;; ++halvings) {
        move(map, length, dx_, state);
        for (std::size_t k = 0; k < dp.size(); ++k) pressures[k] += length * dp[k];
        evaluation_ = evaluate(state, pressures, nullptr, result);
        if (evaluation_.admissible() || halvings == inversion_halvings) return NewtonEnd::converged;
        length = -std::ldexp(0.5, -halvings);  // back by a half, a quarter, ...
    }
}

NewtonResult StageSolver::solve(const StageMap& map, Vec fallback, MotionState& state) {
    NewtonResult result;
    const auto report = [&](NewtonEnd end) {
        result.end = end;
        return result;
    };
    auto pressures = equations_.lines().pressures(state.x, map.masses_kg);
    evaluation_ = evaluate(state, pressures, nullptr, result);
    if (!evaluation_.admissible()) {
        SOFT_PETSC(VecWAXPY(dx_, -1.0, state.x, fallback));
        move(map, 1.0, dx_, state);
        evaluation_ = evaluate(state, pressures, nullptr, result);
    }
    factor_is_of_stage_ = false;
    double before = std::numeric_limits<double>::infinity();
    for (;; ++result.iterations) {
        if (!evaluation_.admissible()) return report(NewtonEnd::inverted);
        result.residual = balance(state, evaluation_);
        if (!std::isfinite(result.residual)) return report(NewtonEnd::not_finite);
        const auto rows = line_rows(map, state, pressures);
        const bool supplied = std::ranges::all_of(rows, [&](const LineRow& row) {
            return std::abs(row.rhs) <= settings_.residual_tolerance * line_pressure_scale_Pa;
        });
        const auto no_more_digits = [&] {
            return stalls(result.residual, before) &&
                   is_rounding(linalg::norm(r_), state.x, equations_.levels(state.time_s, pressures));
        };
        if (supplied && (result.residual <= settings_.residual_tolerance || no_more_digits())) break;
        before = result.residual;
        if (result.iterations == settings_.newton_limit) return report(NewtonEnd::iteration_limit);
        if (const auto end = correct(map, rows, state, pressures, result); end != NewtonEnd::converged)
            return report(end);
    }
    state.masses_kg = map.masses_kg;
    for (std::size_t k = 0; k < pressures.size(); ++k)
        state.masses_kg[k] += map.flow_share * equations_.lines().flow(k, state.time_s, pressures[k]);
    linalg::copy(equations_.load_force(), state.load_force);
    return report(NewtonEnd::converged);
}

}  // namespace soft::solver
