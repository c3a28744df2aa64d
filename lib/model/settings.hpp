#pragma once
/// Solver and time integration settings: the sections `solver` and `dynamics` of a design. Plain data, SI units. The default values
/// apply to designs without these sections.
#include "math/linear_settings.hpp"

namespace soft::model {

using soft::LinearMethod, soft::LinearSettings, soft::Preconditioner;

/// Computation of the assembled tangent: exact derivatives, or finite differences of the residual with colouring.
enum class TangentSource { exact, finite_difference };

/// full: a new tangent in every iteration. modified: the tangent of the first iteration of the step. bfgs: the same with BFGS
/// updates (Broyden, Fletcher, Goldfarb, Shanno; Matthies and Strang 1979).
enum class NewtonMethod { full, modified, bfgs };

/// backtracking: halve until the residual decreases. secant: find the zero of the residual's component along the correction.
/// none: the full correction. All of them halve the correction while det F <= 0 somewhere.
enum class LineSearch { backtracking, secant, none };

/// Step size control. error_adaptive: from the predictor error. iteration_adaptive: from the Newton iterations of the previous
/// step. constant: `first_step`, shortened only while a step fails.
enum class StepRule { error_adaptive, iteration_adaptive, constant };

/// Initial guess of Newton's method: cubic extrapolation of the last two states, the tangent at the last state, or the last state.
enum class Predictor { cubic, tangent, none };

struct SolverSettings {
    double residual_tolerance = 1e-9;  ///< |residual| <= tolerance x characteristic size of the nodal forces
    NewtonMethod newton = NewtonMethod::full;
    LineSearch line_search = LineSearch::backtracking;
    TangentSource tangent = TangentSource::exact;
    int newton_limit = 16;  ///< maximum iterations per step
    LinearSettings linear;
    bool scaling = true;  ///< pressure unknowns are scaled to displacements (fem/dof_map.hpp); false: in Pa
    int threads = 0;      ///< threads per rank, 0: math/threads.hpp; the order of summation does not depend on it
    StepRule steps = StepRule::error_adaptive;
    Predictor predictor = Predictor::cubic;
    double first_step = 0.02;  ///< first step as a fraction of the full load, in the linear response
    /// 0: chosen by the solver; else an upper bound on the step, as a fraction of the path so far.
    double max_step = 0.0;
    /// The path ends if a step is cut below this fraction of the first step; arc length: a thousandth.
    double min_step = 1e-4;
    int wanted_iterations = 5;    ///< target number of Newton iterations per step, for iteration_adaptive
    int step_limit = 1000;        ///< maximum number of steps; the path then ends with stop_reason step_limit
    double step_accuracy = 2e-3;  ///< target relative error of the predictor; smaller = denser steps
};

/// Time integration of M a + C v + R(x, t) = 0 (solver/motion.hpp).
enum class Integrator {
    generalized_alpha,  ///< Chung and Hulbert 1993, second order, damps frequencies that the step does not resolve
    hht,                ///< Hilber, Hughes and Taylor 1977
    newmark,            ///< average acceleration: conserves the energy of linear systems
    implicit_euler,
    ark4,        ///< fourth-order additive Runge-Kutta (Kennedy and Carpenter 2003)
    rosenbrock,  ///< linearly implicit Runge-Kutta (Rang and Angermann 2005)
    heun,
    explicit_euler,  ///< explicit methods require a lumped mass and no pressure unknowns
    central_difference,
};

[[nodiscard]] constexpr bool is_explicit(Integrator integrator) noexcept {
    return integrator == Integrator::heun || integrator == Integrator::explicit_euler ||
           integrator == Integrator::central_difference;
}

/// Time integration settings. A dynamic case has one stage that starts at rest in the undeformed state.
struct Dynamics {
    Integrator integrator = Integrator::generalized_alpha;
    double duration_s = 0;
    double step_s = 0;             ///< 0: chosen from `accuracy`, or from the stability limit of an explicit integrator
    double accuracy = 1e-4;        ///< target error per step relative to the size of the motion, if step_s is 0
    double spectral_radius = 0.8;  ///< of generalized_alpha and hht (>= 1/2) at infinite frequency; 1: no damping
    double mass_damping_1_s = 0;   ///< Rayleigh: C = mass_damping M + stiffness_damping K(undeformed, without contact)
    double stiffness_damping_s = 0;
    int rows = 2000;  ///< maximum number of rows of the path (constant steps: every n-th step is written)
};

}  // namespace soft::model
