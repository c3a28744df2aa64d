#pragma once
/// Integrates the motion of a case in time (model::Dynamics), from rest in the undeformed state:
///   M a + C v + R(x, levels(t), p) = 0,      C = mass_damping M + stiffness_damping K(undeformed, without contact)
///   dm/dt = ambient density (source(t) - p) / resistance,  p = P(V(x), m)      of a supply with a line (stage_loads.hpp)
/// with R of fem/system.hpp and M the mass matrix of the displacements (fem/mass.hpp; consistent, lumped for explicit
/// integrators). Pressure unknowns of mixed cells have no mass: their rows are satisfied at all times, and explicit integrators
/// reject them. Levels are those of the case's only stage times the value of each load's time function at t.
///
/// A row of the path is a converged step: time, energies and work in Step::motion, tangent_* the derivatives by time,
/// load_factor = t / duration, `stable` always true; row 0 is the state at rest. Rows are finite. Stop reasons: done;
/// inverted_element; diverged (the step became too short; the state is not finite; explicit steps with a kinetic energy of ten
/// times the loads' work, or a stable step below solver.min_step of the first); self_contact; step_limit.
/// Sources: PETSc's TS has the implicit Euler, generalised-alpha, ARKIMEX, Rosenbrock-W and Runge-Kutta methods; central
/// difference: Belytschko, Liu and Moran, Nonlinear Finite Elements for Continua and Structures (2000) 6.2.
/// Tested by solver/dynamics_test and the verification suite.
#include "solver/path.hpp"

namespace soft::solver {

/// Does not call the checkpoint and row listeners: a motion cannot be resumed or refined. Throws Error (bad_input) for
/// a material without density, a supply that prescribes no pressure, a face that is moved, a pressure unknown
/// with an explicit integrator, an explicit step longer than the stable one.
[[nodiscard]] model::PathEnd integrate_motion(fem::System& system, const solver::Listeners& listeners);

}  // namespace soft::solver
