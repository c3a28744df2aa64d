#include "optimize/search.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "optimize/record.hpp"
#include "sweep/sampling.hpp"

namespace soft::optimize {
namespace {

/// From values whose whole numbers stay.
void run_from(const Goal& goal, Record& record, const std::vector<double>& values) {
    const auto is_equality = [](const Condition& c) { return c.relation == Condition::Relation::equal; };
    if (std::ranges::all_of(goal.variables, &Variable::is_whole))
        static_cast<void>(record.at(values));
    else if (!goal.minimize && std::ranges::all_of(goal.conditions, is_equality))
        run_least_squares(goal, record, values);
    else
        run_quadratic_programming(goal, record, values);
}

/// Neighbours of the best whole numbers, until none is better.
void try_neighbours(const Goal& goal, Record& record) {
    std::vector<std::size_t> whole;
    for (std::size_t i = 0; i < goal.variables.size(); ++i)
        if (goal.variables[i].is_whole) whole.push_back(i);
    std::set<std::vector<double>> tried;
    for (bool improves = !whole.empty(); improves;) {
        improves = false;
        const std::vector<double> centre = record.best()->values;
        for (const std::size_t i : whole)
            for (const double change : {-1.0, 1.0}) {
                std::vector<double> next = centre;
                next[i] += change;
                if (next[i] < goal.variables[i].from || next[i] > goal.variables[i].to) continue;
                std::vector<double> numbers;
                for (const std::size_t k : whole) numbers.push_back(next[k]);
                if (!tried.insert(numbers).second) continue;
                const Found before = *record.best();
                run_from(goal, record, next);
                improves = improves || record.is_better(*record.best(), before);
            }
    }
}

/// The design for the first start; for the others one of a few points whose trial succeeds.
std::vector<double> start_point(const Goal& goal, Record& record, const std::vector<double>& first,
                                const Starts& starts) {
    constexpr unsigned attempts = 8;
    std::vector<double> point = first;
    for (unsigned attempt = 1; attempt <= attempts; ++attempt) {
        const auto points =
            sweep::latin_hypercube({std::max(1, starts.count - 1), static_cast<int>(first.size())}, attempt);
        for (std::size_t i = 0; i < point.size(); ++i) {
            const Variable& variable = goal.variables[i];
            if (starts.index > 0)
                point[i] = variable.from + points[static_cast<std::size_t>(starts.index) - 1][i] * variable.range();
            if (variable.is_whole) point[i] = std::round(point[i]);
            point[i] = std::clamp(point[i], variable.from, variable.to);
        }
        if (starts.index == 0 || record.at(point).failure.empty()) break;
    }
    return point;
}

}  // namespace

double violation_of(const Condition& condition, double value_SI) {
    const double off = (value_SI - condition.value_SI) / condition.scale_SI;
    constexpr double rounding = 1e-6;
    if (condition.is_data) return 0;
    switch (condition.relation) {
        case Condition::Relation::equal: return std::max(0.0, std::abs(off) - condition.within);
        case Condition::Relation::below: return std::max(0.0, off - rounding);
        case Condition::Relation::above: return std::max(0.0, -off - rounding);
    }
    return 0;
}

void run_start(const Goal& goal, const std::vector<double>& first, const Starts& starts, const Evaluate& evaluate,
               const Progress& progress) {
    Record record(goal, evaluate, progress);
    run_from(goal, record, start_point(goal, record, first, starts));
}

Found search(const Goal& goal, const std::vector<double>& first, const Effort& effort, const Evaluate& evaluate,
             const Progress& progress) {
    Record record(goal, evaluate, progress);
    const auto is_met = [&] {
        return !goal.minimize && !goal.has_data() && record.best() != nullptr && record.best()->violation <= 0;
    };
    for (int start = 0; start < effort.starts && !is_met(); ++start)
        run_from(goal, record, start_point(goal, record, first, {effort.starts, start}));
    if (effort.global_trials > 0 && !is_met()) {
        run_global(goal, record, effort.global_trials, is_met);
        if (record.best() != nullptr && !is_met()) run_from(goal, record, std::vector(record.best()->values));
    }
    static_cast<void>(record.result());  // refuses a goal without any success
    if (!is_met()) try_neighbours(goal, record);
    return record.result();
}

}  // namespace soft::optimize
