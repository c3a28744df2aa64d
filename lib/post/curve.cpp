#include "post/curve.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/error.hpp"

namespace soft::post {
namespace {

constexpr double kilopascal_Pa = 1e3, millimetre_m = 1e-3, millilitre_m3 = 1e-6;

Column coordinate(std::string quantity, core::Dimension dimension, std::string unit, double SI_per_unit) {
    Column column;
    column.name = quantity + "_" + unit;
    column.quantity = std::move(quantity);
    column.unit = std::move(unit);
    column.dimension = dimension;
    column.SI_per_unit = SI_per_unit;
    column.role = Role::coordinate;
    return column;
}

Column plain(std::string name, Role role) {
    Column column;
    column.name = name;
    column.quantity = std::move(name);
    column.role = role;
    return column;
}

void push(Column& column, double value_SI, double slope_SI) {
    column.values.push_back(in_column_unit(column, value_SI));
    column.slopes.push_back(in_column_unit(column, slope_SI));
}

void check(std::span<const solution::Step> steps, std::size_t output_count) {
    for (std::size_t row = 0; row < steps.size(); ++row) {
        const solution::Step& step = steps[row];
        const std::string place = "path, step " + std::to_string(row);
        if (step.outputs_m.size() != output_count)
            throw Error(ExitCode::bad_input, place,
                        std::to_string(step.outputs_m.size()) + " outputs are recorded, the case measures " +
                            std::to_string(output_count));
        if (step.volume_m3.has_value() != steps.front().volume_m3.has_value())
            throw Error(ExitCode::bad_input, place, "the cavity volume is recorded at some of the steps only");
    }
}

}  // namespace

double in_column_unit(const Column& column, double value_SI) noexcept {
    // 1000 is an exact double, 1e-3 is not: multiply by the inverse where that is a whole number
    const double inverse = 1 / column.SI_per_unit, whole = std::round(inverse);
    if (std::abs(inverse - whole) <= 1e-12 * inverse) return value_SI * whole;
    return value_SI / column.SI_per_unit;
}

const Column* Curve::find(std::string_view quantity) const noexcept {
    const auto hit =
        std::find_if(columns.begin(), columns.end(), [&](const Column& column) { return column.quantity == quantity; });
    return hit == columns.end() ? nullptr : &*hit;
}

std::string Curve::coordinate_names() const {
    std::string names;
    for (const Column& column : columns)
        if (column.role == Role::coordinate) names.append(names.empty() ? "" : ", ").append(column.quantity);
    return names;
}

Curve make_curve(std::span<const std::string> output_names, std::span<const solution::Step> steps,
                 std::string_view load) {
    check(steps, output_names.size());
    const bool has_volume = !steps.empty() && steps.front().volume_m3.has_value();

    Column number = plain("step", Role::counter);
    Column pressure = coordinate(std::string(load), core::Dimension::pressure, "kPa", kilopascal_Pa);
    Column volume = coordinate("volume", core::Dimension::volume, "mL", millilitre_m3);
    Column p99 = plain("stretch_p99", Role::follower), largest = plain("max_stretch", Role::follower);
    Column jacobian = plain("min_J", Role::follower), stable = plain("stable", Role::flag);
    std::vector<Column> outputs;
    for (const std::string& name : output_names)
        outputs.push_back(coordinate(name, core::Dimension::length, "mm", millimetre_m));

    for (const solution::Step& step : steps) {
        number.values.push_back(static_cast<double>(number.values.size()));
        push(pressure, step.pressure_Pa, step.tangent_pressure);
        for (std::size_t i = 0; i < outputs.size(); ++i)
            push(outputs[i], step.outputs_m[i], i < step.tangent_outputs.size() ? step.tangent_outputs[i] : 0);
        if (has_volume) push(volume, *step.volume_m3, step.tangent_volume);
        p99.values.push_back(step.stretch_p99);
        largest.values.push_back(step.max_stretch);
        jacobian.values.push_back(step.min_jacobian);
        stable.values.push_back(step.stable ? 1 : 0);
    }

    Curve curve;
    curve.columns = {std::move(number), std::move(pressure)};
    std::move(outputs.begin(), outputs.end(), std::back_inserter(curve.columns));
    if (has_volume) curve.columns.push_back(std::move(volume));
    for (Column* column : {&p99, &largest, &jacobian, &stable}) curve.columns.push_back(std::move(*column));
    return curve;
}

}  // namespace soft::post
