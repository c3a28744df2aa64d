#include "post/point_sensitivity.hpp"

#include <algorithm>
#include <utility>

#include "post/row_derivatives.hpp"

namespace soft::post {
SensitivityColumns add_sensitivity_columns(Curve& curve, const model::Case& model, std::span<const model::Step> steps) {
    const SensitivityColumns added{curve.columns.size(), 1 + model.outputs.size(), model::is_timed(model)};
    const auto is_complete = [&](const model::Step& step) {
        return step.tangent_outputs.size() == model.outputs.size() &&
               step.derivatives.size() == model.parameters.size() * added.quantities;
    };
    if (model.outputs.empty() || model.parameters.empty() || !std::ranges::all_of(steps, is_complete)) return {};
    std::vector<Column> quantities;  // curve.columns grows
    for (const Source source : {Source::load, Source::output})
        for (const Column& column : curve.columns)
            if (column.source == source && column.role == Role::coordinate) quantities.push_back(column);
    const auto slope = [&](std::size_t row, std::size_t q) { return slope_ratio(quantities[q], quantities[1], row); };
    const auto add = [&](auto value_at) {
        Column column;
        column.jumps = !added.in_time;
        for (std::size_t row = 0; row < steps.size(); ++row) column.values.push_back(value_at(row));
        curve.columns.push_back(std::move(column));
    };
    for (std::size_t q = 0; q < added.quantities; ++q) add([&](std::size_t row) { return slope(row, q); });
    for (std::size_t p = 0; p < model.parameters.size(); ++p) {
        const auto derivatives = [&](std::size_t row) { return &steps[row].derivatives[p * added.quantities]; };
        for (std::size_t q = 0; q < added.quantities; ++q)
            add([&](std::size_t row) {
                return with_derivatives(steps, row, [&](std::size_t known) {
                    const double* D = derivatives(known);
                    return added.in_time || D[1] == 0 ? D[q] : D[q] - slope(known, q) * D[1];
                });
            });
        add([&](std::size_t row) {
            return with_derivatives(steps, row, [&](std::size_t known) { return derivatives(known)[1]; });
        });
    }
    return added;
}

double sensitivity_at(std::span<const double> row, const SensitivityColumns& columns, const Sensitivity& which) {
    if (which.quantity == which.held && !columns.in_time) return 0;
    const std::span<const double> slopes = row.subspan(columns.first, columns.quantities),
                                  D = row.subspan(
                                      columns.first + columns.quantities + which.parameter * (columns.quantities + 1),
                                      columns.quantities + 1);
    if (columns.in_time) return D[which.quantity];
    if (which.held == 0 && slopes[0] == 0) return D[which.quantity] + slopes[which.quantity] * D[columns.quantities];
    return D[which.quantity] - slopes[which.quantity] / slopes[which.held] * D[which.held];
}

}  // namespace soft::post
