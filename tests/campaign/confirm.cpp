#include "confirm.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "shape_checks.hpp"

namespace soft::campaign {
namespace {

using solution::Step;
using solution::StopReason;

/// Loads and goals are met to this part.
constexpr double met = 1e-6;
/// Differences of the load below this part of it are none.
constexpr double rounding = 1e-7;
/// At a limit point the slope of the parabola is at most this part of the secant's before; of a path that goes on it is about 1.
constexpr double flat = 0.35;
/// Growth of the load for a growth of the displacements by themselves, of what is left of it: less never gets there.
constexpr double asymptotic = 1e-3;
/// Far beyond the stretch limit: of what is left, what a load may still rise by whose rise falls with this power or a higher one.
constexpr double far_beyond = 10, least_power = 0.4, reachable = 0.6;
/// det F of a cell that is about to turn inside out.
constexpr double flattened = 0.2;
/// How far, in parts of the body, the last step may be drawn out until walls touch.
constexpr double soon = 0.03;

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

/// Of the last row; nullopt for what no row has.
std::optional<double> value_of(const io::Result& result, const std::string& quantity) {
    const Step &first = result.steps.front(), &last = result.steps.back();
    if (quantity == "pressure") return last.pressure_Pa;
    if (quantity == "steps") return static_cast<double>(result.steps.size() - 1);
    if (quantity == "volume_ratio" && last.volume_m3) return *last.volume_m3 / *first.volume_m3;
    for (std::size_t i = 0; i < result.model.outputs.size(); ++i)
        if (result.model.outputs[i].name == quantity) return last.outputs[i];
    return std::nullopt;
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

/// By the rows of the last stage: the load has an extremum before the last row, or at it.
Verdict confirm_limit_point(const io::Result& result) {
    std::vector<const Step*> rows;
    for (const Step& step : result.steps)
        if (step.stage == result.steps.back().stage) rows.push_back(&step);
    // What the user's own control lets grow; the load where the control is automatic.
    const model::Control control = result.model.path.stages[static_cast<std::size_t>(rows.back()->stage)].control;
    const bool by_volume = control == model::Control::volume && rows.back()->volume_m3;
    const bool by_output = control == model::Control::displacement && !rows.back()->outputs.empty();
    const auto controlled = [&](std::size_t i) {
        return by_volume ? *rows[i]->volume_m3 : by_output ? rows[i]->outputs[0] : rows[i]->load_factor;
    };
    const double sense = controlled(rows.size() - 1) < controlled(0) ? -1 : 1;
    const auto load = [&](std::size_t i) { return sense * controlled(i); };
    const std::size_t n = rows.size();
    if (n < 3) return {false, "too few rows"};
    std::size_t top = 0;
    for (std::size_t i = 1; i < n; ++i)
        if (load(i) > load(top)) top = i;
    if (top + 1 < n && load(top) - load(n - 1) > rounding * std::abs(load(top))) {
        const bool given_up = rows.back()->stretch_p99 > result.model.path.stretch_limit;
        return {given_up && top > 0 && load(top) < 1, "the load has its maximum, " + text(load(top)) +
                                                          " of the full one, in row " + std::to_string(top) + " of " +
                                                          std::to_string(n - 1)};
    }
    const auto row = static_cast<std::int64_t>(result.steps.size()) - 1;
    const auto from = way(result, row - 2, row - 1), to = way(result, row - 1, row), all = way(result, 0, row);
    if (!from || !to || !all) return {false, "no fields are stored"};
    const double gain = load(n - 1) - load(n - 2), left = 1 - load(n - 1);
    if (!by_volume && !by_output && left > 0 && std::abs(gain) < asymptotic * *to / *all * left)
        return {true, "the load has an asymptote: " + text(load(n - 1)) + " of the full one at the end"};
    const double before = (load(n - 2) - load(n - 3)) / *from, last = gain / *to;
    // Or its rise falls with a power of the displacements: what is still to come is the integral of that.
    const double power = std::log(before / last) / std::log((*all - *to / 2) / (*all - *to - *from / 2)) - 1,
                 to_come = last * *all / power;
    const bool far = rows.back()->stretch_p99 > far_beyond * result.model.path.stretch_limit;
    if (!by_volume && !by_output && far && left > 0 && last > 0 && power > least_power && to_come < reachable * left)
        return {true, "the load tends to " + text(load(n - 1) + to_come) + " of the full one"};
    const double slope = last + (last - before) / (*from + *to) * *to;  // of the parabola, at the last row
    return {std::abs(slope) <= flat * std::abs(before),
            "slope at the last row " + text(slope / before) + " of that two rows before"};
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
    for (double t = 0; t == 0 || t * largest <= farthest; t = t == 0 ? 0.125 : 1.5 * t) {
        std::vector<double> u = last->displacement_m;
        for (std::size_t i = 0; i < u.size(); ++i) u[i] += t * step[i];
        if (const std::string what = checks.contact(u); !what.empty())
            return {true, what + ", " + text(t * largest * 1e3) + " mm beyond the last row"};
        if (largest == 0) break;
    }
    return {false, "no walls meet within " + text(farthest * 1e3) + " mm of the last row"};
}

Verdict confirm_inversion(const io::Result& result) {
    const auto last = result.fields.read(static_cast<std::int64_t>(result.steps.size()) - 1);
    if (!last) return {false, "no fields are stored"};
    const double least = ShapeChecks{result.model}.least_det_F(last->displacement_m);
    return {least <= flattened, "least det F " + text(least)};
}

}  // namespace

Verdict confirm(const io::Result& result) {
    if (!result.end || result.steps.size() < 2) return {false, "no path"};
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
