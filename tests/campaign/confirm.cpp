#include "confirm.hpp"

#include <algorithm>
#include <cmath>

#include "consistency.hpp"
#include "core/text.hpp"
#include "post/curve.hpp"
#include "shape_checks.hpp"

namespace soft::campaign {
namespace {

using model::Step;
using model::StopReason;

/// Relative tolerance within which loads and goals are reached.
constexpr double goal_tolerance = 1e-6;
/// Largest ratio of successive slopes at a limit point; it is about 1 on a path that continues.
constexpr double max_slope_ratio = 0.35;
/// Relative growth of the load, over the remaining load, for a doubling of the displacements: with less growth the load is never reached.
constexpr double max_asymptotic_growth = 1e-3;
/// Times the stretch limit: a stretch that no rubber reaches at any point. If the growth of the load decays with at least this power there, the
/// extrapolated growth must stay below this fraction of the remaining load.
constexpr double far_beyond = 10, min_power = 0.4, reachable = 0.6;
/// Largest det F of a cell that is about to invert.
constexpr double max_inverted_det_F = 0.2;
/// Largest extrapolation of the last step until self-contact, relative to the extent of the model.
constexpr double max_extrapolation = 0.03;
/// Extrapolation in fractions of the last step: the first equals the accuracy of the contact location, each further one is larger by the
/// given factor.
constexpr double first_extrapolation = 1.0 / 256, extrapolation_growth = 1.5;

/// A state lies between two rows if the sum of its distances to both exceeds their distance by less than this fraction.
constexpr double max_detour = 0.05;
/// The path stalls if this many steps cover less than this fraction of its length.
constexpr std::size_t stall_steps = 150;
constexpr double max_stall_length = 0.011;

std::string text(double value) { return core::rounded_text(value, 4); }

/// Norm of the change of the nodal displacements between two rows [m], the abscissa of all slopes.
std::optional<double> distance(const io::Result& result, std::int64_t from, std::int64_t to) {
    const auto a = result.fields.read(from), b = result.fields.read(to);
    if (!a || !b) return std::nullopt;
    double sum = 0;
    for (std::size_t i = 0; i < a->displacement_m.size(); ++i)
        sum += std::pow(b->displacement_m[i] - a->displacement_m[i], 2);
    return std::sqrt(sum);
}

/// Value of a quantity in the last row, SI: the number of steps, a volume ratio or a column of the curve; nullopt if it is not recorded.
std::optional<double> value_of(const io::Result& result, const std::string& quantity) {
    const Step &first = result.steps.front(), &last = result.steps.back();
    if (quantity == "steps") return static_cast<double>(result.steps.size() - 1);
    if (quantity == "volume_ratio" && last.volume_m3) return *last.volume_m3 / *first.volume_m3;
    const post::Curve curve = post::make_curve(result.model, result.steps);
    const post::Column* column = curve.find(quantity);
    if (column == nullptr || column->role != post::Role::coordinate) return std::nullopt;
    return column->values.back() * column->SI_per_unit;
}

Verdict confirm_done(const io::Result& result) {
    const Step& last = result.steps.back();
    if (last.stage + 1 != static_cast<int>(result.model.path.stages.size()))
        return {false, "not all stages are complete"};
    for (const model::Until& until : result.model.path.stages.back().until)
        if (const auto value = value_of(result, until.quantity);
            value && std::abs(*value - until.value) <= goal_tolerance * std::abs(until.value))
            return {true, until.quantity + " has reached its goal"};
    return {std::abs(last.load_factor - 1) <= goal_tolerance, "load factor " + text(last.load_factor)};
}

/// Row of the maximum if the values decrease after it by more than the equilibrium tolerance; else the last row.
std::size_t maximum(const std::vector<double>& values, double tolerance) {
    const auto top = std::ranges::max_element(values);
    const bool falls = *top - values.back() > tolerance * std::abs(*top);
    return falls ? static_cast<std::size_t>(top - values.begin()) : values.size() - 1;
}

/// Slope of a value at the last row, relative to the secant before the last step. The slope at the start of the last step is extrapolated
/// from the previous steps, because just before a maximum the last step is much shorter than they are. `values`, `distances`: last first.
double slope_at_the_end(std::span<const double> values, std::span<const double> distances) {
    const auto secant = [&](std::size_t i) { return (values[i] - values[i + 1]) / distances[i]; };
    double start = secant(1);  // at the start of the last step
    if (distances.size() > 2) start += (secant(1) - secant(2)) / (distances[1] + distances[2]) * distances[1];
    return (2 * secant(0) - start) / secant(1);
}

/// Checks for a path that returns to a state between two earlier rows of its last stage, or whose last steps stall.
std::optional<Verdict> confirm_return_or_stall(const io::Result& result) {
    const auto last = static_cast<std::int64_t>(result.steps.size()) - 1;
    std::vector<double> distances;
    double all = 0;
    for (std::int64_t row = 0; row < last; ++row) {
        if (result.steps[static_cast<std::size_t>(row)].stage != result.steps.back().stage) continue;
        const auto length = distance(result, row, row + 1), before = distance(result, row, last),
                   behind = distance(result, row + 1, last);
        if (!length || !before || !behind) return std::nullopt;
        if (row + 2 < last && *before + *behind < (1 + max_detour) * *length)
            return Verdict{
                true, "the last state lies between rows " + std::to_string(row) + " and " + std::to_string(row + 1)};
        distances.push_back(*length);
        all += *length;
    }
    if (distances.size() < stall_steps) return std::nullopt;
    double end = 0;
    for (std::size_t i = distances.size() - stall_steps; i < distances.size(); ++i) end += distances[i];
    if (end > max_stall_length * all) return std::nullopt;
    return Verdict{true, "the last " + std::to_string(stall_steps) + " steps are " + text(end / all) + " of the path"};
}

/// From the rows of the last stage: the load has a maximum before the last row, or the controlled quantity has one at the last row.
Verdict confirm_limit_point(const io::Result& result) {
    std::vector<double> factors, controlled;
    const model::Control control =
        result.model.path.stages[static_cast<std::size_t>(result.steps.back().stage)].control;
    for (const Step& step : result.steps) {
        if (step.stage != result.steps.back().stage) continue;
        factors.push_back(step.load_factor);
        controlled.push_back(control == model::Control::volume && step.volume_m3                ? *step.volume_m3
                             : control == model::Control::displacement && !step.outputs.empty() ? step.outputs[0]
                                                                                                : step.load_factor);
    }
    const std::size_t n = factors.size();
    if (n < 3) return {false, "too few rows"};
    if (controlled.back() < controlled.front() && controlled != factors)
        for (double& value : controlled) value = -value;
    const double tolerance = result.model.solver.residual_tolerance;
    const std::size_t top = maximum(factors, tolerance);
    const Step& end = result.steps.back();
    if (top + 1 < n && (end.stretch_p99 > result.model.path.stretch_limit ||
                        end.max_stretch > far_beyond * result.model.path.stretch_limit))
        return {top > 0 && factors[top] < 1, "the load has its maximum, " + text(factors[top]) +
                                                 " of the full load, in row " + std::to_string(top) + " of " +
                                                 std::to_string(n - 1)};
    if (factors.back() >= 1 - goal_tolerance) return {false, "the requested load is reached"};
    if (auto verdict = confirm_return_or_stall(result)) return *verdict;
    if (maximum(controlled, tolerance) + 1 < n) return {false, "the path continues after a maximum"};
    const auto rows = static_cast<std::int64_t>(result.steps.size());
    const auto all = distance(result, 0, rows - 1);
    std::vector<double> values{controlled.back()}, loads{factors.back()}, distances;  // backwards
    for (std::size_t i = n - 1; i > 0 && distances.size() < 3; --i) {
        const std::int64_t row = rows - static_cast<std::int64_t>(n - i);
        const auto length = distance(result, row - 1, row);
        if (!length || !all) return {false, "no fields are stored"};
        if (*length <= tolerance * *all) continue;  // the same state twice
        values.push_back(controlled[i - 1]);
        loads.push_back(factors[i - 1]);
        distances.push_back(*length);
    }
    if (distances.size() < 2) return {false, "too few rows"};
    const double gain = loads[0] - loads[1], left = 1 - factors.back();
    // Under other controls the load is flat at its maximum too, where the path goes on.
    const bool may_end = controlled == factors || result.steps.back().stretch_p99 > result.model.path.stretch_limit;
    if (may_end && left > 0 && std::abs(gain) < max_asymptotic_growth * distances[0] / *all * left)
        return {true, "the load has an asymptote: " + text(factors[n - 1]) + " of the full load at the end"};
    // Or its growth decays with a power of the displacements: the integral of this power law is the remaining growth.
    const double before = (loads[1] - loads[2]) / distances[1], last = gain / distances[0];
    const double power = std::log(before / last) /
                             std::log((*all - distances[0] / 2) / (*all - distances[0] - distances[1] / 2)) -
                         1,
                 to_come = last * *all / power;
    const bool far = result.steps.back().stretch_p99 > far_beyond * result.model.path.stretch_limit;
    if (may_end && far && left > 0 && last > 0 && power > min_power && to_come < reachable * left)
        return {true, "the load tends to " + text(factors[n - 1] + to_come) + " of the full load"};
    const double slope = slope_at_the_end(values, distances);
    return {slope <= max_slope_ratio, "slope at the last row " + text(slope) + " of that two rows before"};
}

Verdict confirm_self_contact(const io::Result& result) {
    const auto rows = static_cast<std::int64_t>(result.steps.size());
    const auto last = result.fields.read(rows - 1), before = result.fields.read(rows - 2);
    if (!last || !before) return {false, "no fields are stored"};
    const ShapeChecks checks{result.model};
    const auto [depth_m, obstacle] = checks.deepest_in_obstacle(last->displacement_m);
    if (depth_m > 0.5 * checks.contact_distance_m())
        return {true, "a wall is " + text(1e3 * depth_m) + " mm inside the obstacle " + obstacle};
    std::vector<double> step = last->displacement_m;
    double largest = 0;
    for (std::size_t i = 0; i < step.size(); ++i) {
        step[i] -= before->displacement_m[i];
        largest = std::max(largest, std::abs(step[i]));
    }
    const double farthest = max_extrapolation * checks.extent_m();
    for (double t = 0; t == 0 || t * largest <= farthest; t = t == 0 ? first_extrapolation : extrapolation_growth * t) {
        std::vector<double> u = last->displacement_m;
        for (std::size_t i = 0; i < u.size(); ++i) u[i] += t * step[i];
        if (const std::string what = checks.contact(u, before->displacement_m); !what.empty())
            return {true, what + ", " + text(t * largest * 1e3) + " mm beyond the last row"};
        if (largest == 0) break;
    }
    return {false, "no contact within " + text(farthest * 1e3) + " mm of the last row"};
}

Verdict confirm_inversion(const io::Result& result) {
    const auto last = result.fields.read(static_cast<std::int64_t>(result.steps.size()) - 1);
    if (!last) return {false, "no fields are stored"};
    const double minimum = ShapeChecks{result.model}.min_det_F(last->displacement_m);
    return {minimum <= max_inverted_det_F, "smallest det F " + text(minimum)};
}

}  // namespace

Verdict confirm(const io::Result& result) {
    if (!result.end || result.steps.size() < 2) return {false, "no path"};
    if (std::string wrong = inconsistency(result); !wrong.empty()) return {false, std::move(wrong)};
    switch (result.end->reason) {
        case StopReason::done: return confirm_done(result);
        case StopReason::limit_point: return confirm_limit_point(result);
        case StopReason::self_contact: return confirm_self_contact(result);
        case StopReason::inverted_element: return confirm_inversion(result);
        case StopReason::step_limit:
            return {static_cast<int>(result.steps.size()) > result.model.solver.step_limit,
                    std::to_string(result.steps.size()) + " rows"};
        case StopReason::diverged: break;
    }
    return {false, result.end->detail};
}

}  // namespace soft::campaign
