#pragma once
/// One trial of a goal: its designs with given values of the variables, solved, with all measures and their derivatives by the continuous
/// variables (solver/sensitivities.hpp; volumes: differences of both meshes). A quantity at a value of another one is interpolated along
/// the path; where all measures of the curve have one value in common, the path ends there. The derivative of stretch_p99, a quantile
/// over the cells, is that at the row's state, along the path from the neighbouring rows.
/// Tested by pipeline/inverse.
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "optimize/goal.hpp"
#include "solver/path.hpp"

namespace soft::optimize {

struct Trial {
    struct Value {
        double value_SI = 0;
        std::vector<double> gradient = {};  ///< by the variables, SI; 0 for whole numbers
    };
    std::string failure;              ///< why there are no values; empty otherwise
    std::vector<Value> conditions;    ///< in the order of the goal
    Value objective;                  ///< of Goal::minimize
    bool is_stable = true;            ///< up to the last value at which the curve is measured
    std::string objective_text = {};  ///< "22.3 mm"
};

/// The contact check of a system, as for solver::follow_path.
using MakeContactCheck = std::function<solver::ContactCheck(fem::System&)>;

struct Base {
    std::string text, source;  ///< of the design of a run
};

/// `bases`: one for each run. `values`: SI, of the variables. Throws Error (bad_input) for a goal that does not fit the design; a trial whose geometry or path fails
/// has a failure instead.
[[nodiscard]] Trial evaluate(const Goal& goal, std::span<const Base> bases, const std::vector<double>& values,
                             const MakeContactCheck& contact_check);

}  // namespace soft::optimize
