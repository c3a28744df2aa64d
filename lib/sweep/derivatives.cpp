#include "sweep/derivatives.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "post/point_sensitivity.hpp"
#include "sweep/point.hpp"
#include "sweep/table.hpp"

namespace soft::sweep {
namespace {

/// Index of the quantity in post/point_sensitivity.hpp; nullopt for a column without derivatives.
std::optional<std::size_t> quantity_of(const post::Column& column) {
    if (column.source == post::Source::load) return 0;
    if (column.source == post::Source::output) return 1 + column.index;
    return std::nullopt;
}

std::string quantity_named_by(const SourceText& point) {
    return std::string{core::trimmed(std::string_view{point.text}.substr(0, point.text.find('=')))};
}

/// The quantity whose goal ended the path: a condition of `until`, or the full load.
std::optional<std::size_t> held_at_end(const SolvedPath& path) {
    constexpr double tolerance = 1e-6;  // relative; the solver locates goals more accurately
    const auto is_near = [](double a, double b) { return std::abs(a - b) <= tolerance * std::abs(b); };
    if (path.end.reason != model::StopReason::done || path.steps.empty()) return std::nullopt;
    const model::Step& last = path.steps.back();
    const model::Stage& stage = path.model.path.stages[static_cast<std::size_t>(last.stage)];
    for (const model::Until& until : stage.until) {
        if (until.quantity == "pressure" && is_near(last.pressure_Pa, until.value)) return 0;
        for (std::size_t i = 0; i < path.model.outputs.size(); ++i)
            if (path.model.outputs[i].name == until.quantity && is_near(last.outputs[i], until.value)) return 1 + i;
    }
    const bool is_full = is_near(last.load_factor, 1);
    const bool has_pressures = std::ranges::all_of(
        stage.supplies, [](const model::SupplyTarget& supply) { return supply.what == model::Prescription::pressure; });
    return is_full && has_pressures ? std::optional<std::size_t>{0} : std::nullopt;
}

std::optional<std::size_t> held_at(const SourceText& point, const post::Curve& curve, const SolvedPath& path) {
    const post::Column* at = curve.find(quantity_named_by(point));
    if (model::is_timed(path.model)) {  // the time is held, and nothing else
        const bool is_time = point.text == "end" || (at != nullptr && at->source == post::Source::time);
        return is_time ? std::optional<std::size_t>{0} : std::nullopt;
    }
    if (point.text == "limit") return 1;  // the derivative of the load is the same at any fixed output
    if (point.text == "end") return held_at_end(path);
    return at == nullptr ? std::nullopt : quantity_of(*at);
}

std::string derivative_unit(const std::string& unit, const std::string& by) {
    if (by.empty()) return unit;
    return (unit.empty() ? "1" : unit) + "/" + (by.find('/') == std::string::npos ? by : "(" + by + ")");
}

Cell empty_cell(const post::Column& column, const model::DesignParameter& parameter, const SourceText& point,
                const post::Curve& curve) {
    const std::string unit = derivative_unit(column.unit, parameter.unit);
    std::string name = column.quantity + "_by_" + parameter.key;
    std::ranges::replace(name, '.', '_');
    if (!unit.empty()) name += "_" + unit_name(unit);
    return {column_at(name, point.text, curve), std::nullopt, label_at(column.quantity, point.text, parameter.key),
            unit};
}

}  // namespace

Outputs derivatives_of(const Sweep& sweep, const post::Curve& curve, const SolvedPath& path) {
    Outputs outputs;
    post::Curve extended = curve;
    const post::SensitivityColumns columns = post::add_sensitivity_columns(extended, path.model, path.steps);
    if (columns.quantities == 0) return outputs;
    for (const SourceText& point : sweep.at) {
        const std::optional<std::vector<double>> row = row_at(point, extended, path.end.limit_points).values;
        const std::optional<std::size_t> held = held_at(point, curve, path);
        if (row && !held)
            outputs.missing.push_back("sensitivity at " + point.text +
                                      (model::is_timed(path.model)
                                           ? ": derivatives of a path in time are at fixed times, time=..."
                                           : ": the path did not end at a load or an output"));
        for (const post::Column& column : curve.columns) {
            const std::optional<std::size_t> quantity = quantity_of(column);
            if (!quantity || !is_requested(sweep, column) || (point.text == "limit" && *quantity != 0)) continue;
            if (column.quantity == quantity_named_by(point)) continue;  // held, so its derivative is 0
            for (std::size_t p = 0; p < path.model.parameters.size(); ++p) {
                const model::DesignParameter& parameter = path.model.parameters[p];
                Cell& cell = outputs.cells.emplace_back(empty_cell(column, parameter, point, curve));
                if (!row || !held) continue;
                const double value =
                    post::sensitivity_at(*row, columns, {.quantity = *quantity, .held = *held, .parameter = p}) *
                    parameter.SI_per_unit / column.SI_per_unit;
                if (std::isfinite(value)) cell.value = value;
            }
        }
    }
    return outputs;
}

void check_derivatives(const Sweep& sweep, const post::Curve& curve) {
    if (sweep.sensitivity.empty()) return;
    const std::string location = sweep.sensitivity.front().location + ": sensitivity";
    const auto has_derivatives = [&](const post::Column& column) {
        return quantity_of(column) && is_requested(sweep, column);
    };
    if (std::ranges::none_of(curve.columns, has_derivatives))
        throw Error(ExitCode::bad_input, location, "none of the outputs has derivatives",
                    "add the load or an output of the design to outputs");
    for (const SourceText& point : sweep.at) {
        const post::Column* column = is_named_point(point) ? nullptr : curve.find(quantity_named_by(point));
        if (column != nullptr && !quantity_of(*column) && column->source != post::Source::time)
            throw Error(ExitCode::bad_input, point.location + ": at",
                        "there are no sensitivities at a fixed " + column->quantity,
                        "use points of the load or of an output of the design, or leave out sensitivity");
    }
}

std::string sensitivity_keys(const Sweep& sweep, std::span<const model::DesignParameter> parameters) {
    std::vector<std::string> keys;
    for (const SourceText& requested : sweep.sensitivity)
        if (requested.text == "all" ||
            std::ranges::find(parameters, requested.text, &model::DesignParameter::key) != parameters.end())
            keys.push_back(requested.text);
    return core::join(keys, ",");
}

}  // namespace soft::sweep
