#include "solver/goals.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "core/error.hpp"

namespace soft::solver {

namespace {

/// The scalar curve of one goal's quantity along q.
struct Scalar {
    const Goal& goal;
    const PathPoint* before;    // nullptr: tangent line at `last`
    const PathPoint& last;

    [[nodiscard]] double operator()(double q) const {
        const double value = goal_value(goal, last), slope = goal_slope(goal, last);
        if (before == nullptr) return value + (q - last.q) * slope;
        return hermite(hermite_weights(before->q, last.q, q), goal_value(goal, *before), goal_slope(goal, *before),
                       value, slope);
    }
};

/// First q in (begin, end] where the curve meets the goal; sampled, then bisected: a cubic has at most three roots.
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

std::string with_unit(double value, double factor, const char* unit) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << value * factor << unit;
    return text.str();
}

Goal make_goal(const model::Case& input, const model::Until& until, std::optional<double> undeformed_volume_m3) {
    const std::string place = "path.until." + until.quantity;
    if (until.quantity == "pressure") {
        const model::LeadingLoad load = model::leading_load(input);
        if (load.quantity != "pressure" || load.value_Pa == 0.0)
            throw Error(ExitCode::bad_input, place, "no pressure loads the body", "give loads.cavity.pressure");
        return {{ConstraintKind::load_factor}, until.value / load.value_Pa,
                "pressure of " + with_unit(until.value, 1e-3, " kPa")};
    }
    if (until.quantity == "volume_ratio") {
        if (!undeformed_volume_m3)
            throw Error(ExitCode::bad_input, place, "no cavity is loaded", "remove it, or load a cavity");
        return {{ConstraintKind::volume}, until.value * *undeformed_volume_m3,
                "volume ratio of " + with_unit(until.value, 1.0, "")};
    }
    const auto output = std::ranges::find(input.outputs, until.quantity, &model::Output::name);
    if (output == input.outputs.end())
        throw Error(ExitCode::bad_input, place, "there is no such output", "name one of outputs, pressure, volume_ratio, steps");
    Constraint constraint{ConstraintKind::output};
    constraint.output = static_cast<std::size_t>(output - input.outputs.begin());
    return {constraint, until.value, until.quantity + " of " + with_unit(until.value, 1e3, " mm")};
}

}  // namespace

std::vector<Goal> make_goals(const model::Case& input, std::optional<double> undeformed_volume_m3) {
    std::vector<Goal> goals{{{ConstraintKind::load_factor}, 1.0, "full load"}};
    for (const auto& until : input.path.until)
        if (until.quantity != "steps") goals.push_back(make_goal(input, until, undeformed_volume_m3));
    return goals;
}

double goal_value(const Goal& goal, const PathPoint& point) {
    switch (goal.constraint.kind) {
        case ConstraintKind::load_factor: return point.state.load_factor;
        case ConstraintKind::volume: return point.volume_m3.value_or(0.0);
        case ConstraintKind::output: return point.outputs_m[goal.constraint.output];
        case ConstraintKind::arc: break;
    }
    throw std::logic_error("goal_value: an arc length is no goal");
}

double goal_slope(const Goal& goal, const PathPoint& point) {
    switch (goal.constraint.kind) {
        case ConstraintKind::load_factor: return point.tangent.load_factor;
        case ConstraintKind::volume: return point.volume_slope;
        case ConstraintKind::output: return point.output_slopes[goal.constraint.output];
        case ConstraintKind::arc: break;
    }
    throw std::logic_error("goal_slope: an arc length is no goal");
}

std::optional<Crossing> first_predicted(const std::vector<Goal>& goals, const PathPoint* before,
                                        const PathPoint& last, double q_end) {
    std::optional<Crossing> first;
    for (const auto& goal : goals) {
        const auto q = first_meeting({goal, before, last}, last.q, q_end);
        if (q && (!first || *q < first->q)) first = Crossing{&goal, *q};
    }
    return first;
}

std::optional<Crossing> first_between(const std::vector<Goal>& goals, const PathPoint& from, const PathPoint& to) {
    std::optional<Crossing> first;
    for (const auto& goal : goals) {
        const auto q = first_meeting({goal, &from, to}, from.q, to.q);
        if (q && (!first || *q < first->q)) first = Crossing{&goal, *q};
    }
    return first;
}

}  // namespace soft::solver
