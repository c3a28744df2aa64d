#pragma once
/// A path in progress, as plain data: what the parts of follow_path (path_follower.hpp) pass to each other. Internal to the module.
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "solver/goals.hpp"
#include "solver/path.hpp"
#include "solver/visited_states.hpp"

namespace soft::solver {

/// Why a path ends.
struct Stop {
    model::StopReason reason = model::StopReason::done;
    std::string detail;
};

/// The attempts to find the next row.
struct Attempts {
    int failures = 0;                                            ///< in a row
    std::optional<double> rejected_error, rejected_curve_error;  ///< of the predictor, in the last attempt
    std::optional<ContactEvent> crossing;  ///< walls that passed through each other in the last attempt
};

/// An attempt at a row that was refused because walls passed through each other.
struct RefusedRow {
    int row = 0;
    ContactEvent crossing;
};

struct PathState {
    std::vector<double> undeformed_volumes_m3;  ///< by load

    // The stage.
    int stage = 0, first_row = 0;
    std::optional<StageLoads> loads;
    std::vector<Goal> goals;
    double first_slope = 0;  ///< |dx / d load factor| at the start of the stage
    double work_before_J = 0;
    std::vector<VisitedState> visited;  ///< rows of the stage

    // The step. `before` is empty where a cubic through both points would not predict the path.
    Constraint control;
    std::optional<Constraint> user_control;  ///< while another one is used to find why the path ends
    int load_control_at = -1;                ///< row from which load control was tried because arc length failed
    std::optional<PathPoint> before, last;
    double step = 0, first_step = 0;  ///< of q, signed
    Attempts attempts;
    std::optional<RefusedRow> refused;  ///< the last one

    // The path.
    int rows = 0;
    double dissipated_J = 0;  ///< set free by snaps, of the modelled part
    double stretch_p99 = 1;   ///< of the last row
    double max_stretch = 1;   ///< of the last row
    double min_jacobian = 1;  ///< of the last row
    double size = 0;          ///< largest norm of the unknowns at a row
    bool on_branch = false;
    bool finished = false;
    model::PathEnd end;

    [[nodiscard]] double direction() const { return step < 0.0 ? -1.0 : 1.0; }
    /// Whether the load falls along the direction of travel.
    [[nodiscard]] bool load_falls(const PathPoint& point) const { return point.tangent.load_factor * step < 0.0; }
    /// The row that the stage starts from: row 0, or the last one of the stage before.
    [[nodiscard]] int start_row() const { return std::max(first_row, 1) - 1; }
    /// Whether the next step is the first one of its stage.
    [[nodiscard]] bool begins_stage() const { return rows == start_row() + 1; }
};

[[nodiscard]] inline const model::Stage& stage_of(const model::Case& input, const PathState& path) {
    return input.path.stages[static_cast<std::size_t>(path.stage)];
}

}  // namespace soft::solver
