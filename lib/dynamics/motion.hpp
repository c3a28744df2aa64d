#pragma once
/// Integrates the motion of a case in time (model::Dynamics), from rest in the undeformed state:
///   M a + C v + R(x, levels(t), p) = 0,      C = mass_damping M + stiffness_damping K(undeformed)
///   dm/dt = ambient density (source(t) - p) / resistance,  p = P(V(x), m)      of a supply with a line (stage_loads.hpp)
/// with R of assembly/system.hpp and M the mass matrix of the displacements (assembly/mass.hpp; consistent, lumped for explicit
/// integrators). Pressure unknowns of mixed cells have no mass: their rows hold at all times, and explicit integrators refuse
/// them. Levels are those of the case's only stage times the share of each load's time_function at t.
///
/// A row of the path is a converged step: time, energies and work in Step::motion, tangent_* the derivatives by time,
/// load_factor = t / duration, `stable` always true; row 0 is rest. Rows are finite. Ends: done; inverted_element; diverged (the
/// step became too short; the motion leaves the range of numbers; explicit steps whose kinetic energy is ten times the loads'
/// work, or whose stable length has fallen below solver.min_step of the first); self_contact; step_limit.
/// Sources: PETSc's TS has the implicit Euler, generalised-alpha, ARKIMEX, Rosenbrock-W and Runge-Kutta methods; central
/// difference: Belytschko, Liu and Moran, Nonlinear Finite Elements for Continua and Structures (2000) 6.2.
/// Tested by dynamics/dynamics_test and the verification suite.
#include "solver/path.hpp"

namespace soft::dynamics {

/// Checkpoints and rows of the listeners are not called: a motion cannot be resumed or refined. Throws Error (bad_input) for
/// a material without density, a supply that prescribes no pressure, a prescribed motion that changes, a pressure unknown
/// under an explicit integrator, an explicit step beyond the stable one.
[[nodiscard]] solution::PathEnd integrate_motion(assembly::System& system, const solver::Listeners& listeners);

}  // namespace soft::dynamics
