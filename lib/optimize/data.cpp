#include "optimize/data.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/text.hpp"
#include "design/tree.hpp"
#include "geometry/build.hpp"
#include "geometry/family.hpp"
#include "post/measured.hpp"
#include "sweep/outcome.hpp"

namespace soft::optimize {
namespace {

constexpr std::size_t max_table_bytes = std::size_t{64} << 20;

/// Whether `column` has derivatives in a trial.
bool is_measurable(const post::Column& column) {
    return column.source == post::Source::load || column.source == post::Source::output;
}

/// The quantity at whose values curves are compared unless `at` names one: the time, the load, or beyond a limit point the first output
/// that always changes in one direction.
const post::Column* usual_position(const post::Measured& measured, const post::Curve& columns) {
    const auto changes_in_one_direction = [](const std::vector<double>& values) {
        return std::ranges::is_sorted(values, std::less_equal<>()) ||
               std::ranges::is_sorted(values, std::greater_equal<>());
    };
    const post::Column *load = columns.find(post::Source::load), *time = columns.find(post::Source::time);
    if (time != nullptr && measured.find(columns.index_of(*time)) != nullptr) return time;
    for (const post::Source source : {post::Source::load, post::Source::output})
        for (const post::Series& series : measured.series)
            if (const post::Column& column = columns.columns[series.column];
                column.source == source && changes_in_one_direction(series.values))
                return &column;
    return load;
}

/// Whether the leading load is a function of time that the design states; a measured load then says nothing about the design.
bool states_load_over_time(const model::Case& model) {
    return model::is_timed(model) && std::ranges::all_of(model.path.stages, [](const model::Stage& stage) {
               return stage.supplies.empty() || stage.supplies.front().what == model::Prescription::pressure;
           });
}

double bound_of(const std::string& text, const post::Column& at, double otherwise, const MeasuredCurve& curve) {
    return text.empty() ? otherwise : core::quantity_or_throw(text, at.dimension, ExitCode::bad_input, curve.location);
}

}  // namespace

void add_rows(Goal& goal, std::size_t index, const core::Table& table, const post::Curve& columns, LoadIs load) {
    MeasuredCurve& curve = goal.curves[index];
    const post::Measured measured = post::read_measured(table, columns, post::parse_column_choices(curve.columns));
    const post::Column* at = curve.at.empty() ? usual_position(measured, columns) : columns.find(curve.at);
    if (at == nullptr || !(is_measurable(*at) || at->source == post::Source::time))
        design::refuse(curve.location, "at", core::quoted(curve.at) + " is neither the load nor an output");
    const post::Series* positions = measured.find(columns.index_of(*at));
    if (positions == nullptr)
        design::refuse(curve.location, "at", "the file has no column of " + at->quantity, "name it under `columns`");
    curve.at = at->quantity;
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const double from = bound_of(curve.from, *at, -infinite, curve), to = bound_of(curve.to, *at, infinite, curve);
    std::size_t used = 0;
    for (const post::Series& series : measured.series) {
        const post::Column& column = columns.columns[series.column];
        if (&column == at || !is_measurable(column)) continue;
        if (column.source == post::Source::load && load == LoadIs::stated) continue;
        Condition row{.measure = {.run = curve.run, .quantity = column.quantity, .at = curve.at},
                      .unit = column.unit,
                      .SI_per_unit = column.SI_per_unit,
                      .within = curve.within,
                      .is_data = true,
                      .curve = index};
        std::vector<std::size_t> rows;
        double largest = 0;
        for (std::size_t k = 0; k < series.values.size(); ++k) {
            const double position = positions->values[k] * at->SI_per_unit, value = series.values[k];
            if (position < from || position > to || (position == 0 && value == 0)) continue;
            rows.push_back(k);
            largest = std::max(largest, std::abs(value * column.SI_per_unit));
        }
        if (largest == 0) continue;
        row.scale_SI = largest;
        for (const std::size_t k : rows) {
            row.measure.at_SI = positions->values[k] * at->SI_per_unit;
            row.measure.at_text = core::number_text(positions->values[k]) + " " + at->unit;
            row.measure.text = column.quantity + " at " + curve.at + " " + row.measure.at_text;
            row.value_SI = series.values[k] * column.SI_per_unit;
            row.value_text = core::number_text(series.values[k]) + " " + column.unit;
            row.line = measured.lines[k];
            goal.conditions.push_back(row);
        }
        used = std::max(used, rows.size());
    }
    if (used == 0)
        design::refuse(curve.location, "curve",
                       curve.file + " has no row in the range, or no load or output to compare");
    curve.left_out = table.rows.size() - used;
}

void add_data(Goal& goal, std::span<const Base> bases) {
    for (std::size_t k = 0; k < goal.curves.size(); ++k) {
        const MeasuredCurve& curve = goal.curves[k];
        const Base& base = bases[curve.run];
        const design::Design design =
            design::read_design(base.text, base.source, geometry::catalogue_keys(), goal.runs[curve.run].set);
        const std::string file = design::file_from(curve.location, curve.file);
        const core::Bytes bytes = core::read_regular_file(file, max_table_bytes);
        const core::Table table = core::read_table({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, file);
        const model::Case model = geometry::build_with_figures(design).model;
        add_rows(goal, k, table, sweep::unsolved_curve(model),
                 states_load_over_time(model) ? LoadIs::stated : LoadIs::found);
    }
}

}  // namespace soft::optimize
