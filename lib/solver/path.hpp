#pragma once
/// Follows the equilibrium path of a case from the undeformed state through the stages of its load programme, by steps
/// that choose their own length, until the last stage's loads are in place or a stated goal is reached, or the path ends
/// for a physical or numerical reason.
///
/// The controlled quantity q (load factor, enclosed volume, an output, arc length) grows monotonically. Its step is chosen
/// so that the predictor (cubic through the last two states, history.hpp) errs by SolverSettings::step_accuracy of the
/// step. On every step the inertia of the tangent is watched: limit points of the leading load (d load / d q = 0) and
/// bifurcations (an eigenvalue passes zero that no limit point explains) are located and become rows of the path.
///
/// Control::automatic starts with the load factor and goes over to the volume (where one supply's pressure grows), or to
/// arc length, when the body has become softer than at the beginning of the stage by `softening`, when the path is seen to
/// be straighter there, or when a step fails. Where
/// the user has chosen the control, a path that ends under it is followed by arc length just far enough to say why:
/// a limit point of the controlled quantity.
///
/// Step::stable: the tangent is positive definite with every load held as the case states it: at that pressure where a pressure
/// is stated, at that volume or mass where these are. Step::stable_under_control: the same where the control is the load factor
/// or the arc length; under volume or output control the tangent is positive definite where the controlled quantity is held and
/// the load adapts, so that a state beyond a pressure maximum can be stable under control alone.
/// Tested by solver/solver_test, solver/branch_test and the verification suite (sphere, tube, bellows, two spheres).
#include <functional>
#include <optional>
#include <string>

#include "assembly/system.hpp"
#include "solution/checkpoint.hpp"
#include "solution/path.hpp"
#include "solver/row_state.hpp"

namespace soft::solver {

/// Automatic control leaves the load factor when the body moves this much more per load than where the stage began.
inline constexpr double softening = 3.0;
/// ... or when its direction changes this much less over a step, per unit of the other control.
inline constexpr double straighter = 0.5;
/// ... where it changes by more than so many times step_accuracy: less is straight already, and under tiny loads rounding.
inline constexpr double straight_enough = 1e-3;
/// Under a load that the user controls: where steps are shorter than this part of the load, a maximum so many lengths of the last step
/// away is passed by arc length, to locate it.
inline constexpr double short_step_of_load = 0.02, steps_to_a_maximum = 10.0;

/// What the caller does with each converged step (write it, show progress). Called on every rank, in order. The system's
/// prescribed motions are those of the step.
using StepSink = std::function<void(const solution::Step& step, Vec x)>;

/// One line about what the solver is doing, for `--verbose`.
using Log = std::function<void(const std::string&)>;

/// What it would take to go on from the row just passed to the sink. Collective; only rank 0 gets the vectors.
using CheckpointSink = std::function<void(const solution::Checkpoint&)>;

/// Walls that touch in a state, or one that has passed through itself: inverted_element. In words, "the faces ... at x = ...".
struct ContactEvent {
    std::string text;
    solution::StopReason reason = solution::StopReason::self_contact;
    /// Why the path ends in this state, whose values are given.
    [[nodiscard]] std::string end_at(const std::string& state) const {
        const bool inverted = reason == solution::StopReason::inverted_element;
        return text + " at " + state + (inverted ? "; use smaller cells there (mesh.size)" : "");
    }
};

/// Empty where nothing touches. Collective, the same answer on every rank.
using ContactCheck = std::function<std::optional<ContactEvent>(Vec x)>;

/// A row with what it takes to solve it again on another mesh (refined_path.hpp).
using RowSink = std::function<void(const RowState&)>;

/// The control that the path is followed by from the next row on, in words: "load", "volume", "output elongation", "arc length".
using ControlSink = std::function<void(int row, const std::string& control)>;

struct Listeners {
    StepSink step;
    CheckpointSink checkpoint = {};  ///< may be empty
    Log log = {};                    ///< may be empty
    ContactCheck contact = {};       ///< may be empty: walls pass through each other
    RowSink row = {};                ///< may be empty
    ControlSink control = {};        ///< may be empty
};

/// `from`: goes on from there instead of the undeformed state; the rows before it are not passed to the sink again. The
/// rows after it are those of the uninterrupted path. Throws Error (bad_input) for a body that can move freely, a control
/// or goal the case does not have, a checkpoint of another case or another number of ranks.
[[nodiscard]] solution::PathEnd follow_path(assembly::System& system, const Listeners& listeners,
                                            const solution::Checkpoint* from = nullptr);

}  // namespace soft::solver
