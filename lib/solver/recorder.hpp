#pragma once
/// Rows, checkpoints and log of a path, for its listeners. Internal to the module. Tested by solver/solver_test, solver/work_test,
/// pipeline Resume.
#include "solver/corrector.hpp"
#include "solver/natural_frequencies.hpp"
#include "solver/path.hpp"
#include "solver/sensitivities.hpp"

namespace soft::solver {

class Recorder {
public:
    /// `sensitivities`: nullptr for none
    Recorder(Corrector& corrector, const Listeners& listeners, Sensitivities* sensitivities);

    /// Makes a point the next row, and sets its work since the last row.
    void append(PathState& path, PathPoint& point);
    /// The next step starts from the point appended last.
    void accept_step();

    void report_control(const PathState& path) const;
    /// After each row; with internal variables after the first one and every tenth from there.
    void keep_checkpoint(const PathState& path);

    /// Counts from the checkpoint of an interrupted run on.
    void resume(const model::Checkpoint& from);
    /// The end so far with its counts.
    [[nodiscard]] model::PathEnd end_of(const PathState& path) const;

private:
    Corrector& corrector_;
    const Listeners& listeners_;
    std::optional<NaturalFrequencies> frequencies_;  // of every row
    Sensitivities* sensitivities_;
    int checkpoint_rows_ = 0;    // at the last checkpoint
    WorkCount at_row_, before_;  // at the last row; of the interrupted run
};

/// Restores the state after the checkpoint's last row. Throws Error (bad_input) for a checkpoint of another case or another number of
/// ranks.
void restore(const model::Checkpoint& from, Corrector& corrector, PathState& path);

}  // namespace soft::solver
