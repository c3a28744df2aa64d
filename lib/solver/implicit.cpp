#include "solver/implicit.hpp"

#include <array>
#include <cmath>

#include "core/error.hpp"

namespace soft::solver {

namespace {

constexpr int stages = 6;
constexpr double diagonal = 0.25;
constexpr std::array<std::array<double, stages>, stages> table{{
    {},
    {1.0 / 4, 1.0 / 4},
    {8611.0 / 62500, -1743.0 / 31250, 1.0 / 4},
    {5012029.0 / 34652500, -654441.0 / 2922500, 174375.0 / 388108, 1.0 / 4},
    {15267082809.0 / 155376265600, -71443401.0 / 120774400, 730878875.0 / 902184768, 2285395.0 / 8070912, 1.0 / 4},
    {82889.0 / 524892, 0.0, 15625.0 / 83664, 69875.0 / 102672, -2260.0 / 8211, 1.0 / 4},
}};
constexpr std::array<double, stages> embedded{4586570599.0 / 29645900160, 0.0,
                                              178811875.0 / 945068544,    814220225.0 / 1159782912,
                                              -3700637.0 / 11593932,      61727.0 / 225920};

constexpr double start_share = 1e-4;  // relative to the step
constexpr int start_solves = 3;       // each reduces the error to 1e-8 (w h)^2 of itself

}  // namespace

/// Iterates (K + s^2 M) d = f + K d_before, with only the displacements of d on the right-hand side. The limit is
/// s^2 M d + (pressures) = f, with the pressure rows K_pu d + K_pp p = 0.
bool start_acceleration(MotionEquations& equations, StageSolver& solver, double step_s, MotionState& state) {
    const double square = 1.0 / std::pow(start_share * step_s, 2);
    const auto levels = equations.levels(state.time_s, equations.lines().pressures(state.x, state.masses_kg));
    if (!solver.factorize(state.x, levels, 0.0, square)) return false;
    linalg::Vector force = linalg::duplicate(state.x), dx = linalg::duplicate(state.x),
                   moved = linalg::duplicate(state.x), right = linalg::duplicate(state.x);
    linalg::copy(equations.residual(), force);
    equations.add_damping(force, 1.0, state.v);
    SOFT_PETSC(VecScale(force, -1.0));
    linalg::copy(equations.load_force(), state.load_force);
    (void)solver.read_volumes(state.x);
    const std::vector<LineRow> fixed_pressures(equations.lines().count());
    std::vector<double> dp;
    for (int i = 0; i < start_solves; ++i) {
        SOFT_PETSC(MatMult(solver.matrix(), moved, right));
        equations.add_inertia(right, -square, moved);
        SOFT_PETSC(VecPointwiseMult(right, equations.mask(), right));
        linalg::add(right, 1.0, force);
        if (!solver.solve_linear(right, fixed_pressures, dx, dp)) return false;
        SOFT_PETSC(VecPointwiseMult(moved, equations.mask(), dx));
    }
    SOFT_PETSC(VecZeroEntries(state.a));
    linalg::add(state.a, square, moved);
    linalg::add(dx, -1.0, moved);  // only the pressures
    linalg::add(state.x, 1.0, dx);
    return true;
}

double AlphaParameters::error_constant() const { return std::abs(beta + 0.5 * (alpha_m - alpha_f) - 1.0 / 6.0); }

AlphaParameters alpha_parameters(model::Integrator integrator, double spectral_radius) {
    AlphaParameters p;
    const double rho = spectral_radius;
    if (integrator == model::Integrator::generalized_alpha) {
        p.alpha_m = (2.0 * rho - 1.0) / (rho + 1.0);
        p.alpha_f = rho / (rho + 1.0);
    }
    if (integrator == model::Integrator::hht) p.alpha_f = (1.0 - rho) / (1.0 + rho);
    const double shift = p.alpha_f - p.alpha_m;
    p.gamma = 0.5 + shift;
    p.beta = 0.25 * (1.0 + shift) * (1.0 + shift);
    return p;
}

GeneralizedAlpha::GeneralizedAlpha(MotionEquations& equations, StageSolver& solver, const AlphaParameters& parameters)
    : equations_(equations),
      solver_(solver),
      p_(parameters),
      w_(equations.system().make_vector()),
      next_w_(equations.system().make_vector()) {}

void GeneralizedAlpha::start(const MotionState& state) {
    linalg::copy(state.a, w_);
    flow_w_ = equations_.lines().flows(state.time_s, equations_.lines().pressures(state.x, state.masses_kg));
    next_flow_w_ = flow_w_;
}

StepResult GeneralizedAlpha::attempt(const MotionState& last, double step_s, MotionState& next) {
    const double h = step_s;
    // Initial guess: w1 = w0. Then x is the unknown: w1 = w0 + (x1 - guess) / (beta h^2).
    linalg::copy(last.x, next.x);
    linalg::add(next.x, h, last.v);
    linalg::add(next.x, 0.5 * h * h, w_);
    linalg::copy(last.v, next.v);
    linalg::add(next.v, h, w_);
    SOFT_PETSC(VecZeroEntries(next.a));
    linalg::add(next.a, 1.0 / (1.0 - p_.alpha_f), w_);
    linalg::add(next.a, -p_.alpha_f / (1.0 - p_.alpha_f), last.a);
    linalg::copy(next.x, next_w_);  // the initial guess of x, until the solve
    next.time_s = last.time_s + h;
    StageMap map{p_.gamma / (p_.beta * h), (1.0 - p_.alpha_m) / ((1.0 - p_.alpha_f) * p_.beta * h * h), 0.0,
                 last.masses_kg};
    const double flow_part = h * p_.gamma / (1.0 - p_.alpha_m);
    map.flow_share = flow_part * (1.0 - p_.alpha_f);
    std::vector<double> flows;
    if (equations_.lines().count() > 0)
        flows = equations_.lines().flows(last.time_s, equations_.lines().pressures(last.x, last.masses_kg));
    for (std::size_t k = 0; k < flows.size(); ++k)
        map.masses_kg[k] +=
            h * (1.0 - p_.gamma) * flow_w_[k] + flow_part * (p_.alpha_f * flows[k] - p_.alpha_m * flow_w_[k]);
    StepResult result{solver_.solve(map, last.x, next), std::nullopt};
    if (result.newton.end != NewtonEnd::converged) return result;
    linalg::Vector change = linalg::duplicate(next.x);
    SOFT_PETSC(VecWAXPY(change, -1.0, next_w_, next.x));
    SOFT_PETSC(VecPointwiseMult(next_w_, equations_.mask(), change));
    SOFT_PETSC(VecAYPX(next_w_, 1.0 / (p_.beta * h * h), w_));
    for (std::size_t k = 0; k < flows.size(); ++k) {
        const double now = (next.masses_kg[k] - map.masses_kg[k]) / map.flow_share;
        next_flow_w_[k] =
            ((1.0 - p_.alpha_f) * now + p_.alpha_f * flows[k] - p_.alpha_m * flow_w_[k]) / (1.0 - p_.alpha_m);
    }
    return result;
}

void GeneralizedAlpha::accept() {
    linalg::copy(next_w_, w_);
    flow_w_ = next_flow_w_;
}

Dirk::Dirk(MotionEquations& equations, StageSolver& solver)
    : equations_(equations), solver_(solver), flows_(stages), error_(equations.system().make_vector()) {
    for (int i = 0; i < stages; ++i) {
        velocities_.push_back(equations.system().make_vector());
        accelerations_.push_back(equations.system().make_vector());
    }
}

void Dirk::start(const MotionState&) {}

StepResult Dirk::attempt(const MotionState& last, double step_s, MotionState& next) {
    const double h = step_s;
    linalg::copy(last.v, velocities_[0]);
    linalg::copy(last.a, accelerations_[0]);
    flows_[0] = equations_.lines().flows(last.time_s, equations_.lines().pressures(last.x, last.masses_kg));
    linalg::Vector pressures = linalg::duplicate(last.x), displacements = linalg::duplicate(last.x);
    SOFT_PETSC(VecPointwiseMult(displacements, equations_.mask(), last.x));
    SOFT_PETSC(VecWAXPY(pressures, -1.0, displacements, last.x));
    StepResult result;
    for (std::size_t i = 1; i < stages; ++i) {
        const double part = h * diagonal;
        // Initial guess: acceleration and pressures of the previous stage; the sums of slopes contain no pressures.
        SOFT_PETSC(VecWAXPY(next.x, 1.0, displacements, pressures));
        linalg::copy(last.v, next.v);
        double share = 0;
        StageMap map{1.0 / part, 1.0 / (part * part), part, last.masses_kg};
        for (std::size_t j = 0; j < i; ++j) {
            linalg::add(next.x, h * table[i][j], velocities_[j]);
            linalg::add(next.v, h * table[i][j], accelerations_[j]);
            for (std::size_t k = 0; k < map.masses_kg.size(); ++k) map.masses_kg[k] += h * table[i][j] * flows_[j][k];
            share += table[i][j];
        }
        linalg::copy(accelerations_[i - 1], next.a);
        linalg::add(next.v, part, next.a);
        linalg::add(next.x, part, next.v);
        next.time_s = last.time_s + h * (share + diagonal);
        const auto stage = solver_.solve(map, last.x, next);
        const int iterations = result.newton.iterations + stage.iterations;
        result.newton = stage;
        result.newton.iterations = iterations;
        if (stage.end != NewtonEnd::converged) return result;
        linalg::copy(next.v, velocities_[i]);
        linalg::copy(next.a, accelerations_[i]);
        flows_[i].resize(map.masses_kg.size());
        for (std::size_t k = 0; k < map.masses_kg.size(); ++k)
            flows_[i][k] = (next.masses_kg[k] - map.masses_kg[k]) / part;
        SOFT_PETSC(VecPointwiseMult(error_, equations_.mask(), next.x));
        SOFT_PETSC(VecWAXPY(pressures, -1.0, error_, next.x));
    }
    next.time_s = last.time_s + h;
    SOFT_PETSC(VecZeroEntries(error_));
    for (std::size_t i = 0; i < stages; ++i)
        linalg::add(error_, h * (table[stages - 1][i] - embedded[i]), velocities_[i]);
    result.error_m = linalg::norm(error_);
    return result;
}

}  // namespace soft::solver
