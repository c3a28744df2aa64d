#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <nlopt.hpp>

#include "optimize/record.hpp"

namespace soft::optimize {
namespace {

constexpr int max_trials_of_a_start = 40, max_restarts = 12;
constexpr double step_tolerance = 1e-4, value_tolerance = 1e-4;
/// Gain of the objective by a restart, below which no other follows.
constexpr double restart_tolerance = 1e-3;
/// Half the side of the smallest box around a trial that meets all conditions.
constexpr double smallest_half = 5e-3;
/// Equalities are aimed at within this share of what is allowed.
constexpr double aim = 0.5;

/// A failed trial ends a run of the optimizer.
struct TrialFailed {};

/// What a run of the optimizer minimizes: the objective under the conditions, or the largest violation of a condition.
enum class Minimize { objective, largest_violation };

/// The conditions as g <= 0: an equality is two of them. Without an objective the equalities are the objective.
struct Inequality {
    std::size_t condition;
    double sign, bound;  ///< sign value / scale - bound
};
std::vector<Inequality> inequalities(const Goal& goal, Minimize minimize) {
    const double aimed = minimize == Minimize::objective ? aim : 1.0;
    std::vector<Inequality> all;
    for (std::size_t i = 0; i < goal.conditions.size(); ++i) {
        const Condition& c = goal.conditions[i];
        const double unit = c.value_SI / c.scale_SI;
        if (c.relation == Condition::Relation::below) all.push_back({i, 1, unit});
        if (c.relation == Condition::Relation::above) all.push_back({i, -1, -unit});
        if (c.relation == Condition::Relation::equal && goal.minimize) {
            all.push_back({i, 1, unit + aimed * c.within});
            all.push_back({i, -1, -unit + aimed * c.within});
        }
    }
    return all;
}

/// Whether the search could continue beyond a side of the box.
enum class InBox { ends_inside, ends_at_its_side };
/// Raises `best`, the best trial of this start. The largest violation t is one more variable: minimize t, all g <= t.
InBox run_in_box(const Goal& goal, Record& record, Minimize minimize, const std::vector<double>& start, double half,
                 std::optional<Found>& best) {
    const UnitCube cube(goal, start);
    const std::size_t n = cube.size();
    std::vector<double> point = cube.start(), low(n), high(n);
    for (std::size_t k = 0; k < n; ++k) {
        low[k] = std::max(0.0, point[k] - half);
        high[k] = std::min(1.0, point[k] + half);
    }
    const auto trial_at = [&](const double* u) -> const Trial& {
        std::vector<double> values = cube.values_at(u);
        const Trial& trial = record.at(values);
        if (!trial.failure.empty()) throw TrialFailed();
        const Found found = record.found_of(values, trial);
        if (!best || record.is_better(found, *best)) best = found;
        return trial;
    };
    const double first = std::abs(record.objective(trial_at(point.data()), nullptr));
    const double scale = first > 0 ? 1 / first : 1;
    const std::vector<Inequality> constraints = inequalities(goal, minimize);
    const bool is_violation = minimize == Minimize::largest_violation;
    if (is_violation) {
        low.push_back(0);
        high.push_back(HUGE_VAL);
        point.push_back(best->violation);
    }
    const std::size_t all = point.size();

    // An exception does not pass through NLopt: it is kept, the search is stopped, and it is thrown again.
    std::exception_ptr thrown;
    const auto kept = [&thrown](const auto& work) {
        try {
            work();
        } catch (...) {
            thrown = std::current_exception();
            throw nlopt::forced_stop();
        }
    };
    using Objective = std::function<double(const double*, double*)>;
    Objective value = [&](const double* u, double* gradient) {
        if (is_violation) {
            if (gradient != nullptr) std::fill_n(gradient, n, 0.0);
            if (gradient != nullptr) gradient[n] = 1;
            return u[n];
        }
        double found = 0;
        kept([&] {
            std::vector<double> slopes;
            found = scale * record.objective(trial_at(u), gradient == nullptr ? nullptr : &slopes);
            if (gradient != nullptr) cube.fill(slopes, scale, gradient);
        });
        return found;
    };
    using Constraints = std::function<void(double*, const double*, double*)>;
    Constraints differences = [&](double* result, const double* u, double* gradient) {
        kept([&] {
            const Trial& trial = trial_at(u);
            for (std::size_t i = 0; i < constraints.size(); ++i) {
                const auto& [condition, sign, bound] = constraints[i];
                const double unit = 1 / goal.conditions[condition].scale_SI;
                result[i] = sign * trial.conditions[condition].value_SI * unit - bound - (is_violation ? u[n] : 0);
                if (gradient == nullptr) continue;
                cube.fill(trial.conditions[condition].gradient, sign * unit, gradient + i * all);
                if (is_violation) gradient[i * all + n] = -1;
            }
        });
    };
    nlopt::opt optimizer(nlopt::LD_SLSQP, static_cast<unsigned>(all));
    optimizer.set_lower_bounds(low);
    optimizer.set_upper_bounds(high);
    optimizer.set_min_objective([](unsigned, const double* u, double* gradient,
                                   void* data) { return (*static_cast<const Objective*>(data))(u, gradient); },
                                &value);
    if (!constraints.empty())
        optimizer.add_inequality_mconstraint(
            [](unsigned, double* result, unsigned, const double* u, double* gradient, void* data) {
                (*static_cast<const Constraints*>(data))(result, u, gradient);
            },
            &differences, std::vector<double>(constraints.size(), 0.0));
    optimizer.set_xtol_rel(step_tolerance);
    optimizer.set_ftol_rel(value_tolerance);
    optimizer.set_maxeval(max_trials_of_a_start);
    double smallest = 0;
    try {
        static_cast<void>(optimizer.optimize(point, smallest));
    } catch (const nlopt::forced_stop&) {
        std::rethrow_exception(thrown);
    } catch (const std::runtime_error&) {  // "nlopt failure", roundoff: no progress from here
    }
    for (std::size_t k = 0; k < n; ++k) {
        constexpr double at_bound = 1e-6;
        const bool stopped_low = point[k] - low[k] < at_bound && low[k] > 0,
                   stopped_high = high[k] - point[k] < at_bound && high[k] < 1;
        if (stopped_low || stopped_high) return InBox::ends_at_its_side;
    }
    return InBox::ends_inside;
}

/// Runs in boxes that follow the best trial and halve where a trial fails.
void run_in_boxes(const Goal& goal, Record& record, Minimize minimize, const std::vector<double>& start,
                  std::optional<Found>& best) {
    std::vector<double> centre = start;
    double half = 1;
    for (int restart = 0; restart < max_restarts; ++restart) {
        const std::optional<Found> before = best;
        try {
            if (run_in_box(goal, record, minimize, centre, half, best) == InBox::ends_inside) return;
        } catch (const TrialFailed&) {
            half *= 0.5;
        }
        if (best) centre = best->values;
        if (before && before->violation <= 0 && goal.minimize) {  // what limits the trials is where they fail
            const double was = record.objective(before->trial, nullptr), is = record.objective(best->trial, nullptr);
            const bool gains_little = is != was && std::abs(is - was) <= restart_tolerance * std::abs(was);
            if (gains_little || half < smallest_half) return;
        }
    }
}

}  // namespace

void run_quadratic_programming(const Goal& goal, Record& record, const std::vector<double>& start) {
    std::optional<Found> best;
    run_in_boxes(goal, record, Minimize::objective, start, best);
    const auto is_violated = [&] { return goal.minimize && best && best->violation > 0; };
    if (!is_violated()) return;
    run_in_boxes(goal, record, Minimize::largest_violation, std::vector(best->values), best);
    if (!is_violated()) run_in_boxes(goal, record, Minimize::objective, std::vector(best->values), best);
}

}  // namespace soft::optimize
