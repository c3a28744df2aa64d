#include "solver/row_bars.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace soft::solver {

namespace {

/// Below this fraction of the largest load, errors are relative to this fraction and not to the load itself.
constexpr double small_load = 0.1;

/// A measure stands still where it changes by less than this fraction of its range while the load changes by its whole range.
constexpr double standstill = 0.05;
/// It is not compared at where it changes by less than this fraction of what another measure changes by, as beside a wall that it reaches.
constexpr double slower = 0.25;

/// `point` and `tangent` of the curve from a row's step and number.
template <class Point, class Tangent>
std::vector<ErrorBar> bars_of(const Rows& reported, const NeighbourLevels& around, Point&& point, Tangent&& tangent) {
    std::vector<LevelRow> rows;
    for (std::size_t i = 0; i < reported.size(); ++i) {
        rows.push_back({point(reported[i].step, i), point(around.finer[i].step, i), {}, {}, tangent(reported[i].step)});
        if (!around.before.empty()) rows.back().before = point(around.before[i].step, i);
        if (!around.earlier.empty()) rows.back().earlier = point(around.earlier[i].step, i);
    }
    return error_bars(rows, around.walls);
}

/// On a path in time rows are compared at equal times: of the load and then of each output over the number of the row.
std::vector<ErrorBar> set_bars_in_time(Rows& reported, const NeighbourLevels& around) {
    std::vector<ErrorBar> first;
    const std::size_t outputs = reported.front().step.outputs.size();
    for (RowState& row : reported) row.step.output_errors.clear();
    for (std::size_t k = 0; k <= outputs; ++k) {
        const auto point = [k](const model::Step& step, std::size_t i) {
            return CurvePoint{k == 0 ? step.pressure_Pa : step.outputs[k - 1], static_cast<double>(i)};
        };
        auto bars = bars_of(reported, around, point, [](const model::Step&) { return CurvePoint{0.0, 0.0}; });
        for (std::size_t i = 0; i < bars.size(); ++i) {
            if (k == 0) reported[i].step.pressure_error_Pa = bars[i].load;
            if (k > 0) reported[i].step.output_errors.push_back(bars[i].load);
        }
        if (k <= 1) first = std::move(bars);
    }
    return first;
}

/// Where the leading load is held, the outputs are compared at equal progress of the loads: each row is shifted along the tangent of the
/// reported one.
void set_bars_at_held_loads(Rows& reported, const NeighbourLevels& around) {
    for (std::size_t k = 0; k < reported.front().step.outputs.size(); ++k) {
        const auto point = [&](const model::Step& step, std::size_t i) {
            const model::Step& at = reported[i].step;
            const double shift = model::holds_load(at) ? at.tangent_outputs[k] / at.tangent_load_factor *
                                                             (at.load_factor - step.load_factor)
                                                       : 0.0;
            return CurvePoint{step.outputs[k] + shift, static_cast<double>(i)};
        };
        const auto bars = bars_of(reported, around, point, [](const model::Step&) { return CurvePoint{0.0, 0.0}; });
        for (std::size_t i = 0; i < bars.size(); ++i)
            if (model::holds_load(reported[i].step)) reported[i].step.output_errors[k] = bars[i].load;
    }
    for (RowState& row : reported)
        if (model::holds_load(row.step)) row.step.pressure_error_Pa = 0.0;  // it is prescribed
}

/// Largest minus smallest value of a quantity over the rows.
template <class Value>
double range_of(const Rows& rows, Value&& value_of) {
    double least = value_of(rows.front().step), largest = least;
    for (const RowState& row : rows) {
        least = std::min(least, value_of(row.step));
        largest = std::max(largest, value_of(row.step));
    }
    return largest - least;
}

/// The quantities at whose equal values loads are compared: the outputs in their order, then the volume.
class Measures {
public:
    explicit Measures(const Rows& rows) {
        const model::Step& first = rows.front().step;
        for (std::size_t k = 0; k < first.outputs.size(); ++k) measures_.push_back({k});
        if (first.volume_m3) measures_.push_back({Measure::volume});
        load_range_ = range_of(rows, [](const model::Step& step) { return step.pressure_Pa; });
        for (const Measure& measure : measures_)
            ranges_.push_back(range_of(rows, [&](const model::Step& step) { return measure.point(step).measure; }));
    }
    [[nodiscard]] const std::vector<Measure>& all() const { return measures_; }
    /// The first one that moves well at a row, or that which moves most; nullopt where none does, or the load is held.
    [[nodiscard]] std::optional<std::size_t> moving(const model::Step& step) const {
        std::size_t most = 0;
        for (std::size_t k = 0; k < measures_.size(); ++k)
            if (rate(step, k) > rate(step, most)) most = k;
        for (std::size_t k = 0; k < most; ++k)
            if (rate(step, k) > std::max(standstill, slower * rate(step, most))) return k;
        const bool is_known = measures_[most].tangent(step).load != 0 || model::holds_load(step);
        return rate(step, most) > 0 || !is_known ? std::optional{most} : std::nullopt;
    }
    /// Whether all outputs stand still, of which one moves elsewhere, so that their own bars count.
    [[nodiscard]] bool outputs_stand_still(const model::Step& step) const {
        bool stand_still = true, move = false;
        for (std::size_t k = 0; k < step.outputs.size(); ++k) {
            stand_still = stand_still && rate(step, k) <= standstill;
            move = move || ranges_[k] > 0;
        }
        return stand_still && move;
    }

private:
    /// Change over that of the load, relative to their ranges; 0 where the load is held and where the tangent is unknown.
    [[nodiscard]] double rate(const model::Step& step, std::size_t k) const {
        const CurvePoint tangent = measures_[k].tangent(step);
        if (model::holds_load(step) || tangent.measure == 0 || !(ranges_[k] > 0)) return 0;
        return std::abs(tangent.measure / tangent.load) * load_range_ / ranges_[k];
    }

    std::vector<Measure> measures_;
    double load_range_;
    std::vector<double> ranges_;
};

}  // namespace

std::vector<ErrorBar> set_bars(Rows& reported, const NeighbourLevels& around) {
    if (reported.front().step.time_s) return set_bars_in_time(reported, around);
    const Measures measures(reported);
    std::vector<std::vector<ErrorBar>> bars;
    for (const Measure& measure : measures.all())
        bars.push_back(bars_of(
            reported, around, [&](const model::Step& step, std::size_t) { return measure.point(step); },
            [&](const model::Step& step) { return measure.tangent(step); }));
    std::vector<ErrorBar> of_moving;
    for (std::size_t i = 0; i < reported.size(); ++i) {
        model::Step& step = reported[i].step;
        const auto moving = measures.moving(step);
        of_moving.push_back(bars[moving.value_or(0)][i]);
        step.pressure_error_Pa = moving ? bars[*moving][i].load : 0.0;
        step.output_errors.clear();
        for (std::size_t k = 0; k < step.outputs.size(); ++k) step.output_errors.push_back(bars[k][i].measure);
    }
    if (std::ranges::any_of(reported, [](const RowState& row) { return model::holds_load(row.step); }))
        set_bars_at_held_loads(reported, around);
    return of_moving;
}

double max_relative_bar(const Rows& rows) {
    const bool in_time = rows.front().step.time_s.has_value();
    const Measures measures(rows);
    double worst = 0;
    const auto consider = [&](auto&& value_of, auto&& bar_of, bool where_moving) {
        double largest = 0;
        for (const RowState& row : rows) largest = std::max(largest, std::abs(value_of(row.step)));
        for (const RowState& row : rows)
            if (largest > 0.0 && (in_time || measures.outputs_stand_still(row.step) != where_moving))
                worst =
                    std::max(worst, bar_of(row.step) / std::max(std::abs(value_of(row.step)), small_load * largest));
    };
    consider([](const model::Step& step) { return step.pressure_Pa; },
             [](const model::Step& step) { return step.pressure_error_Pa.value_or(0.0); }, true);
    for (std::size_t k = 0; k < rows.front().step.outputs.size(); ++k)
        consider([k](const model::Step& step) { return step.outputs[k]; },
                 [k](const model::Step& step) { return step.output_errors[k]; }, false);
    return worst;
}

}  // namespace soft::solver
