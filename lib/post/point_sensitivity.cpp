#include "post/point_sensitivity.hpp"

#include <algorithm>
#include <utility>

#include "post/row_derivatives.hpp"

namespace soft::post {
namespace {

/// The slope of a quantity over the first output along the path, of quantities without slopes from the neighbouring rows; 0 where the body
/// rests at a held load.
double slope(const model::Case& model, std::span<const model::Step> steps, std::size_t row, std::size_t quantity) {
    const model::Step& step = steps[row];
    const auto knows = [&](std::size_t q) { return q == 0 || model::has_slope(model.outputs[q - 1].measure); };
    if (!knows(quantity) || !knows(1)) {
        const auto value = [&](std::size_t at, std::size_t q) {
            return q == 0 ? steps[at].pressure_Pa : steps[at].outputs[q - 1];
        };
        const std::size_t before = row > 0 ? row - 1 : 0, after = std::min(row + 1, steps.size() - 1);
        return (value(after, quantity) - value(before, quantity)) / (value(after, 1) - value(before, 1));
    }
    const double tangent = quantity == 0 ? step.tangent_pressure : step.tangent_outputs[quantity - 1];
    return step.tangent_outputs[0] == 0 && model::holds_load(step) ? 0 : tangent / step.tangent_outputs[0];
}

}  // namespace

SensitivityColumns add_sensitivity_columns(Curve& curve, const model::Case& model, std::span<const model::Step> steps) {
    const SensitivityColumns added{curve.columns.size(), 1 + model.outputs.size(), model::is_timed(model)};
    const auto is_complete = [&](const model::Step& step) {
        return step.tangent_outputs.size() == model.outputs.size() &&
               step.derivatives.size() == model.parameters.size() * added.quantities;
    };
    if (model.outputs.empty() || model.parameters.empty() || !std::ranges::all_of(steps, is_complete)) return {};
    const auto add = [&](auto value_at) {
        Column column;
        for (std::size_t row = 0; row < steps.size(); ++row) column.values.push_back(value_at(row));
        curve.columns.push_back(std::move(column));
    };
    for (std::size_t q = 0; q < added.quantities; ++q)
        add([&](std::size_t row) { return slope(model, steps, row, q); });
    for (std::size_t p = 0; p < model.parameters.size(); ++p) {
        const auto derivatives = [&](std::size_t row) { return &steps[row].derivatives[p * added.quantities]; };
        for (std::size_t q = 0; q < added.quantities; ++q)
            add([&](std::size_t row) {
                return with_derivatives(steps, row, [&](std::size_t known) {
                    const double* D = derivatives(known);
                    return added.in_time || D[1] == 0 ? D[q] : D[q] - slope(model, steps, known, q) * D[1];
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
