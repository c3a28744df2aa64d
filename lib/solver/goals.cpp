#include "solver/goals.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "solver/path_text.hpp"

namespace soft::solver {

namespace {

/// The quantity of one goal as a function of q.
struct Scalar {
    const Goal& goal;
    const PathPoint* before;  // nullptr: tangent line at `last`
    const PathPoint& last;

    [[nodiscard]] double operator()(double q) const {
        const double value = value_of(goal.constraint, last), slope = slope_of(goal.constraint, last);
        if (before == nullptr) return value + (q - last.q) * slope;
        return hermite(hermite_weights(before->q, last.q, q), value_of(goal.constraint, *before),
                       slope_of(goal.constraint, *before), value, slope);
    }
};

/// First q in (begin, end] where the curve reaches the goal; by sampling, then bisection: a cubic has at most three roots.
std::optional<double> first_meeting(const Scalar& curve, double begin, double end) {
    constexpr int samples = 16;
    const double target = curve.goal.target;
    double low = begin, low_side = curve(begin) - target;
    for (int i = 1; i <= samples; ++i) {
        double high = begin + (end - begin) * i / samples;
        const double side = curve(high) - target;
        if (side == 0.0) return high;
        if (low_side * side < 0.0) {
            for (int step = 0; step < 60; ++step) {
                const double middle = 0.5 * (low + high);
                ((curve(middle) - target) * low_side > 0.0 ? low : high) = middle;
            }
            return high;
        }
        low = high;
        low_side = side;
    }
    return std::nullopt;
}

std::optional<Crossing> first_reached(const std::vector<Goal>& goals, const PathPoint* before, const PathPoint& last,
                                      double begin, double end) {
    std::optional<Crossing> first;
    for (const auto& goal : goals) {
        const bool is_extrapolated = begin == last.q;
        if (is_extrapolated && !goal.has_slope) continue;
        const auto q = first_meeting({goal, before, last}, begin, end);
        if (q && (!first || *q < first->q)) first = Crossing{&goal, *q};
    }
    return first;
}

Goal pressure_goal(const model::Case& input, const StageLoads& loads, double value, const std::string& key) {
    if (model::leading_load(input) != model::LeadingLoad::pressure)
        throw Error(ExitCode::bad_input, key, "the case has no pressure load", "set loads.cavity.pressure");
    const std::string text = "pressure of " + short_text(value * 1e-3) + " kPa";
    const auto& free = loads.free_supplies();
    if (!free.empty() && free.front() == 0) return {{ConstraintKind::pressure}, value, text};
    const double rate = loads.rate().pressures_Pa[0];
    if (rate == 0.0)
        throw Error(ExitCode::bad_input, key, "the first pressure does not change in this stage", "remove this goal");
    return {{ConstraintKind::load_factor}, (value - loads.start().pressures_Pa[0]) / rate, text};
}

Goal make_goal(const model::Case& input, const model::Until& until, const StageLoads& loads,
               const std::vector<double>& undeformed_volumes_m3) {
    const std::string key = "path.until." + until.quantity;
    if (until.quantity == "pressure") return pressure_goal(input, loads, until.value, key);
    if (until.quantity == "volume_ratio") {
        if (undeformed_volumes_m3.empty() || undeformed_volumes_m3[0] == 0.0)
            throw Error(ExitCode::bad_input, key, "no cavity is loaded", "remove this goal, or load a cavity");
        return {{ConstraintKind::volume},
                until.value * undeformed_volumes_m3[0],
                "volume ratio of " + short_text(until.value)};
    }
    const auto output = std::ranges::find(input.outputs, until.quantity, &model::Output::name);
    if (output == input.outputs.end())
        throw Error(ExitCode::bad_input, key, "no output has this name",
                    "use a name of outputs, or pressure, volume_ratio or steps");
    Constraint constraint{ConstraintKind::output};
    constraint.index = static_cast<std::size_t>(output - input.outputs.begin());
    const model::MeasureUnit& unit = model::unit_of(output->measure);
    return {constraint, until.value,
            until.quantity + " of " + short_text(until.value / unit.SI_per_shown) + " " + std::string{unit.shown},
            model::has_slope(output->measure)};
}

}  // namespace

std::vector<Goal> make_goals(const model::Case& input, int stage, const StageLoads& loads,
                             const std::vector<double>& undeformed_volumes_m3) {
    std::vector<Goal> goals{{{ConstraintKind::load_factor}, 1.0, "full load"}};
    for (const auto& until : input.path.stages.at(static_cast<std::size_t>(stage)).until)
        if (until.quantity != "steps") goals.push_back(make_goal(input, until, loads, undeformed_volumes_m3));
    for (auto& goal : goals) goal.constraint.scale = std::abs(goal.target);
    return goals;
}

std::optional<Crossing> first_predicted(const std::vector<Goal>& goals, const PathPoint* before, const PathPoint& last,
                                        double q_end) {
    return first_reached(goals, before, last, last.q, q_end);
}

std::optional<Crossing> first_between(const std::vector<Goal>& goals, const PathPoint& from, const PathPoint& to) {
    return first_reached(goals, &from, to, from.q, to.q);
}

}  // namespace soft::solver
