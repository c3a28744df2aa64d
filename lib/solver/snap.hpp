#pragma once
/// Local snaps. Where an edge slides off another, or a crease closes or forms next to a clamped edge, a small part of the body loses its
/// stability although the rest hardly moves: the path turns back in a sharp fold, along which Newton's method may not converge, or which
/// leads far back. Under a load, or at a volume, the body jumps to a stable state nearby. Pseudo-transient continuation finds it: the states
/// x_n of the overdamped motion, by the implicit Euler method,
///   R(x_n) + c_n k (u_n - u_(n-1)) = 0,
/// from the last row on, at the target of the failed step or beyond the fold, with a drag c_n that falls until it vanishes.
/// Source: Coffey, Kelley and Keyes, SIAM J. Sci. Comput. 25 (2003) 553. Internal to the module. Tested by pipeline
/// ContactThatSnapsKeepsItsEnergyBalance, Plate.PassesCreasesAtItsEdge.
#include "solver/events.hpp"

namespace soft::solver {

/// Of the displacements: a larger motion is no local snap.
inline constexpr double farthest_snap = 0.1;

/// The equilibrium at which the overdamped motion from a state ends, with the quantity held at `target`; nullopt also where it moves by more than
/// the fraction `farthest` of the displacements.
[[nodiscard]] std::optional<State> settle(Corrector& corrector, const State& from, const Constraint& held,
                                          double target, double farthest = farthest_snap);

struct Snap {
    PathPoint point;
    const Goal* goal = nullptr;  ///< reached
};

/// The stable state after the snap, with the energy set free; nullopt where the last row is not stable, no stable state is found nearby, or
/// walls cross there; the memory of the corrector is then unchanged. `step`: the first one that failed. A goal on the way is the target
/// instead.
[[nodiscard]] std::optional<Snap> snap(Corrector& corrector, PathState& path, const Listeners& listeners, double step);

/// The same, where a step in contact has converged to a less stable state, and no bifurcation is found before it: it lies beyond a fold, which
/// only path.control: arc-length follows.
[[nodiscard]] std::optional<Snap> snap_off(const PathPoint& beyond, const Events& events, Corrector& corrector,
                                           PathState& path, const Listeners& listeners);

/// The same, where the rubber is crushed at a point, beyond a sharp fold between the last row and `beyond`, which an arc length has passed;
/// nullopt also where the path does not turn back there, the load or a volume would jump, or no energy is set free.
[[nodiscard]] std::optional<Snap> snap_over(const PathPoint& beyond, Corrector& corrector, PathState& path,
                                            const Listeners& listeners);

}  // namespace soft::solver
