#pragma once
/// The central difference method, and the longest stable explicit step; internal to the module.
/// Central difference with the velocity in the middle of the step (lumped mass, so that no system is solved):
///   v(1/2) = v0 + h/2 a0,   x1 = x0 + h v(1/2),   a1 = M^-1 (-R(x1, t1) - C v(1/2)),   v1 = v(1/2) + h/2 a1
/// (the part mass_damping M of C is evaluated at v1, which needs no extra work and keeps the order).
/// Longest stable steps; w is the highest frequency of (K(x), M), z the damping of its mode f, f.C f / (2 w f.M f):
///   central difference: 2/w (sqrt(1 + z^2) - z). Belytschko, Liu and Moran (2000) 6.2.
///   Heun, explicit Euler: the longest step in which the stability function R(h s) of the mode's roots s does not exceed
///   exp(h / duration). Both amplify an undamped mode at any step, by about (w h)^4 / 8 and (w h)^2 / 2 a step: the bound lets
///   the highest mode grow e-fold by the end of the motion.
/// Tested by solver/dynamics_test.
#include "solver/implicit.hpp"

namespace soft::solver {

class CentralDifference {
public:
    explicit CentralDifference(MotionEquations& equations);
    void start(const MotionState& state);
    [[nodiscard]] StepResult attempt(const MotionState& last, double step_s, MotionState& next);
    void accept() {}

private:
    MotionEquations& equations_;
};

/// a = M^-1 (-R - C v) at a state, with its load force.
[[nodiscard]] fem::Evaluation explicit_acceleration(MotionEquations& equations, MotionState& state);

class StableStep {
public:
    StableStep(MotionEquations& equations, model::Integrator integrator);
    /// The longest stable step at a state, by power iteration on M^-1 K that starts from the last mode. The iteration never
    /// overestimates the frequency: the caller applies a safety factor to the step.
    [[nodiscard]] double estimate(const MotionState& state);
    [[nodiscard]] double frequency() const noexcept { return omega_; }

private:
    MotionEquations& equations_;
    model::Integrator integrator_;
    linalg::Matrix K_;
    linalg::Vector mode_, image_;
    double omega_ = 0;
};

/// The longest stable step for the highest frequency omega [rad/s] with the damping ratio zeta.
[[nodiscard]] double longest_stable_step_s(model::Integrator integrator, double duration_s, double omega, double zeta);

}  // namespace soft::solver
