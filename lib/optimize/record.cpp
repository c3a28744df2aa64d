#include "optimize/record.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace soft::optimize {

Record::Record(const Goal& goal, const Evaluate& evaluate, const Progress& progress)
    : goal_(goal), evaluate_(evaluate), progress_(progress) {}

const Trial& Record::at(const std::vector<double>& values) {
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

Found Record::found_of(const std::vector<double>& values, const Trial& trial) const {
    return {values, trial, std::max(of_bounds(trial), of_conditions(trial)), static_cast<int>(trials_.size())};
}

double Record::of_conditions(const Trial& trial) const {
    double largest = 0;
    for (std::size_t i = 0; i < goal_.conditions.size(); ++i)
        largest = std::max(largest, violation_of(goal_.conditions[i], trial.conditions[i].value_SI));
    return largest;
}

double Record::of_bounds(const Trial& trial) const {
    double violation = goal_.stable && !trial.is_stable ? 1.0 : 0.0;
    for (std::size_t i = 0; i < goal_.conditions.size(); ++i)
        if (goal_.conditions[i].relation != Condition::Relation::equal)
            violation = std::max(violation, violation_of(goal_.conditions[i], trial.conditions[i].value_SI));
    return violation;
}

bool Record::is_better(const Found& a, const Found& b) const {
    const double of_a = goal_.minimize ? a.violation : of_bounds(a.trial),
                 of_b = goal_.minimize ? b.violation : of_bounds(b.trial);
    if (of_a != of_b) return of_a < of_b;
    const bool is_met_a = a.violation == 0, is_met_b = b.violation == 0;
    if (!goal_.minimize && is_met_a != is_met_b) return is_met_a;
    return objective(a.trial, nullptr) < objective(b.trial, nullptr);
}

double Record::objective(const Trial& trial, std::vector<double>* gradient) const {
    if (goal_.minimize) {
        if (gradient != nullptr) *gradient = trial.objective.gradient;
        return trial.objective.value_SI;
    }
    double sum = 0;
    if (gradient != nullptr) gradient->assign(goal_.variables.size(), 0.0);
    for (std::size_t i = 0; i < goal_.conditions.size(); ++i) {
        const Condition& condition = goal_.conditions[i];
        if (condition.relation != Condition::Relation::equal) continue;
        const double off = (trial.conditions[i].value_SI - condition.value_SI) / condition.allowed_SI();
        sum += off * off;
        if (gradient != nullptr)
            for (std::size_t k = 0; k < gradient->size(); ++k)
                (*gradient)[k] += 2 * off * trial.conditions[i].gradient[k] / condition.allowed_SI();
    }
    return sum;
}

Found Record::result() const {
    if (!best_)
        throw Error(ExitCode::bad_input, "", "no trial succeeds: " + first_failure_, "change the ranges of `vary`");
    Found found = *best_;
    found.trials = static_cast<int>(trials_.size());
    return found;
}

UnitCube::UnitCube(const Goal& goal, std::vector<double> start) : goal_(goal), start_(std::move(start)) {
    for (std::size_t i = 0; i < goal.variables.size(); ++i)
        if (!goal.variables[i].is_whole) variables_.push_back(i);
}

std::vector<double> UnitCube::start() const {
    std::vector<double> u;
    for (const std::size_t i : variables_)
        u.push_back((start_[i] - goal_.variables[i].from) / goal_.variables[i].range());
    return u;
}

std::vector<double> UnitCube::values_at(const double* u) const {
    std::vector<double> values = start_;
    for (std::size_t k = 0; k < size(); ++k) {
        const Variable& variable = goal_.variables[variables_[k]];
        values[variables_[k]] = variable.from + u[k] * variable.range();
    }
    return values;
}

void UnitCube::fill(const std::vector<double>& gradient, double factor, double* out) const {
    for (std::size_t k = 0; k < size(); ++k)
        out[k] = factor * gradient[variables_[k]] * goal_.variables[variables_[k]].range();
}

}  // namespace soft::optimize
