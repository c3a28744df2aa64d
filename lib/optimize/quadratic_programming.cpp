#include <algorithm>
#include <cmath>
#include <exception>
#include <nlopt.hpp>

#include "optimize/record.hpp"

namespace soft::optimize {
namespace {

constexpr int max_trials_of_a_start = 40, max_restarts = 12;
constexpr double step_tolerance = 1e-4;
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

/// A run of the optimizer in a box about a start. The largest violation t is one more variable: minimize t with all g <= t.
class Box {
public:
    /// Raises `best`, the best trial of this start.
    Box(const Goal& goal, Record& record, Minimize minimize, const std::vector<double>& start, double half,
        std::optional<Found>& best)
        : goal_(goal),
          record_(record),
          best_(best),
          cube_(goal, start),
          point_(cube_.start()),
          is_violation_(minimize == Minimize::largest_violation),
          constraints_(inequalities(goal, minimize)) {
        for (const double u : point_) {
            low_.push_back(std::max(0.0, u - half));
            high_.push_back(std::min(1.0, u + half));
        }
        if (!is_violation_) return;
        point_.push_back(best->violation);
        low_.push_back(0);
        high_.push_back(HUGE_VAL);
    }

    InBox run();

private:
    const Trial& trial_at(const double* u) {
        std::vector<double> values = cube_.values_at(u);
        const Trial& trial = record_.at(values);
        if (!trial.failure.empty()) throw TrialFailed();
        const Found found = record_.found_of(values, trial);
        if (!best_ || record_.is_better(found, *best_)) best_ = found;
        return trial;
    }
    double objective(const double* u, double* gradient) {
        const std::size_t n = cube_.size();
        if (is_violation_) {
            if (gradient != nullptr) std::fill_n(gradient, n, 0.0);
            if (gradient != nullptr) gradient[n] = 1;
            return u[n];
        }
        std::vector<double> slopes;
        const double value = scale_ * record_.objective(trial_at(u), gradient == nullptr ? nullptr : &slopes);
        if (gradient != nullptr) cube_.fill(slopes, scale_, gradient);
        return value;
    }
    void differences(double* result, const double* u, double* gradient) {
        const Trial& trial = trial_at(u);
        const std::size_t n = cube_.size();
        for (std::size_t i = 0; i < constraints_.size(); ++i) {
            const auto& [condition, sign, bound] = constraints_[i];
            const double unit = 1 / goal_.conditions[condition].scale_SI;
            result[i] = sign * trial.conditions[condition].value_SI * unit - bound - (is_violation_ ? u[n] : 0);
            if (gradient == nullptr) continue;
            double* row = gradient + i * point_.size();
            cube_.fill(trial.conditions[condition].gradient, sign * unit, row);
            if (is_violation_) row[n] = -1;
        }
    }
    /// An exception does not pass through NLopt: it is kept, the search is stopped, and it is thrown again.
    void keep_exception(const auto& work) {
        try {
            work();
        } catch (...) {
            thrown_ = std::current_exception();
            throw nlopt::forced_stop();
        }
    }
    static double objective_of(unsigned, const double* u, double* gradient, void* box) {
        double value = 0;
        auto& own = *static_cast<Box*>(box);
        own.keep_exception([&] { value = own.objective(u, gradient); });
        return value;
    }
    static void differences_of(unsigned, double* result, unsigned, const double* u, double* gradient, void* box) {
        auto& own = *static_cast<Box*>(box);
        own.keep_exception([&] { own.differences(result, u, gradient); });
    }

    const Goal& goal_;
    Record& record_;
    std::optional<Found>& best_;
    UnitCube cube_;
    std::vector<double> point_, low_, high_;
    bool is_violation_;
    std::vector<Inequality> constraints_;
    double scale_ = 1;
    std::exception_ptr thrown_;
};

InBox Box::run() {
    const double first = std::abs(record_.objective(trial_at(point_.data()), nullptr));
    if (first > 0) scale_ = 1 / first;
    nlopt::opt optimizer(nlopt::LD_SLSQP, static_cast<unsigned>(point_.size()));
    optimizer.set_lower_bounds(low_);
    optimizer.set_upper_bounds(high_);
    optimizer.set_min_objective(objective_of, this);
    if (!constraints_.empty())
        optimizer.add_inequality_mconstraint(differences_of, this, std::vector<double>(constraints_.size(), 0.0));
    optimizer.set_xtol_rel(step_tolerance);
    optimizer.set_maxeval(max_trials_of_a_start);
    double smallest = 0;
    try {
        static_cast<void>(optimizer.optimize(point_, smallest));
    } catch (const nlopt::forced_stop&) {
        std::rethrow_exception(thrown_);
    } catch (const std::runtime_error&) {  // "nlopt failure", roundoff: no progress from here
    }
    for (std::size_t k = 0; k < cube_.size(); ++k) {
        constexpr double at_bound = 1e-6;
        const bool stopped_low = point_[k] - low_[k] < at_bound && low_[k] > 0,
                   stopped_high = high_[k] - point_[k] < at_bound && high_[k] < 1;
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
            if (Box(goal, record, minimize, centre, half, best).run() == InBox::ends_inside) return;
        } catch (const TrialFailed&) {
            half *= 0.5;
        }
        if (best) centre = best->values;
        if (minimize == Minimize::largest_violation && record.of_conditions(best->trial) == 0) return;
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
    const auto is_violated = [&] { return goal.minimize && best && record.of_conditions(best->trial) > 0; };
    if (!is_violated()) return;
    run_in_boxes(goal, record, Minimize::largest_violation, std::vector(best->values), best);
    if (!is_violated()) run_in_boxes(goal, record, Minimize::objective, std::vector(best->values), best);
}

}  // namespace soft::optimize
