#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <nlopt.hpp>

#include "optimize/record.hpp"

namespace soft::optimize {
namespace {

/// Of the largest violation, relative to an objective of order one.
constexpr double penalty = 10;
/// Of trials that fail before the first one that succeeds; later ones are a little worse than the worst.
constexpr double worst_at_first = 1e3;

/// All variables, each whole number with an equal share of its side of the unit cube.
std::vector<double> values_at(const Goal& goal, const double* u) {
    std::vector<double> values;
    for (const Variable& variable : goal.variables) {
        const double at = variable.is_whole ? std::floor(u[values.size()] * (variable.range() + 1)) : 0;
        values.push_back(variable.is_whole ? variable.from + std::min(at, variable.range())
                                           : variable.from + u[values.size()] * variable.range());
    }
    return values;
}

}  // namespace

void run_global(const Goal& goal, Record& record, int trials, const std::function<bool()>& is_met) {
    double scale = 0, worst = worst_at_first;
    std::exception_ptr thrown;
    std::function<double(const double*)> merit = [&](const double* u) {
        const std::vector<double> values = values_at(goal, u);
        const Trial& trial = record.at(values);
        if (!trial.failure.empty()) return worst + 1;
        const double objective = record.objective(trial, nullptr);
        if (scale == 0 && objective != 0) scale = 1 / std::abs(objective);
        const double found = (goal.minimize ? scale * objective : std::log1p(objective)) +
                             penalty * record.found_of(values, trial).violation;
        worst = worst == worst_at_first ? found : std::max(worst, found);
        return found;
    };
    // An exception does not pass through NLopt.
    std::function<double(const double*)> kept = [&](const double* u) {
        try {
            if (is_met()) throw nlopt::forced_stop();
            return merit(u);
        } catch (...) {
            thrown = std::current_exception();
            throw nlopt::forced_stop();
        }
    };
    const auto n = static_cast<unsigned>(goal.variables.size());
    nlopt::opt optimizer(nlopt::GN_DIRECT_L, n);
    optimizer.set_lower_bounds(0.0);
    optimizer.set_upper_bounds(1.0);
    optimizer.set_maxeval(trials);
    optimizer.set_min_objective(
        [](unsigned, const double* u, double*, void* data) {
            return (*static_cast<std::function<double(const double*)>*>(data))(u);
        },
        &kept);
    std::vector<double> point(n, 0.5);
    double smallest = 0;
    try {
        static_cast<void>(optimizer.optimize(point, smallest));
    } catch (const nlopt::forced_stop&) {
        if (!is_met()) std::rethrow_exception(thrown);
    } catch (const std::runtime_error&) {  // no progress
    }
}

}  // namespace soft::optimize
