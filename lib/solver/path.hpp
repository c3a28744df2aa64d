#pragma once
/// Follows the equilibrium path of a case from the undeformed state, by steps that choose their own length, until the
/// full load or a stated goal is reached, or the path ends for a physical or numerical reason.
///
/// The controlled quantity q (pressure, enclosed volume, an output, arc length) grows monotonically. Its step is chosen
/// so that the predictor (cubic through the last two states, history.hpp) errs by SolverSettings::step_accuracy of the
/// step. Limit points of the load are located on the way (d load / d q = 0) and become rows of the path. When steps
/// under pressure control fail, a few steps by arc length tell whether a limit point is the reason.
/// Held by the verification suite (sphere, tube, bellows).
#include <functional>
#include <string>

#include "assembly/system.hpp"
#include "solution/checkpoint.hpp"
#include "solution/path.hpp"

namespace soft::solver {

/// What the caller does with each converged step (write it, show progress). Called on every rank, in order.
using StepSink = std::function<void(const solution::Step& step, Vec x)>;

/// One line about what the solver is doing, for `--verbose`.
using Log = std::function<void(const std::string&)>;

/// What it would take to go on from the row just passed to the sink. Collective; only rank 0 gets the vectors.
using CheckpointSink = std::function<void(const solution::Checkpoint&)>;

struct Listeners {
    StepSink step;
    CheckpointSink checkpoint = {};   ///< may be empty
    Log log = {};                     ///< may be empty
};

/// `from`: goes on from there instead of the undeformed state; the rows before it are not passed to the sink again. The
/// rows after it are those of the uninterrupted path. Throws Error (bad_input) for a checkpoint of another case or
/// another number of ranks.
[[nodiscard]] solution::PathEnd follow_path(assembly::System& system, const Listeners& listeners,
                                            const solution::Checkpoint* from = nullptr);

}  // namespace soft::solver
