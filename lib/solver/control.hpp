#pragma once
/// The control policy: which quantity the path is followed by, and when another one takes over. Internal to the module.
/// Tested by solver/solver_test, solver/step_rules_test.
#include "solver/path_state.hpp"

namespace soft::solver {

/// Whether an output is a displacement, which may be controlled: no reaction, and no contact with an obstacle.
[[nodiscard]] bool is_displacement(const model::Output& output);

/// The control at the start of a stage. Throws Error (bad_input) for a quantity that the case does not have.
[[nodiscard]] Constraint first_control(const fem::System& system, const model::Stage& stage);

/// The control that automatic control changes to: the volume where only the pressure of a single cavity grows, else arc length.
[[nodiscard]] Constraint softer_control(const fem::System& system, const StageLoads& loads);

/// True where a relative change of the controlled volume over the whole stage is lost in rounding: such a path is straight and is
/// followed by its load factor. `by_load`: the start of the stage, with slopes per load factor.
[[nodiscard]] bool is_lost_in_rounding(const Constraint& control, const StageLoads& loads, const PathPoint& by_load);

/// Value of the controlled quantity; an arc length is given.
[[nodiscard]] double controlled_value(const Constraint& control, const PathPoint& point, double arc_length);
/// d q / d(parameter of the point's slopes); an arc grows in the direction of the slopes.
[[nodiscard]] double control_slope(const Constraint& control, const PathPoint& point);

/// Step of q at the start of a stage, with q changing by `slope` per load factor.
[[nodiscard]] double first_step(const model::SolverSettings& settings, const Constraint& control, double slope,
                                double sense);

struct ControlChange {
    Constraint control;
    std::string reason;
};

/// Leaves load control early: under automatic control when another control is better; under user-selected load control before
/// the steps towards a maximum become shorter and shorter.
[[nodiscard]] std::optional<ControlChange> better_control(const fem::System& system, const PathState& path);

/// After a failed step; `too_short`: the next one would be below solver.min_step. At rest, before an obstacle arrives and after it has
/// left, only the load factor changes.
[[nodiscard]] std::optional<ControlChange> control_after_failure(const fem::System& system, const PathState& path,
                                                                 NewtonEnd failure, bool too_short);

/// Continues from the last point under another control, in the same direction.
void set_control(fem::System& system, PathState& path, const Constraint& control);

/// Changes the parameter of a point's slopes. They are recomputed, as after a resumption, so that both agree to the byte.
void rescale(fem::System& system, const StageLoads& loads, PathPoint& point, double factor);

}  // namespace soft::solver
