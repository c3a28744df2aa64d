#pragma once
/// How a case is solved: the choices of `solver` and `dynamics` in a design. Plain data, SI units; the defaults are those of a
/// design that says nothing.

namespace soft::model {

/// How the linear systems of Newton's method are solved.
///   automatic: LDL^T by CHOLMOD where that takes few flops, else by MUMPS, over to LU where the tangent is not symmetric enough
///       (linalg/linear_solver.hpp); krylov with multigrid where a solid is too large for it (assembly/element_levels.hpp)
///   mumps_ldlt, mumps_lu, superlu_dist, cholmod: that factorisation; cholmod needs a positive definite tangent and one rank
///   krylov: flexible GMRES on the assembled tangent         jacobian_free: on differences of the residual instead
enum class LinearMethod { automatic, mumps_ldlt, mumps_lu, superlu_dist, cholmod, krylov, jacobian_free };

/// Of the two Krylov methods. asm_*: additive Schwarz, one block a rank, solved by LU, ILU(0) or a BoomerAMG cycle.
/// gamg: smoothed aggregation with the rigid motions as near-nullspace. multigrid: second-order cells by way of first-order ones,
/// mixed or not (linalg/multigrid.hpp).
enum class Preconditioner { lu, asm_lu, asm_ilu, asm_boomeramg, boomeramg, gamg, multigrid, jacobi, none };

/// Where the assembled tangent comes from: the exact derivatives, or coloured differences of the residual.
enum class TangentSource { exact, finite_difference };

struct LinearSettings {
    LinearMethod method = LinearMethod::automatic;
    Preconditioner preconditioner = Preconditioner::asm_lu;
    double tolerance = 1e-8;   ///< residual of a linear solve over its right-hand side
    int iteration_limit = 40;  ///< a Krylov method that reaches it gives its best correction so far
};

/// full: a new tangent every iteration. modified: that of the step's first iteration. bfgs: the same with the updates of
/// Broyden, Fletcher, Goldfarb and Shanno (Matthies and Strang 1979).
enum class NewtonMethod { full, modified, bfgs };

/// backtracking: halve until the residual falls. secant: find where the residual has no part along the correction.
/// none: the whole correction. All of them halve while det F <= 0 somewhere.
enum class LineSearch { backtracking, secant, none };

/// error_adaptive: by the error of the predictor. iteration_adaptive: by the Newton iterations of the step before.
/// constant: `first_step`, shortened only while a step fails.
enum class StepRule { error_adaptive, iteration_adaptive, constant };

/// Where Newton's method starts: on the cubic through the last two states, on the tangent of the last, or at the last.
enum class Predictor { cubic, tangent, none };

struct SolverSettings {
    double residual_tolerance = 1e-9;  ///< |residual| <= tolerance x scale of the nodal forces
    NewtonMethod newton = NewtonMethod::full;
    LineSearch line_search = LineSearch::backtracking;
    TangentSource tangent = TangentSource::exact;
    int newton_limit = 16;  ///< iterations a step
    LinearSettings linear;
    bool scaling = true;  ///< pressure unknowns are scaled to displacements (assembly/dof_map.hpp); false: in Pa
    int threads = 1;      ///< of a rank, in the element loops; the sums keep their order
    StepRule steps = StepRule::error_adaptive;
    Predictor predictor = Predictor::cubic;
    double first_step = 0.02;   ///< first step, fraction of the full load in the linear response
    double max_step = 0.0;  ///< 0: chosen by the solver; else a bound on the step as a fraction of the path so far
    double min_step = 1e-4;  ///< a step cut below this part of the first ends the path; of an arc, a thousandth
    int wanted_iterations = 5;    ///< of a step, steps iteration_adaptive
    int step_limit = 1000;        ///< stop_reason step_limit beyond
    double step_accuracy = 2e-3;  ///< wanted relative error of the predictor; smaller = denser steps
};

/// Time integration of M a + C v + R(x, t) = 0 (dynamics/motion.hpp).
enum class Integrator {
    generalized_alpha,  ///< Chung and Hulbert 1993, second order, damps what the step does not resolve
    hht,                ///< Hilber, Hughes and Taylor 1977
    newmark,            ///< average acceleration: keeps the energy of linear systems
    implicit_euler,
    ark4,        ///< fourth-order additive Runge-Kutta (Kennedy and Carpenter 2003)
    rosenbrock,  ///< linearly implicit Runge-Kutta (Rang and Angermann 2005)
    heun,
    explicit_euler,  ///< explicit: a lumped mass and no pressure unknown
    central_difference,
};

[[nodiscard]] constexpr bool is_explicit(Integrator integrator) noexcept {
    return integrator == Integrator::heun || integrator == Integrator::explicit_euler ||
           integrator == Integrator::central_difference;
}

/// A case with it is one stage that runs in time, from rest in the undeformed state.
struct Dynamics {
    Integrator integrator = Integrator::generalized_alpha;
    double duration_s = 0;
    double step_s = 0;             ///< 0: chosen by `accuracy`, of an explicit integrator by its stable step
    double accuracy = 1e-4;        ///< wanted error of a step over the size of the motion, where step_s is 0
    double spectral_radius = 0.8;  ///< of generalized_alpha and hht (>= 1/2), at infinite frequency: 1 damps nothing
    double mass_damping_1_s = 0;   ///< Rayleigh: C = mass_damping M + stiffness_damping K(undeformed)
    double stiffness_damping_s = 0;
    int rows = 2000;  ///< of the path at most (constant steps: every so many)
};

}  // namespace soft::model
