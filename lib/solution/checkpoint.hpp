#pragma once
/// What the solver must remember to go on from a row of the path as if it had never stopped. Plain data that io keeps
/// behind each row of a running `solve -o`. Held by io/journal_test and pipeline Resume.
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
    double load_factor = 0;
    double tangent_load_factor = 0;
    double q = 0;                               ///< controlled quantity
    std::optional<int> excess_pivots;
};

struct Checkpoint {
    int ranks = 1;                              ///< the numbering of the unknowns is that of so many ranks
    int rows = 0;                               ///< of the path, up to and with `last`
    int control = 0;                            ///< solver::ConstraintKind
    std::int64_t control_output = 0;            ///< index of the output, where one is controlled
    std::optional<StatePoint> before;
    StatePoint last;
    double step = 0, first_step = 0;            ///< of q
    PathEnd so_far;                             ///< limit points and counts; its reason has no meaning yet
};

}  // namespace soft::solution
