#include "solver/dynamics_stage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace soft::solver {

namespace {

constexpr int inversion_halvings = 5;
/// Times the tolerance, of a residual that has come down to rounding and stays above this part of the one before.
constexpr double rounding = 100.0, stalled = 0.3;
/// Of the largest scale of forces in the motion so far: a body in free flight has none.
constexpr double vanishing_forces = 1e-3;

linalg::Symmetry symmetry_of(const assembly::System& system) {
    return system.has_symmetric_tangent() ? linalg::Symmetry::symmetric : linalg::Symmetry::general;
}

/// J is assembled, mass and damping with it: the Jacobian-free method runs on it as plain Krylov.
model::LinearSettings with_a_matrix(model::LinearSettings settings) {
    if (settings.method == model::LinearMethod::jacobian_free) settings.method = model::LinearMethod::krylov;
    return settings;
}

}  // namespace

bool balances(double residual, double before, const model::SolverSettings& settings) {
    return residual <= (residual > stalled * before ? rounding : 1.0) * settings.residual_tolerance;
}

StageSolver::StageSolver(MotionEquations& equations)
    : equations_(equations), settings_(equations.system().input().solver), J_(equations.system().make_matrix()),
      solver_(J_, symmetry_of(equations.system()), with_a_matrix(settings_.linear)), r_(equations.system().make_vector()), dx_(equations.system().make_vector()),
      inertia_(equations.system().make_vector()), masked_(equations.system().make_vector()) {
    for (std::size_t k = 0; k < equations.line_count(); ++k) {
        columns_.push_back(equations.system().make_vector());
        gradients_.push_back(equations.system().make_vector());
    }
}

std::vector<double> StageSolver::read_volumes(Vec x) {
    std::vector<double> volumes;
    for (std::size_t k = 0; k < gradients_.size(); ++k) volumes.push_back(equations_.line_volume(k, x, gradients_[k]));
    return volumes;
}

/// p - P(V(x), m0 + share dm/dt(p)) = 0.
std::vector<LineRow> StageSolver::line_rows(const StageMap& map, const MotionState& state, std::span<const double> pressures) {
    const auto volumes = read_volumes(state.x);
    std::vector<LineRow> rows;
    for (std::size_t k = 0; k < volumes.size(); ++k) {
        const double mass = map.masses_kg[k] + map.flow_share * equations_.mass_flow(k, state.time_s, pressures[k]);
        const auto gas = equations_.gas_pressure(k, volumes[k], mass);
        rows.push_back({1.0 + gas.by_mass * map.flow_share * equations_.conductance(k), -gas.by_volume,
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

bool StageSolver::factorize(Vec x, const LoadLevels& levels, double by_velocity, double by_acceleration) {
    return equations_.evaluate(x, levels, J_).admissible() && factorize_here(by_velocity, by_acceleration);
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

double StageSolver::force_scale(const assembly::Evaluation& evaluation, Vec inertia) {
    const double scale =
        std::max({evaluation.force_scale, linalg::norm(equations_.load_force()), linalg::norm(inertia)});
    largest_scale_ = std::max(largest_scale_, scale);
    return std::max(scale, vanishing_forces * largest_scale_);
}

StageResult StageSolver::solve(const StageMap& map, Vec fallback, MotionState& state) {
    StageResult result;
    auto pressures = equations_.line_pressures(state.x, map.masses_kg);
    const auto evaluate = [&](Mat K) {
        const auto evaluation = equations_.evaluate(state.x, equations_.levels(state.time_s, pressures), K);
        result.min_jacobian = evaluation.min_jacobian;
        result.worst_cell = evaluation.worst_cell;
        return evaluation;
    };
    const auto report = [&](NewtonEnd end) {
        result.end = end;
        return result;
    };
    auto evaluation = evaluate(nullptr);
    if (!evaluation.admissible()) {
        SOFT_PETSC(VecWAXPY(dx_, -1.0, state.x, fallback));
        move(map, 1.0, dx_, state);
        evaluation = evaluate(nullptr);
    }
    std::vector<double> dp;
    bool factorized = false;
    double before = std::numeric_limits<double>::infinity();
    for (;;) {
        if (!evaluation.admissible()) return report(NewtonEnd::inverted);
        linalg::copy(equations_.residual(), r_);
        SOFT_PETSC(VecZeroEntries(inertia_));
        equations_.add_inertia(inertia_, 1.0, state.a);
        linalg::add(r_, 1.0, inertia_);
        equations_.add_damping(r_, 1.0, state.v);
        const double residual = linalg::norm(r_), scale = force_scale(evaluation, inertia_);
        result.residual = scale > 0.0 ? residual / scale : 0.0;
        const auto rows = line_rows(map, state, pressures);
        const bool supplied = std::ranges::all_of(rows, [&](const LineRow& row) {
            return std::abs(row.rhs) <= settings_.residual_tolerance * 1e5;   // of the order of the ambient pressure [Pa]
        });
        if (!std::isfinite(residual)) return report(NewtonEnd::not_finite);
        if (supplied && balances(result.residual, before, settings_)) break;
        before = result.residual;
        if (result.iterations == settings_.newton_limit) return report(NewtonEnd::iteration_limit);
        ++result.iterations;
        if (!factorized || settings_.newton == model::NewtonMethod::full) {
            if (!evaluate(J_).admissible() || !factorize_here(map.by_velocity, map.by_acceleration))
                return report(NewtonEnd::singular);
            factorized = true;
        }
        SOFT_PETSC(VecScale(r_, -1.0));
        if (!solve_linear(r_, rows, dx_, dp)) return report(NewtonEnd::linear_solver);
        move(map, 1.0, dx_, state);
        for (std::size_t k = 0; k < dp.size(); ++k) pressures[k] += dp[k];
        evaluation = evaluate(nullptr);
        for (double length = 0.5; !evaluation.admissible() && length > std::ldexp(1.0, -inversion_halvings); length *= 0.5) {
            move(map, -length, dx_, state);
            for (std::size_t k = 0; k < dp.size(); ++k) pressures[k] -= length * dp[k];
            evaluation = evaluate(nullptr);
        }
    }
    state.masses_kg = map.masses_kg;
    for (std::size_t k = 0; k < pressures.size(); ++k)
        state.masses_kg[k] += map.flow_share * equations_.mass_flow(k, state.time_s, pressures[k]);
    linalg::copy(equations_.load_force(), state.load_force);
    return report(NewtonEnd::converged);
}

}  // namespace soft::solver
