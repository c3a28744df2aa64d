#include "solver/petsc_ts.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace soft::solver {

using model::Integrator;

namespace {

bool is_implicit(Integrator integrator) {
    return integrator == Integrator::implicit_euler || integrator == Integrator::rosenbrock;
}

TsIntegrator& self(void* context) { return *static_cast<TsIntegrator*>(context); }

PetscErrorCode call_implicit_function(TS, PetscReal t, Vec y, Vec rate, Vec out, void* context) {
    return self(context).guarded([&] { self(context).implicit_function(t, y, rate, out); });
}

PetscErrorCode call_implicit_matrix(TS, PetscReal t, Vec y, Vec, PetscReal shift, Mat, Mat, void* context) {
    return self(context).guarded([&] { self(context).implicit_matrix(t, y, shift); });
}

PetscErrorCode call_explicit_function(TS, PetscReal t, Vec y, Vec out, void* context) {
    return self(context).guarded([&] { self(context).explicit_function(t, y, out); });
}

PetscErrorCode call_inverse(PC pc, Vec b, Vec out) {
    void* context = nullptr;
    PetscCall(PCShellGetContext(pc, &context));
    return self(context).guarded([&] { self(context).apply_inverse(b, out); });
}

/// The rows of x and v have different units: convergence is tested on the balance of forces.
PetscErrorCode call_test(SNES, PetscInt iteration, PetscReal, PetscReal, PetscReal, SNESConvergedReason* reason,
                         void* context) {
    return self(context).guarded([&] { *reason = self(context).test(iteration); });
}

}  // namespace

template <class Body>
PetscErrorCode TsIntegrator::guarded(Body&& body) {
    try {
        body();
        return 0;
    } catch (...) {
        thrown_ = std::current_exception();
        return PETSC_ERR_LIB;
    }
}

TsIntegrator::TsIntegrator(MotionEquations& equations, StageSolver* solver, Integrator integrator)
    : equations_(equations), solver_(solver), integrator_(integrator) {
    const auto& system = equations.system();
    for (auto* vector : {&x_, &v_, &rate_x_, &rate_v_, &out_x_, &out_v_, &inertia_, &forces_})
        *vector = system.make_vector();
    int rank = 0;
    MPI_Comm_rank(system.comm(), &rank);
    const PetscInt own = system.dofs().end - system.dofs().begin;
    const auto lines = static_cast<PetscInt>(equations.lines().count());
    SOFT_PETSC(VecCreate(system.comm(), y_.out()));
    SOFT_PETSC(VecSetSizes(y_, 2 * own + (rank == 0 ? lines : 0), 2 * system.dofs().total + lines));
    SOFT_PETSC(VecSetFromOptions(y_));
    embedded_ = linalg::duplicate(y_);
    residual_ = linalg::duplicate(y_);
    SOFT_PETSC(TSCreate(system.comm(), ts_.out()));
    SOFT_PETSC(TSSetProblemType(ts_, TS_NONLINEAR));
    switch (integrator) {
        case Integrator::implicit_euler: SOFT_PETSC(TSSetType(ts_, TSBEULER)); break;
        case Integrator::rosenbrock:
            SOFT_PETSC(TSSetType(ts_, TSROSW));
            SOFT_PETSC(TSRosWSetType(ts_, TSROSWRA34PW2));
            break;
        case Integrator::heun:
            SOFT_PETSC(TSSetType(ts_, TSRK));
            SOFT_PETSC(TSRKSetType(ts_, TSRK2A));
            break;
        default: SOFT_PETSC(TSSetType(ts_, TSEULER));
    }
    SOFT_PETSC(TSSetExactFinalTime(ts_, TS_EXACTFINALTIME_STEPOVER));
    SOFT_PETSC(TSSetMaxSteps(ts_, PETSC_MAX_INT));
    SOFT_PETSC(TSSetMaxTime(ts_, 2.0 * equations.dynamics().duration_s));  // required by TS; the caller ends earlier
    SOFT_PETSC(TSSetErrorIfStepFails(ts_, PETSC_FALSE));
    SOFT_PETSC(TSSetMaxStepRejections(ts_, 0));
    TSAdapt adapt = nullptr;
    SOFT_PETSC(TSGetAdapt(ts_, &adapt));
    SOFT_PETSC(TSAdaptSetType(adapt, TSADAPTNONE));
    if (is_implicit(integrator)) {
        SNES snes = nullptr;
        SOFT_PETSC(TSGetSNES(ts_, &snes));
        set_up_implicit(snes);
    } else {
        SOFT_PETSC(TSSetRHSFunction(ts_, residual_, call_explicit_function, this));
    }
    SOFT_PETSC(TSSetSolution(ts_, y_));
    SOFT_PETSC(TSSetFromOptions(ts_));
    SOFT_PETSC(TSSetUp(ts_));
}

void TsIntegrator::set_up_implicit(SNES snes) {
    PetscInt size = 0, total = 0;
    SOFT_PETSC(VecGetLocalSize(y_, &size));
    SOFT_PETSC(VecGetSize(y_, &total));
    SOFT_PETSC(MatCreateShell(equations_.system().comm(), size, size, total, total, this, shell_.out()));
    SOFT_PETSC(MatSetUp(shell_));
    SOFT_PETSC(TSSetIFunction(ts_, residual_, call_implicit_function, this));
    SOFT_PETSC(TSSetIJacobian(ts_, shell_, shell_, call_implicit_matrix, this));
    KSP ksp = nullptr;
    PC pc = nullptr;
    SOFT_PETSC(SNESGetKSP(snes, &ksp));
    SOFT_PETSC(KSPSetType(ksp, KSPPREONLY));
    SOFT_PETSC(KSPGetPC(ksp, &pc));
    SOFT_PETSC(PCSetType(pc, PCSHELL));
    SOFT_PETSC(PCShellSetContext(pc, this));
    SOFT_PETSC(PCShellSetApply(pc, call_inverse));
    if (integrator_ == Integrator::rosenbrock) {
        SOFT_PETSC(SNESSetType(snes, SNESKSPONLY));
        return;
    }
    SNESLineSearch search = nullptr;
    SOFT_PETSC(SNESSetType(snes, SNESNEWTONLS));
    SOFT_PETSC(SNESGetLineSearch(snes, &search));
    SOFT_PETSC(SNESLineSearchSetType(search, SNESLINESEARCHBASIC));  // others would multiply by the shell matrix
    SOFT_PETSC(SNESSetConvergenceTest(snes, call_test, this, nullptr));
}

SNESConvergedReason TsIntegrator::test(int iteration) {
    const auto& settings = equations_.system().input().solver;
    if (failure_ != NewtonEnd::converged || !std::isfinite(relative_residual_)) return SNES_DIVERGED_FUNCTION_DOMAIN;
    // The rows dx/dt = v are linear: the first correction satisfies them.
    if (iteration > 0 && (relative_residual_ <= settings.residual_tolerance || is_rounding()))
        return SNES_CONVERGED_FNORM_RELATIVE;
    residual_before_ = relative_residual_;
    return iteration >= settings.newton_limit ? SNES_DIVERGED_MAX_IT : SNES_CONVERGED_ITERATING;
}

/// At the state of implicit_function's last call. The equations of the supply lines need no such check.
bool TsIntegrator::is_rounding() {
    if (!stalls(relative_residual_, residual_before_)) return false;
    const auto pressures = equations_.lines().pressures(x_, masses_);
    return solver_->is_rounding(linalg::norm(forces_), x_, equations_.levels(stage_time_s_, pressures));
}

void TsIntegrator::split(Vec y, Vec x, Vec v, std::vector<double>& masses) const {
    PetscInt own = 0;
    SOFT_PETSC(VecGetLocalSize(x, &own));
    const PetscScalar* from = nullptr;
    SOFT_PETSC(VecGetArrayRead(y, &from));
    PetscScalar* to = nullptr;
    for (const auto& [part, begin] : {std::pair{x, PetscInt{0}}, std::pair{v, own}}) {
        SOFT_PETSC(VecGetArray(part, &to));
        std::copy_n(from + begin, own, to);
        SOFT_PETSC(VecRestoreArray(part, &to));
    }
    masses.assign(equations_.lines().count(), 0.0);
    int rank = 0;
    MPI_Comm_rank(equations_.system().comm(), &rank);
    if (rank == 0) std::copy_n(from + 2 * own, masses.size(), masses.begin());
    SOFT_PETSC(VecRestoreArrayRead(y, &from));
    MPI_Bcast(masses.data(), static_cast<int>(masses.size()), MPI_DOUBLE, 0, equations_.system().comm());
}

void TsIntegrator::join(Vec x, Vec v, std::span<const double> masses, Vec y) const {
    PetscInt own = 0;
    SOFT_PETSC(VecGetLocalSize(x, &own));
    PetscScalar* to = nullptr;
    SOFT_PETSC(VecGetArray(y, &to));
    const PetscScalar* from = nullptr;
    for (const auto& [part, begin] : {std::pair{x, PetscInt{0}}, std::pair{v, own}}) {
        SOFT_PETSC(VecGetArrayRead(part, &from));
        std::copy_n(from, own, to + begin);
        SOFT_PETSC(VecRestoreArrayRead(part, &from));
    }
    int rank = 0;
    MPI_Comm_rank(equations_.system().comm(), &rank);
    if (rank == 0) std::ranges::copy(masses, to + 2 * own);
    SOFT_PETSC(VecRestoreArray(y, &to));
}

void TsIntegrator::implicit_function(double time_s, Vec y, Vec rate, Vec out) {
    split(y, x_, v_, masses_);
    split(rate, rate_x_, rate_v_, rate_masses_);
    const auto pressures = equations_.lines().pressures(x_, masses_);
    evaluation_ = equations_.evaluate(x_, equations_.levels(time_s, pressures), nullptr);
    if (!evaluation_.admissible()) failure_ = NewtonEnd::inverted;  // R is incomplete: the step is rejected
    SOFT_PETSC(VecZeroEntries(inertia_));
    equations_.add_inertia(inertia_, 1.0, rate_v_);
    SOFT_PETSC(VecWAXPY(forces_, 1.0, inertia_, equations_.residual()));
    equations_.add_damping(forces_, 1.0, v_);
    relative_residual_ = StageSolver::relative_residual(forces_, solver_->force_scale(evaluation_, inertia_));
    stage_time_s_ = time_s;
    // Rows of x: dx/dt - v, and at pressure unknowns, whose v is always 0, the residual of their equations.
    SOFT_PETSC(VecPointwiseMult(out_v_, equations_.mask(), forces_));
    SOFT_PETSC(VecWAXPY(out_x_, -1.0, v_, rate_x_));
    SOFT_PETSC(VecPointwiseMult(out_x_, equations_.mask(), out_x_));
    SOFT_PETSC(VecAXPBYPCZ(out_x_, 1.0, -1.0, 1.0, forces_, out_v_));
    auto flows = equations_.lines().flows(time_s, pressures);
    for (std::size_t k = 0; k < flows.size(); ++k) {
        flows[k] = rate_masses_[k] - flows[k];
        relative_residual_ = std::max(
            relative_residual_, std::abs(flows[k]) / (equations_.lines().conductance(k) * line_pressure_scale_Pa));
    }
    join(out_x_, out_v_, flows, out);
}

void TsIntegrator::implicit_matrix(double time_s, Vec y, double shift) {
    shift_ = shift;
    split(y, x_, v_, masses_);
    const auto volumes = solver_->read_volumes(x_);
    std::vector<double> pressures;
    rows_.clear();
    for (std::size_t k = 0; k < volumes.size(); ++k) {
        const auto gas = equations_.lines().pressure(k, volumes[k], masses_[k]);
        pressures.push_back(gas.value_Pa);
        rows_.push_back(
            {1.0 + gas.by_mass * equations_.lines().conductance(k) / shift, -gas.by_volume, gas.by_mass / shift});
    }
    if (!solver_->factorize(x_, equations_.levels(time_s, pressures), shift, shift * shift))
        failure_ = NewtonEnd::singular;
}

/// dv = s dx - r_x,   (K + s C + s^2 M) dx = r_v + (s M + C) r_x + sum dp f,   dm = (r_m - conductance dp) / s.
void TsIntegrator::apply_inverse(Vec b, Vec out) {
    std::vector<double> rhs;
    split(b, rate_x_, rate_v_, rhs);
    SOFT_PETSC(VecPointwiseMult(x_, equations_.mask(), rate_x_));
    linalg::copy(rate_v_, v_);
    equations_.add_inertia(v_, shift_, x_);
    equations_.add_damping(v_, 1.0, x_);
    linalg::add(v_, 1.0, rate_x_);  // pressure rows are in the x part
    linalg::add(v_, -1.0, x_);
    std::vector<LineRow> rows = rows_;
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k].rhs *= rhs[k];
    std::vector<double> dp;
    if (failure_ != NewtonEnd::converged || !solver_->solve_linear(v_, rows, out_x_, dp)) {
        if (failure_ == NewtonEnd::converged) failure_ = NewtonEnd::singular;
        SOFT_PETSC(VecZeroEntries(out));
        return;
    }
    SOFT_PETSC(VecPointwiseMult(out_v_, equations_.mask(), out_x_));
    SOFT_PETSC(VecAXPBY(out_v_, -1.0, shift_, x_));
    for (std::size_t k = 0; k < dp.size(); ++k) rhs[k] = (rhs[k] - equations_.lines().conductance(k) * dp[k]) / shift_;
    join(out_x_, out_v_, rhs, out);
}

void TsIntegrator::explicit_function(double time_s, Vec y, Vec out) {
    split(y, x_, v_, masses_);
    const auto pressures = equations_.lines().pressures(x_, masses_);
    evaluation_ = equations_.evaluate(x_, equations_.levels(time_s, pressures), nullptr);
    if (!evaluation_.admissible()) failure_ = NewtonEnd::inverted;
    linalg::copy(equations_.residual(), out_v_);
    equations_.add_damping(out_v_, 1.0, v_);
    SOFT_PETSC(VecScale(out_v_, -1.0));
    SOFT_PETSC(VecPointwiseDivide(out_v_, out_v_, equations_.lumped_mass()));
    join(v_, out_v_, equations_.lines().flows(time_s, pressures), out);
}

StepResult TsIntegrator::attempt(const MotionState& last, double step_s, MotionState& next) {
    failure_ = NewtonEnd::converged;
    join(last.x, last.v, last.masses_kg, y_);
    SOFT_PETSC(TSSetTime(ts_, last.time_s));
    SOFT_PETSC(TSSetTimeStep(ts_, step_s));
    SOFT_PETSC(TSSetConvergedReason(ts_, TS_CONVERGED_ITERATING));
    SOFT_PETSC(TSRestartStep(ts_));
    const PetscErrorCode code = TSStep(ts_);
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
    linalg::check(code, "TSStep");
    TSConvergedReason reason = TS_CONVERGED_ITERATING;
    SOFT_PETSC(TSGetConvergedReason(ts_, &reason));
    StepResult result;
    result.newton.residual = relative_residual_;
    result.newton.min_jacobian = evaluation_.min_jacobian;
    result.newton.worst_cell = evaluation_.worst_cell;
    if (is_implicit(integrator_)) {
        PetscInt iterations = 0;
        SNES snes = nullptr;
        SOFT_PETSC(TSGetSNES(ts_, &snes));
        SOFT_PETSC(SNESGetIterationNumber(snes, &iterations));
        result.newton.iterations = static_cast<int>(iterations);
    }
    if (failure_ == NewtonEnd::converged && reason < 0) failure_ = NewtonEnd::iteration_limit;
    if (failure_ == NewtonEnd::converged) read_end(last.time_s + step_s, next, result);
    result.newton.end = failure_;
    return result;
}

/// Reads the state at the end of a TS step, and its error where the method has an embedded formula.
void TsIntegrator::read_end(double time_s, MotionState& next, StepResult& result) {
    next.time_s = time_s;
    split(y_, next.x, next.v, next.masses_kg);
    if (!std::isfinite(linalg::norm(next.x)) || !std::isfinite(linalg::norm(next.v))) {
        failure_ = NewtonEnd::not_finite;
        return;
    }
    const auto end = equations_.evaluate(
        next.x, equations_.levels(time_s, equations_.lines().pressures(next.x, next.masses_kg)), nullptr);
    if (!end.admissible()) failure_ = NewtonEnd::inverted;
    result.newton.min_jacobian = end.min_jacobian;
    result.newton.worst_cell = end.worst_cell;
    linalg::copy(equations_.load_force(), next.load_force);
    if (integrator_ != Integrator::rosenbrock) return;
    PetscBool done = PETSC_TRUE;
    SOFT_PETSC(TSEvaluateStep(ts_, 2, embedded_, &done));  // of second order
    split(embedded_, x_, v_, masses_);
    linalg::add(x_, -1.0, next.x);
    result.error_m = equations_.displacement_norm(x_);
}

}  // namespace soft::solver
