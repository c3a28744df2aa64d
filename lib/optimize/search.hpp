#pragma once
/// Searches for the values of a goal's variables, from the values of the design and from points of a Latin hypercube. Goals without an
/// objective and without bounds are least squares (Levenberg and Marquardt, by Ceres), others sequential quadratic programming (SLSQP of
/// NLopt; Kraft, ACM Trans. Math. Softw. 20 (1994) 262), which also continues least squares that end at the end of a range. A trial whose
/// geometry or path fails shortens the step, or continues the search from the best trial of the start in a box of half the size, which moves
/// along, as long as that gains something. A start whose first trial fails is replaced. Around whole numbers, neighbours are tried until none
/// is better.
/// On request a global search precedes the last one: dividing rectangles, locally biased (DIRECT-L of NLopt; Gablonsky and Kelley, J. Global
/// Optim. 21 (2001) 27), for goals with several optima, with steps and with many whole numbers.
/// If no trial meets all conditions, the nearest is returned: where something is minimized, that with the smallest largest violation
/// (relative to Condition::scale_SI), which is then minimized itself, and if that meets the conditions, the objective again; else, of those
/// that violate the bounds least, that with the smallest sum of squares of the differences from the targets over what is allowed. Variables
/// are divided by their range, conditions by Condition::scale_SI.
/// Tested by optimize/search_test.
#include <functional>

#include "optimize/trial.hpp"

namespace soft::optimize {

struct Found {
    std::vector<double> values;  ///< SI, of the variables
    Trial trial;
    double violation = 0;  ///< largest, beyond what is allowed; 0: all conditions are met
    int trials = 0;
};

/// How far a condition is from being met, relative; 0 or less: met. An equality is met within Condition::within.
[[nodiscard]] double violation_of(const Condition& condition, double value_SI);

using Evaluate = std::function<Trial(const std::vector<double>& values)>;
/// A trial that is better than all before.
using Progress = std::function<void(const Found&)>;

/// One of the points from which the search starts.
struct Starts {
    int count, index;
};
/// The trials of one start only, the same as in search(): for starts that run side by side.
void run_start(const Goal& goal, const std::vector<double>& first, const Starts& starts, const Evaluate& evaluate,
               const Progress& progress);

struct Effort {
    int starts = 3;
    int global_trials = 0;  ///< over the whole range, before the last search from the best trial
};

/// `first`: the values of the design. Throws Error (bad_input) if no trial succeeds, with the failure of the first one.
[[nodiscard]] Found search(const Goal& goal, const std::vector<double>& first, const Effort& effort,
                           const Evaluate& evaluate, const Progress& progress);

}  // namespace soft::optimize
