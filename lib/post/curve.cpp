#include "post/curve.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "model/time_function.hpp"
#include "post/curve_entries.hpp"

namespace soft::post {
namespace {

void check(const model::Case& model, std::span<const model::Step> steps) {
    const std::size_t loads = model.loads.size() > 1 ? model.loads.size() : 0,
                      cavities = model::measured_cavities(model).size();
    for (std::size_t row = 0; row < steps.size(); ++row) {
        const model::Step &step = steps[row], &first = steps.front();
        const std::string location = "path, step " + std::to_string(row);
        const auto check_count = [&](const std::vector<double>& list, std::size_t count, const char* what) {
            if (list.size() != count)
                throw Error(
                    ExitCode::bad_input, location,
                    std::to_string(list.size()) + " " + what + " are recorded, the case has " + std::to_string(count));
        };
        check_count(step.outputs, model.outputs.size(), "outputs");
        check_count(step.pressures_Pa, loads, "pressures");
        check_count(step.volumes_m3, cavities > 1 ? cavities : 0, "volumes");
        const auto check_same = [&](bool same, const char* what) {
            if (!same)
                throw Error(ExitCode::bad_input, location, std::string{what} + " recorded at some of the steps only");
        };
        check_same(step.volume_m3.has_value() == first.volume_m3.has_value(), "the cavity volume is");
        check_same(
            step.motion.has_value() == first.motion.has_value() && step.time_s.has_value() == first.time_s.has_value(),
            "the time is");
        check_same(step.frequencies_Hz.size() == first.frequencies_Hz.size(), "the natural frequencies are");
        const bool has_errors = first.pressure_error_Pa.has_value();
        check_same(step.pressure_error_Pa.has_value() == has_errors &&
                       step.output_errors.size() == (has_errors ? model.outputs.size() : 0),
                   "the errors are");
    }
}

/// Rows at which the direction of the path changes: first contacts, in a motion kinks of the loads. Ascending.
std::vector<std::size_t> kinks_of(const model::Case& model, std::span<const model::Step> steps,
                                  const model::PathEnd& end) {
    std::vector<std::size_t> kinks;
    if (!model.dynamics) {
        for (const model::FirstContact& contact : end.first_contacts)
            kinks.push_back(static_cast<std::size_t>(contact.at.step));
        std::ranges::sort(kinks);
        return kinks;
    }
    std::vector<double> times = model::kink_times(model);
    times.push_back(model.dynamics->duration_s);  // the rates there are those after the motion
    for (std::size_t row = 0; row < steps.size(); ++row)
        if (std::ranges::binary_search(times, steps[row].motion->time_s)) kinks.push_back(row);
    return kinks;
}

}  // namespace

double in_column_unit(const Column& column, double value_SI) noexcept {
    // 1000 is an exact double, 1e-3 is not: multiply by the inverse if that is a whole number
    const double inverse = 1 / column.SI_per_unit, whole = std::round(inverse);
    if (std::abs(inverse - whole) <= 1e-12 * inverse) return value_SI * whole;
    return value_SI / column.SI_per_unit;
}

Curve make_curve(const model::Case& model, std::span<const model::Step> steps, const model::PathEnd& end) {
    check(model, steps);
    Curve curve;
    curve.kinks = kinks_of(model, steps, end);
    for (Entry& entry : entries_of(model, steps)) {
        const auto has_value = [&](const model::Step& step) { return entry.value_SI(step).has_value(); };
        if (entry.is_optional && (steps.empty() || !std::ranges::all_of(steps, has_value))) continue;
        Column& column = curve.columns.emplace_back(std::move(entry.column));
        for (const model::Step& step : steps) {
            column.values.push_back(in_column_unit(column, *entry.value_SI(step)));
            if (const Value slope = entry.slope_SI(step)) column.slopes.push_back(in_column_unit(column, *slope));
        }
        if (column.slopes.size() != steps.size()) column.slopes.clear();
    }
    return curve;
}

}  // namespace soft::post
