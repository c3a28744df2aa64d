#pragma once
/// Where a stage ends: at its full loads, or at a goal of `until`. Tested by solver/solver_test.
#include <optional>
#include <string>
#include <vector>

#include "solver/history.hpp"

namespace soft::solver {

/// A value that one quantity of the path has to reach.
struct Goal {
    Constraint constraint;  ///< prescribes the quantity at `target`; never arc
    double target = 0;
    std::string text;  ///< "elongation of 130 mm", for the message
    bool has_slope =
        true;  ///< whether the constraint can be solved for; otherwise its quantity is known at states alone
};

/// Throws Error (bad_input) for an `until` quantity that the case does not have.
[[nodiscard]] std::vector<Goal> make_goals(const model::Case& input, int stage, const StageLoads& loads,
                                           const std::vector<double>& undeformed_volumes_m3);

struct Crossing {
    const Goal* goal = nullptr;
    double q =
        0;  ///< where the cubic through the two points (or the tangent) meets the target; between two rows without slopes: about
};

/// The first goal with a slope reached for last.q < q <= q_end by the predictor from (`before`, `last`); nullopt if none is reached.
[[nodiscard]] std::optional<Crossing> first_predicted(const std::vector<Goal>& goals, const PathPoint* before,
                                                      const PathPoint& last, double q_end);

/// The first goal reached between two converged points.
[[nodiscard]] std::optional<Crossing> first_between(const std::vector<Goal>& goals, const PathPoint& from,
                                                    const PathPoint& to);

}  // namespace soft::solver
