#pragma once
/// Follows the equilibrium path of a case from the undeformed state through the stages of its load programme, with adaptive
/// steps, until the last stage's loads are reached or a goal is reached, or the path ends for a physical or numerical reason.
///
/// The controlled quantity q (load factor, enclosed volume, an output, arc length) grows monotonically. Its step is chosen
/// so that the error of the predictor (cubic through the last two states, history.hpp) is SolverSettings::step_accuracy of the
/// step. The inertia of the tangent is monitored on every step: limit points of the leading load (d load / d q = 0) and
/// bifurcations (an eigenvalue passes through zero without a limit point) are located and become rows of the path.
///
/// Control::automatic starts with the load factor. It changes to the volume (where one supply's pressure grows), else to
/// arc length, when the compliance exceeds that at the beginning of the stage by the factor `softening`, when the path is straighter
/// under the other control, or when a step fails. Where the user has chosen the control, a path that ends under it is followed by
/// arc length just far enough to find the reason: a limit point of the controlled quantity.
///
/// Step::stable: the tangent is positive definite with every load prescribed as the case states it: at constant pressure where a
/// pressure is prescribed, at constant volume or mass where these are. Step::stable_under_control: the same where the control is the
/// load factor or the arc length. Under volume or output control the tangent is positive definite with the controlled quantity fixed
/// and a free load, so that a state beyond a pressure maximum can be stable under control only.
/// Tested by solver/solver_test, solver/branch_test and the verification suite (sphere, tube, bellows, two spheres).
#include <functional>
#include <optional>
#include <string>

#include "fem/system.hpp"
#include "model/checkpoint.hpp"
#include "model/path.hpp"
#include "solver/row_state.hpp"

namespace soft::solver {

/// Automatic control leaves the load factor when the displacement per load exceeds that at the start of the stage by this factor,
inline constexpr double softening = 3.0;
/// or when the tangent changes over a step by less than this fraction under the other control,
inline constexpr double straighter = 0.5;
/// provided that it changes by more than this multiple of step_accuracy: a smaller change is straight already, or rounding.
inline constexpr double straight_enough = 1e-3;
/// Under user-selected load control: where a step is shorter than this fraction of the load, a maximum within this many lengths of
/// the last step is passed by arc length, to locate it.
inline constexpr double short_step_of_load = 0.02, steps_to_a_maximum = 10.0;

/// What the caller does with each converged step (write it, show progress). Called on every rank, in order. The system's
/// prescribed motions are those of the step.
using StepSink = std::function<void(const model::Step& step, Vec x)>;

/// One line about what the solver is doing, for `--verbose`.
using Log = std::function<void(const std::string&)>;

/// Data needed to resume after the row just passed to the sink. Collective; only rank 0 gets the vectors.
using CheckpointSink = std::function<void(const model::Checkpoint&)>;

/// Walls that touch in a state, or that have passed through themselves: inverted_element. `text`: "the faces ... at x = ...".
/// `is_driven`: into an obstacle, by a prescribed displacement.
struct ContactEvent {
    std::string text;
    model::StopReason reason = model::StopReason::self_contact;
    bool is_driven = false;
    /// Message for a path that ends in this state; `state`: its values.
    [[nodiscard]] std::string end_at(const std::string& state) const {
        const bool inverted = reason == model::StopReason::inverted_element;
        return text + " at " + state +
               (inverted ? "; use smaller cells there (mesh.size)"
                         : "; path.contact: solve continues with contact forces");
    }
};

/// nullopt without contact. Collective, the same result on every rank.
using ContactCheck = std::function<std::optional<ContactEvent>(Vec x)>;

/// A row with what it takes to solve it again on another mesh (refined_path.hpp).
using RowSink = std::function<void(const RowState&)>;

/// The control by which the path is followed from the next row on: "load", "volume", "output elongation", "arc length".
using ControlSink = std::function<void(int row, const std::string& control)>;

struct Listeners {
    StepSink step;
    CheckpointSink checkpoint = {};  ///< may be empty
    Log log = {};                    ///< may be empty
    ContactCheck contact = {};       ///< may be empty: walls pass through each other
    RowSink row = {};                ///< may be empty
    ControlSink control = {};        ///< may be empty

    void report(const std::string& line) const {
        if (log) log(line);
    }
};

class Sensitivities;

/// `sensitivities`: fills the derivatives of every row; nullptr: none. `from`: resumes there instead of starting at the undeformed state; rows before it are not passed to the sink again. The
/// rows after it are those of the uninterrupted path. Throws Error (bad_input) for a body with a rigid motion, a control
/// or goal the case does not have, a checkpoint of another case or another number of ranks.
[[nodiscard]] model::PathEnd follow_path(fem::System& system, const Listeners& listeners,
                                         const model::Checkpoint* from = nullptr,
                                         Sensitivities* sensitivities = nullptr);

}  // namespace soft::solver
