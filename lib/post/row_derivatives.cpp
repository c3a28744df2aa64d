#include "post/row_derivatives.hpp"

#include <algorithm>
#include <cmath>

namespace soft::post {

double with_derivatives(std::span<const model::Step> steps, std::size_t row,
                        const std::function<double(std::size_t)>& value) {
    const auto has_none = [steps](std::size_t at) {
        return std::ranges::find(steps[at].derivatives, model::no_derivative) != steps[at].derivatives.end();
    };
    std::size_t before = row, after = row;
    while (before > 0 && has_none(before)) --before;
    while (after + 1 < steps.size() && has_none(after)) ++after;
    if (before == row) return value(row);
    if (has_none(after)) return value(before);
    const double from = steps[before].outputs[0], to = steps[after].outputs[0];
    const double share = from == to ? 0 : std::clamp((steps[row].outputs[0] - from) / (to - from), 0.0, 1.0);
    return std::lerp(value(before), value(after), share);
}

double slope_ratio(const Column& of, const Column& by, std::size_t row) {
    const auto ratio = [&](double change, double turn) {
        return turn == 0 ? 0 : change / turn * (of.SI_per_unit / by.SI_per_unit);
    };
    if (!of.slopes.empty() && !by.slopes.empty()) return ratio(of.slopes[row], by.slopes[row]);
    const std::size_t before = row > 0 ? row - 1 : 0, after = std::min(row + 1, by.values.size() - 1);
    return ratio(of.values[after] - of.values[before], by.values[after] - by.values[before]);
}

}  // namespace soft::post
