#pragma once
/// What the solver must remember to go on from a row of the path as if it had never stopped. Plain data that io keeps
/// behind each row of a running `solve -o`. Tested by io/journal_test and pipeline Resume.
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "solution/path.hpp"

namespace soft::solution {

/// A converged state in the solver's own unknowns (displacements and scaled pressures, in its numbering), with the
/// direction of the path there.
struct StatePoint {
    std::vector<double> unknowns, tangent_unknowns;
    std::vector<double> pressures_Pa, tangent_pressures;  ///< of the supplies whose pressure is unknown
    double load_factor = 0;
    double tangent_load_factor = 0;
    double power = 0;             ///< work of the growing loads along the tangent
    std::vector<double> outputs;  ///< angles may exceed a full turn
    double q = 0;                 ///< controlled quantity
    double load_work_J = 0;       ///< since the path began, of the modelled part
    std::optional<int> unstable_modes;
};

/// The loads where a stage begins, one entry a load.
struct StageStart {
    std::vector<double> pressures_Pa, volumes_m3, masses_kg;
    std::vector<double> tractions, body_forces, motions;  ///< levels
};

struct Checkpoint {
    int ranks = 1;  ///< the numbering of the unknowns is that of so many ranks
    int rows = 0;   ///< of the path, up to and with `last`
    int stage = 0;
    int stage_first_row = 0;         ///< row where the stage begins
    StageStart start;                ///< of the stage
    int control = 0;                 ///< solver::ConstraintKind
    std::int64_t controlled = 0;     ///< index of the output or load, where one is controlled
    bool chosen_is_left = false;     ///< the user's control has failed, another shows why
    bool on_branch = false;          ///< a secondary branch has been taken
    int pending_factorizations = 0;  ///< made since the last row, for the next one
    int confirmed_pivots = 0;        ///< what the inertia of the next tangent is compared to
    std::optional<StatePoint> before;
    StatePoint last;
    double step = 0, first_step = 0;  ///< of q
    double work_before_stage_J = 0;   ///< done by the loads before the stage, of the modelled part
    double first_slope = 0;           ///< size of the path's direction per load factor where the stage began
    std::vector<double>
        visited;     ///< [row of the stage x 32]: sketches of states and tangents (solver/visited_states.hpp)
    PathEnd so_far;  ///< limit points and counts; its reason has no meaning yet
};

}  // namespace soft::solution
