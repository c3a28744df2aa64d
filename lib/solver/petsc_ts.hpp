#pragma once
/// PETSc's TS on the equations of motion in first-order form, y = (x, v, masses of the lines); internal to the module.
///   implicit Euler (TSBEULER), Rosenbrock-W (TSROSW ra34pw2):  F(t, y, dy/dt) = 0 with
///       dx/dt - v = 0 (pressure unknowns: their rows of R),   M dv/dt + C v + R = 0,   dm/dt - flow = 0
///   Heun (TSRK 2a: c = 0, 1, b = 1/2, 1/2), explicit Euler (TSEULER):  dy/dt = G(t, y) by the lumped mass.
/// TS takes single steps; the caller controls the step size, failed steps and errors (without pressures). A linear
/// solve eliminates dv = s dx - r: one factorisation of K + s C + s^2 M. Options -ts_* are passed to TS.
/// Tested by solver/dynamics_test.
#include <exception>

#include <petscts.h>

#include "solver/implicit.hpp"

namespace soft::solver {

using TimeStepper = linalg::Owned<TS, TSDestroy>;

class TsIntegrator {
public:
    /// `solver`: for implicit integrators; nullptr for explicit ones.
    TsIntegrator(MotionEquations& equations, StageSolver* solver, model::Integrator integrator);
    TsIntegrator(const TsIntegrator&) = delete;  // PETSc stores its address
    TsIntegrator& operator=(const TsIntegrator&) = delete;
    void start(const MotionState&) {}
    [[nodiscard]] StepResult attempt(const MotionState& last, double step_s, MotionState& next);
    void accept() {}

    // Called back by PETSc.
    void implicit_function(double time_s, Vec y, Vec rate, Vec out);
    void implicit_matrix(double time_s, Vec y, double shift);
    void apply_inverse(Vec b, Vec out);
    void explicit_function(double time_s, Vec y, Vec out);
    [[nodiscard]] SNESConvergedReason test(int iteration);
    /// Runs the body of a callback; stores an exception until PETSc has returned.
    template <class Body>
    PetscErrorCode guarded(Body&& body);

private:
    void set_up_implicit(SNES snes);
    [[nodiscard]] bool is_rounding();
    void read_end(double time_s, MotionState& next, StepResult& result);
    void split(Vec y, Vec x, Vec v, std::vector<double>& masses) const;
    void join(Vec x, Vec v, std::span<const double> masses, Vec y) const;

    MotionEquations& equations_;
    StageSolver* solver_;
    model::Integrator integrator_;
    linalg::Vector y_, embedded_, residual_, x_, v_, rate_x_, rate_v_, out_x_, out_v_, inertia_, forces_;
    linalg::Matrix shell_;
    TimeStepper ts_;
    std::vector<double> masses_, rate_masses_;
    std::vector<LineRow> rows_;
    double shift_ = 0, relative_residual_ = 0, residual_before_ = 0, stage_time_s_ = 0;
    fem::Evaluation evaluation_;
    NewtonEnd failure_ = NewtonEnd::converged;
    std::exception_ptr thrown_;
};

}  // namespace soft::solver
