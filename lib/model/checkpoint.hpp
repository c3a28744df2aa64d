#pragma once
/// State that the solver needs to continue from a row of the path with results identical to an uninterrupted run. Plain data; io
/// writes one checkpoint after each row of a running `solve -o`. Tested by io/journal_test and pipeline Resume.
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/path.hpp"

namespace soft::model {

/// A converged state in the unknowns of the solver (displacements and scaled pressures, in its numbering) and the tangent of the
/// path there.
struct StatePoint {
    std::vector<double> unknowns, tangent_unknowns;
    std::vector<double> pressures_Pa, tangent_pressures;  ///< of the supplies whose pressure is an unknown
    double load_factor = 0;
    double tangent_load_factor = 0;
    double power = 0;             ///< work of the increasing loads along the tangent
    std::vector<double> outputs;  ///< angles may exceed 2 pi
    double q = 0;                 ///< controlled quantity
    double load_work_J = 0;  ///< work of the loads since the start of the path, for the modelled part of the actuator
    std::optional<int> unstable_modes;
};

/// The loads at the start of a stage, one entry per load.
struct StageStart {
    std::vector<double> pressures_Pa, volumes_m3, masses_kg;
    std::vector<double> dead_loads, motions;  ///< levels
    double time_s = 0;
};

struct Checkpoint {
    int ranks = 1;  ///< number of ranks, which determines the numbering of the unknowns
    int rows = 0;   ///< number of rows of the path, including `last`
    int stage = 0;
    int stage_first_row = 0;           ///< row where the stage begins
    StageStart start;                  ///< of the stage
    int control = 0;                   ///< solver::ConstraintKind
    std::int64_t controlled = 0;       ///< index of the controlled output or load, if any
    bool user_control_failed = false;  ///< the user-selected control has failed; the solver continues with another one
    bool on_branch = false;            ///< the path has switched to a secondary branch
    int pending_factorizations = 0;    ///< factorisations since the last row, counted for the next one
    /// Excess negative pivots of the last tangent; the inertia of the next one is compared with it.
    int confirmed_pivots = 0;
    std::optional<StatePoint> before;
    StatePoint last;
    double step = 0, first_step = 0;  ///< of q
    double size = 0;                  ///< largest norm of the unknowns at a row
    double dissipated_J = 0;          ///< set free by snaps, for the modelled part of the actuator
    std::vector<double> friction;     ///< fem::Contact::friction_start() at `last`
    std::vector<double> internal;     ///< fem::InternalVariables::gather() at `last`
    double work_before_stage_J = 0;   ///< work of the loads before the stage, for the modelled part of the actuator
    double first_slope = 0;           ///< norm of the path tangent per load factor at the start of the stage
    /// [row of the stage x 32]: sketches of states and tangents (solver/visited_states.hpp).
    std::vector<double> visited;
    PathEnd so_far;  ///< limit points and counts so far; `reason` is not yet meaningful
};

}  // namespace soft::model
