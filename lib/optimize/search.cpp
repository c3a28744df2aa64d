#include "optimize/search.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <map>
#include <nlopt.hpp>
#include <set>

#include "core/error.hpp"
#include "sweep/sampling.hpp"

namespace soft::optimize {
namespace {

constexpr int max_trials_of_a_start = 40, max_restarts = 12;
constexpr double step_tolerance = 1e-4, value_tolerance = 1e-4;
/// Equalities are aimed at within this share of what is allowed.
constexpr double aim = 0.5;

/// A failed trial ends a run of the optimizer.
struct TrialFailed {};

class Search {
public:
    Search(const Goal& goal, const Evaluate& evaluate, const Progress& progress)
        : goal_(goal), evaluate_(evaluate), progress_(progress) {
        for (std::size_t i = 0; i < goal.variables.size(); ++i)
            (goal.variables[i].is_whole ? whole_ : continuous_).push_back(i);
    }

    /// From values whose whole numbers stay.
    void run_from(const std::vector<double>& values) {
        if (continuous_.empty()) {
            static_cast<void>(at(values));
            return;
        }
        std::vector<double> centre = values;
        double half = 1;
        for (int restart = 0; restart < max_restarts; ++restart) {
            try {
                if (run_in_box(centre, half) == InBox::ends_inside) return;
            } catch (const TrialFailed&) {
                half *= 0.5;
            }
            centre = nearest_success(values).value_or(values);
        }
    }

    /// Neighbours of the best whole numbers, until none is better.
    void try_neighbours() {
        std::set<std::vector<double>> tried;
        for (bool improves = !whole_.empty(); improves;) {
            improves = false;
            const std::vector<double> centre = best_->values;
            for (const std::size_t i : whole_)
                for (const double change : {-1.0, 1.0}) {
                    std::vector<double> next = centre;
                    next[i] += change;
                    if (next[i] < goal_.variables[i].from || next[i] > goal_.variables[i].to) continue;
                    std::vector<double> numbers;
                    for (const std::size_t k : whole_) numbers.push_back(next[k]);
                    if (!tried.insert(numbers).second) continue;
                    const Found before = *best_;
                    run_from(next);
                    improves = improves || is_better(*best_, before);
                }
        }
    }

    [[nodiscard]] bool is_met() const { return best_ && best_->violation <= 0; }

    [[nodiscard]] Found result() const {
        if (!best_)
            throw Error(ExitCode::bad_input, "", "no trial succeeds: " + first_failure_, "change the ranges of `vary`");
        Found found = *best_;
        found.trials = static_cast<int>(trials_.size());
        return found;
    }

private:
    [[nodiscard]] double range(std::size_t i) const { return goal_.variables[i].to - goal_.variables[i].from; }

    [[nodiscard]] Found found_of(const std::vector<double>& values, const Trial& trial) const {
        Found found{values, trial, goal_.stable && !trial.is_stable ? 1.0 : 0.0, static_cast<int>(trials_.size())};
        for (std::size_t i = 0; i < goal_.conditions.size(); ++i)
            found.violation =
                std::max(found.violation, violation_of(goal_.conditions[i], trial.conditions[i].value_SI));
        return found;
    }

    const Trial& at(const std::vector<double>& values) {
        if (const auto known = trials_.find(values); known != trials_.end()) return known->second;
        const Trial& trial = trials_.emplace(values, evaluate_(values)).first->second;
        if (!trial.failure.empty()) {
            if (first_failure_.empty()) first_failure_ = trial.failure;
            return trial;
        }
        const Found found = found_of(values, trial);
        if (!best_ || is_better(found, *best_)) {
            best_ = found;
            progress_(*best_);
        }
        return trial;
    }

    /// Fewer violations, then the smaller objective.
    [[nodiscard]] bool is_better(const Found& a, const Found& b) const {
        if (a.violation != b.violation && std::max(a.violation, b.violation) > 0) return a.violation < b.violation;
        return objective(a.trial, nullptr) < objective(b.trial, nullptr);
    }

    /// The measure to be minimized, or the sum of the squared differences from the targets over what is allowed; gradient by the variables, SI.
    double objective(const Trial& trial, std::vector<double>* gradient) const {
        if (goal_.minimize) {
            if (gradient != nullptr) *gradient = trial.objective.gradient;
            return trial.objective.value_SI;
        }
        double sum = 0;
        if (gradient != nullptr) gradient->assign(goal_.variables.size(), 0.0);
        for (std::size_t i = 0; i < goal_.conditions.size(); ++i) {
            const Condition& condition = goal_.conditions[i];
            if (condition.relation != Condition::Relation::equal) continue;
            const double allowed = condition.within * condition.value_SI,
                         off = (trial.conditions[i].value_SI - condition.value_SI) / allowed;
            sum += off * off;
            if (gradient != nullptr)
                for (std::size_t k = 0; k < gradient->size(); ++k)
                    (*gradient)[k] += 2 * off * trial.conditions[i].gradient[k] / allowed;
        }
        return sum;
    }

    /// The conditions as g <= 0: an equality is two of them. Without an objective the equalities are the objective.
    struct Inequality {
        std::size_t condition;
        double sign, bound;  ///< sign value / |wanted| - bound
    };
    [[nodiscard]] std::vector<Inequality> inequalities() const {
        std::vector<Inequality> all;
        for (std::size_t i = 0; i < goal_.conditions.size(); ++i) {
            const Condition& c = goal_.conditions[i];
            const double unit = c.value_SI > 0 ? 1 : c.value_SI < 0 ? -1 : 0;
            if (c.relation == Condition::Relation::below) all.push_back({i, 1, unit});
            if (c.relation == Condition::Relation::above) all.push_back({i, -1, -unit});
            if (c.relation == Condition::Relation::equal && goal_.minimize) {
                all.push_back({i, 1, unit + aim * c.within});
                all.push_back({i, -1, -unit + aim * c.within});
            }
        }
        return all;
    }

    /// Whether the search could continue beyond a side of the box.
    enum class InBox { ends_inside, ends_at_its_side };
    [[nodiscard]] InBox run_in_box(const std::vector<double>& start, double half) {
        const std::size_t n = continuous_.size();
        std::vector<double> point(n), low(n), high(n);
        for (std::size_t k = 0; k < n; ++k) {
            const Variable& variable = goal_.variables[continuous_[k]];
            point[k] = (start[continuous_[k]] - variable.from) / range(continuous_[k]);
            low[k] = std::max(0.0, point[k] - half);
            high[k] = std::min(1.0, point[k] + half);
        }
        const auto values_of = [&](const double* u) {
            std::vector<double> values = start;
            for (std::size_t k = 0; k < n; ++k)
                values[continuous_[k]] = goal_.variables[continuous_[k]].from + u[k] * range(continuous_[k]);
            return values;
        };
        const auto trial_at = [&](const double* u) -> const Trial& {
            const Trial& trial = at(values_of(u));
            if (!trial.failure.empty()) throw TrialFailed();
            return trial;
        };
        const auto fill = [&](const std::vector<double>& gradient, double factor, double* out) {
            for (std::size_t k = 0; k < n; ++k) out[k] = factor * gradient[continuous_[k]] * range(continuous_[k]);
        };
        const double first = std::abs(objective(trial_at(point.data()), nullptr));
        const double scale = first > 0 ? 1 / first : 1;
        const std::vector<Inequality> constraints = inequalities();

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
            double found = 0;
            kept([&] {
                std::vector<double> slopes;
                found = scale * objective(trial_at(u), gradient == nullptr ? nullptr : &slopes);
                if (gradient != nullptr) fill(slopes, scale, gradient);
            });
            return found;
        };
        using Constraints = std::function<void(double*, const double*, double*)>;
        Constraints differences = [&](double* result, const double* u, double* gradient) {
            kept([&] {
                const Trial& trial = trial_at(u);
                for (std::size_t i = 0; i < constraints.size(); ++i) {
                    const auto& [condition, sign, bound] = constraints[i];
                    const double wanted = std::abs(goal_.conditions[condition].value_SI),
                                 unit = wanted > 0 ? 1 / wanted : 1;
                    result[i] = sign * trial.conditions[condition].value_SI * unit - bound;
                    if (gradient != nullptr) fill(trial.conditions[condition].gradient, sign * unit, gradient + i * n);
                }
            });
        };
        nlopt::opt optimizer(nlopt::LD_SLSQP, static_cast<unsigned>(n));
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

    /// The best trial so far with the same whole numbers.
    [[nodiscard]] std::optional<std::vector<double>> nearest_success(const std::vector<double>& values) const {
        std::optional<Found> best;
        for (const auto& [at_values, trial] : trials_) {
            const bool same = std::ranges::all_of(whole_, [&](std::size_t i) { return at_values[i] == values[i]; });
            if (!same || !trial.failure.empty()) continue;
            Found found = found_of(at_values, trial);
            if (!best || is_better(found, *best)) best = std::move(found);
        }
        return best ? std::optional(best->values) : std::nullopt;
    }

    const Goal& goal_;
    const Evaluate& evaluate_;
    const Progress& progress_;
    std::vector<std::size_t> whole_, continuous_;
    std::map<std::vector<double>, Trial> trials_;
    std::optional<Found> best_;
    std::string first_failure_;
};

}  // namespace

double violation_of(const Condition& condition, double value_SI) {
    const double wanted = condition.value_SI, scale = wanted == 0 ? 1 : std::abs(wanted);
    constexpr double rounding = 1e-6;
    switch (condition.relation) {
        case Condition::Relation::equal: return std::max(0.0, std::abs(value_SI - wanted) / scale - condition.within);
        case Condition::Relation::below: return std::max(0.0, (value_SI - wanted) / scale - rounding);
        case Condition::Relation::above: return std::max(0.0, (wanted - value_SI) / scale - rounding);
    }
    return 0;
}

Found search(const Goal& goal, const std::vector<double>& first, int starts, const Evaluate& evaluate,
             const Progress& progress) {
    Search search(goal, evaluate, progress);
    std::vector<double> start = first;
    for (std::size_t i = 0; i < start.size(); ++i)
        start[i] = std::clamp(start[i], goal.variables[i].from, goal.variables[i].to);
    search.run_from(start);
    const auto points = sweep::latin_hypercube({std::max(1, starts - 1), static_cast<int>(start.size())}, 1);
    for (int k = 0; k + 1 < starts; ++k) {
        if (search.is_met() && !goal.minimize) break;
        std::vector<double> point = start;
        for (std::size_t i = 0; i < point.size(); ++i) {
            const Variable& variable = goal.variables[i];
            point[i] = variable.from + points[static_cast<std::size_t>(k)][i] * (variable.to - variable.from);
            if (variable.is_whole) point[i] = std::round(point[i]);
        }
        search.run_from(point);
    }
    static_cast<void>(search.result());  // refuses a goal without any success
    if (!search.is_met() || goal.minimize) search.try_neighbours();
    return search.result();
}

}  // namespace soft::optimize
