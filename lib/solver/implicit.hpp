#pragma once
/// Implicit integrators that PETSc's TS does not have in this form, on one stage solver; internal to the module.
/// Tested by solver/dynamics_test.
///
/// Generalised alpha, in the form of Arnold and Bruels, Multibody System Dynamics 18 (2007) 185: the equations of motion are satisfied
/// at the end of the step; an auxiliary variable w contains the averages,
///   (1 - alpha_m) w1 + alpha_m w0 = (1 - alpha_f) a1 + alpha_f a0
///   x1 = x0 + h v0 + h^2 ((1/2 - beta) w0 + beta w1),   v1 = v0 + h ((1 - gamma) w0 + gamma w1).
/// Equal to Chung and Hulbert (J. Appl. Mech. 60 (1993) 371) for linear forces, and of second order in x and v where the
/// pressure of an incompressible body is a constraint (index 3). PETSc's TSALPHA2 satisfies the balance at alpha_f within the step:
/// there the constraint is satisfied instead of at the end of the step, and the pressure oscillates from step to step.
///
/// Diagonally implicit Runge-Kutta: the implicit half of ARK4(3)6L[2]SA, Kennedy and Carpenter, Appl. Numer. Math. 44 (2003)
/// 139, used alone. TSARKIMEX has the table, but computes the slope of its first stage from a unit mass matrix, or else from a
/// starting step of second order.
#include "solver/stage.hpp"

namespace soft::solver {

struct StepResult {
    NewtonResult newton;
    std::optional<double>
        error_m;  ///< norm of the step's error over the displacement unknowns, where the method estimates it
};

/// Computes acceleration and pressures due to the loads at the state's time, from its x and v. False where J is singular.
/// They are those of a stage so short that the body does not move, which includes the pressures of an incompressible body.
[[nodiscard]] bool start_acceleration(MotionEquations& equations, StageSolver& solver, double step_s,
                                      MotionState& state);

struct AlphaParameters {
    double alpha_m = 0, alpha_f = 0, beta = 0.25, gamma = 0.5;
    /// Factor of h^3 x''' in the local error of x.
    [[nodiscard]] double error_constant() const;
};
[[nodiscard]] AlphaParameters alpha_parameters(model::Integrator integrator, double spectral_radius);

class GeneralizedAlpha {
public:
    GeneralizedAlpha(MotionEquations& equations, StageSolver& solver, const AlphaParameters& parameters);
    void start(const MotionState& state);
    [[nodiscard]] StepResult attempt(const MotionState& last, double step_s, MotionState& next);
    void accept();

private:
    MotionEquations& equations_;
    StageSolver& solver_;
    AlphaParameters p_;
    linalg::Vector w_, next_w_;
    std::vector<double> flow_w_, next_flow_w_;  // the same for the lines' dm/dt
};

class Dirk {
public:
    Dirk(MotionEquations& equations, StageSolver& solver);
    void start(const MotionState& state);
    [[nodiscard]] StepResult attempt(const MotionState& last, double step_s, MotionState& next);
    void accept() {}

private:
    MotionEquations& equations_;
    StageSolver& solver_;
    std::vector<linalg::Vector> velocities_, accelerations_;  // by stage
    std::vector<std::vector<double>> flows_;
    linalg::Vector error_;
};

}  // namespace soft::solver
