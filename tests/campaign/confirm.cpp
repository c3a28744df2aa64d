#include "confirm.hpp"

#include <algorithm>
#include <cmath>

#include "consistency.hpp"
#include "core/text.hpp"
#include "post/curve.hpp"
#include "shape_checks.hpp"

namespace soft::campaign {
namespace {

using solution::Step;
using solution::StopReason;

/// Loads and goals are met to this part.
constexpr double met = 1e-6;
/// At a limit point the slope is at most this part of that before; of a path that goes on it is about 1.
constexpr double flat = 0.35;
/// Growth of the load for a growth of the displacements by themselves, of what is left of it: less never gets there.
constexpr double asymptotic = 1e-3;
/// Far beyond the stretch limit: of what is left, what a load may still rise by whose rise falls with this power or a higher one.
constexpr double far_beyond = 10, min_power = 0.4, reachable = 0.6;
/// det F of a cell that is about to turn inside out.
constexpr double flattened = 0.2;
/// How far, in parts of the body, the last step may be drawn out until walls touch.
constexpr double soon = 0.03;
/// Parts of the last step: the first is that to which contact is located, each further one so many times longer.
constexpr double first_part = 1.0 / 256, longer = 1.5;

/// A state lies between two rows where the way to both together is longer than that between them by less than this part.
constexpr double detour = 0.05;
/// So many steps that are together less than this part of the path's length lead nowhere.
constexpr std::size_t many_steps = 150;
constexpr double short_way = 0.011;

std::string text(double value) { return core::rounded_text(value, 4); }

/// How far the nodes move from one row to the next [m]: what the load is seen against.
std::optional<double> way(const io::Result& result, std::int64_t from, std::int64_t to) {
    const auto a = result.fields.read(from), b = result.fields.read(to);
    if (!a || !b) return std::nullopt;
    double sum = 0;
    for (std::size_t i = 0; i < a->displacement_m.size(); ++i)
        sum += std::pow(b->displacement_m[i] - a->displacement_m[i], 2);
    return std::sqrt(sum);
}

/// Of the last row, SI; but for numbers of rows and ratios the column of the curve. nullopt for what no row has.
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
    if (last.stage + 1 != static_cast<int>(result.model.path.stages.size())) return {false, "stages are left"};
    for (const model::Until& until : result.model.path.stages.back().until)
        if (const auto value = value_of(result, until.quantity);
            value && std::abs(*value - until.value) <= met * std::abs(until.value))
            return {true, until.quantity + " is what it was to be"};
    return {std::abs(last.load_factor - 1) <= met, "load factor " + text(last.load_factor)};
}

/// The maximum of a value by rows: in one that has a fall behind it which is more than equilibrium leaves open; else the last.
std::size_t maximum(const std::vector<double>& values, double tolerance) {
    const auto top = std::ranges::max_element(values);
    const bool falls = *top - values.back() > tolerance * std::abs(*top);
    return falls ? static_cast<std::size_t>(top - values.begin()) : values.size() - 1;
}

/// Slope of a value over the way at the last row, as part of the secant's before the last step. The slope where the last step
/// begins is drawn out from the steps before it: just before a maximum the last step is much shorter than they are. Last first.
double slope_at_the_end(std::span<const double> values, std::span<const double> ways) {
    const auto secant = [&](std::size_t i) { return (values[i] - values[i + 1]) / ways[i]; };
    double start = secant(1);  // of the last step
    if (ways.size() > 2) start += (secant(1) - secant(2)) / (ways[1] + ways[2]) * ways[1];
    return (2 * secant(0) - start) / secant(1);
}

/// A path that has come back to a state between two earlier rows of its last stage, or whose last steps lead nowhere.
std::optional<Verdict> confirm_return_or_stall(const io::Result& result) {
    const auto last = static_cast<std::int64_t>(result.steps.size()) - 1;
    std::vector<double> ways;
    double all = 0;
    for (std::int64_t row = 0; row < last; ++row) {
        if (result.steps[static_cast<std::size_t>(row)].stage != result.steps.back().stage) continue;
        const auto length = way(result, row, row + 1), before = way(result, row, last),
                   behind = way(result, row + 1, last);
        if (!length || !before || !behind) return std::nullopt;
        if (row + 2 < last && *before + *behind < (1 + detour) * *length)
            return Verdict{
                true, "the last state lies between rows " + std::to_string(row) + " and " + std::to_string(row + 1)};
        ways.push_back(*length);
        all += *length;
    }
    if (ways.size() < many_steps) return std::nullopt;
    double end = 0;
    for (std::size_t i = ways.size() - many_steps; i < ways.size(); ++i) end += ways[i];
    if (end > short_way * all) return std::nullopt;
    return Verdict{true, "the last " + std::to_string(many_steps) + " steps are " + text(end / all) + " of the path"};
}

/// By the rows of the last stage: the load has an extremum before the last row, or what the control lets grow has one at it.
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
    if (top + 1 < n && result.steps.back().stretch_p99 > result.model.path.stretch_limit)
        return {top > 0 && factors[top] < 1, "the load has its maximum, " + text(factors[top]) +
                                                 " of the full one, in row " + std::to_string(top) + " of " +
                                                 std::to_string(n - 1)};
    if (factors.back() >= 1 - met) return {false, "the load asked for is reached"};
    if (auto verdict = confirm_return_or_stall(result)) return *verdict;
    if (maximum(controlled, tolerance) + 1 < n) return {false, "the path has gone on behind a maximum"};
    const auto rows = static_cast<std::int64_t>(result.steps.size());
    const auto all = way(result, 0, rows - 1);
    std::vector<double> values{controlled.back()}, ways;  // backwards
    for (std::size_t i = n - 1; i > 0 && ways.size() < 3; --i) {
        const std::int64_t row = rows - static_cast<std::int64_t>(n - i);
        const auto length = way(result, row - 1, row);
        if (!length || !all) return {false, "no fields are stored"};
        if (*length <= tolerance * *all) continue;  // the same state twice
        values.push_back(controlled[i - 1]);
        ways.push_back(*length);
    }
    if (ways.size() < 2) return {false, "too few rows"};
    const double gain = values[0] - values[1], left = 1 - factors.back();
    if (controlled == factors && left > 0 && std::abs(gain) < asymptotic * ways[0] / *all * left)
        return {true, "the load has an asymptote: " + text(factors[n - 1]) + " of the full one at the end"};
    // Or its rise falls with a power of the displacements: what is still to come is the integral of that.
    const double before = (values[1] - values[2]) / ways[1], last = gain / ways[0];
    const double power = std::log(before / last) / std::log((*all - ways[0] / 2) / (*all - ways[0] - ways[1] / 2)) - 1,
                 to_come = last * *all / power;
    const bool far = result.steps.back().stretch_p99 > far_beyond * result.model.path.stretch_limit;
    if (controlled == factors && far && left > 0 && last > 0 && power > min_power && to_come < reachable * left)
        return {true, "the load tends to " + text(factors[n - 1] + to_come) + " of the full one"};
    const double slope = slope_at_the_end(values, ways);
    return {slope <= flat, "slope at the last row " + text(slope) + " of that two rows before"};
}

Verdict confirm_self_contact(const io::Result& result) {
    const auto rows = static_cast<std::int64_t>(result.steps.size());
    const auto last = result.fields.read(rows - 1), before = result.fields.read(rows - 2);
    if (!last || !before) return {false, "no fields are stored"};
    const ShapeChecks checks{result.model};
    std::vector<double> step = last->displacement_m;
    double largest = 0;
    for (std::size_t i = 0; i < step.size(); ++i) {
        step[i] -= before->displacement_m[i];
        largest = std::max(largest, std::abs(step[i]));
    }
    const double farthest = soon * checks.extent_m();
    for (double t = 0; t == 0 || t * largest <= farthest; t = t == 0 ? first_part : longer * t) {
        std::vector<double> u = last->displacement_m;
        for (std::size_t i = 0; i < u.size(); ++i) u[i] += t * step[i];
        if (const std::string what = checks.contact(u, before->displacement_m); !what.empty())
            return {true, what + ", " + text(t * largest * 1e3) + " mm beyond the last row"};
        if (largest == 0) break;
    }
    return {false, "no walls meet within " + text(farthest * 1e3) + " mm of the last row"};
}

Verdict confirm_inversion(const io::Result& result) {
    const auto last = result.fields.read(static_cast<std::int64_t>(result.steps.size()) - 1);
    if (!last) return {false, "no fields are stored"};
    const double least = ShapeChecks{result.model}.min_det_F(last->displacement_m);
    return {least <= flattened, "least det F " + text(least)};
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
