#include "post/plot_data.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/text.hpp"
#include "post/interpolate.hpp"

namespace soft::post {
namespace {

constexpr int samples_per_interval = 16;  // smooth enough: a cubic spans at most a twentieth of the picture

std::string line(std::initializer_list<double> numbers) {
    std::string text;
    for (const double number : numbers) text.append(text.empty() ? "" : " ").append(core::number_text(number));
    return text + "\n";
}

bool is_located(const model::PathEnd& end, std::size_t row) {
    const auto is_here = [row](const model::LimitPoint& point) { return point.step == static_cast<int>(row); };
    return std::ranges::any_of(end.limit_points, is_here) ||
           std::ranges::any_of(end.bifurcations, is_here, &model::Bifurcation::at);
}

/// Samples the path in two blocks. Between a stable and an unstable row the block changes at the row of a limit point or bifurcation, or
/// in the middle if neither row is one.
void sample_line(const PlotSeries& series, const Path& path, const PlotAxes& axes, Blocks& blocks) {
    const Column* stable = series.curve.find("stable");
    const auto flags = stable != nullptr ? stable->values : std::vector<double>(series.curve.row_count(), 1);
    const auto s = path.row_parameters();
    const std::string* current = nullptr;
    for (std::size_t i = 0; i + 1 < s.size(); ++i) {
        const std::size_t row = path.rows()[i], next = path.rows()[i + 1];
        const bool changes = (flags[row] > 0) != (flags[next] > 0);
        const double change = !changes || is_located(series.end, next) ? 1 : is_located(series.end, row) ? 0 : 0.5;
        for (const bool before : {true, false}) {
            const double from = before ? 0 : change, to = before ? change : 1;
            const auto count = static_cast<int>(std::lround(samples_per_interval * (to - from)));
            if (count == 0) continue;
            std::string& block = flags[before ? row : next] > 0 ? blocks.stable : blocks.unstable;
            if (&block != current && !block.empty()) block += "\n";  // a gap: gnuplot starts a new stroke
            current = &block;
            for (int k = 0; k <= count; ++k) {
                const double t = from + static_cast<double>(k) / samples_per_interval;
                const std::vector<double> state = path.at(s[i] + t * (s[i + 1] - s[i]));
                block += axes.colour ? line({state[axes.x], state[axes.y], state[*axes.colour]})
                                     : line({state[axes.x], state[axes.y]});
                blocks.points.push_back({state[axes.x], state[axes.y]});
            }
        }
    }
}

/// The column with the half width of the error; nullptr if there is none.
const Column* error_of(const Curve& curve, const Column& column) { return curve.find(column.quantity + "_error"); }

/// The columns with the half widths of a band along the axes; nullptr: none.
struct HalfWidths {
    const Column *x = nullptr, *y = nullptr;
};

/// Where the loads are prescribed in time, their bands have no width.
bool is_prescribed(const Column& band, const Column& load) {
    constexpr double negligible = 1e-6;
    const auto largest = [](const Column& column) {
        double size = 0;
        for (const double value : column.values) size = std::max(size, std::abs(value));
        return size;
    };
    return largest(band) <= negligible * largest(load);
}

/// The band of tolerances has a width of the load at a fixed first output; over time of either; of a path in time with prescribed loads,
/// of the output.
HalfWidths tolerances_of(const Curve& curve, const PlotAxes& axes) {
    const Column *load = curve.find(Source::load), *output = curve.find(Source::output);
    if (load == nullptr || output == nullptr) return {};
    const auto band_of = [&](const Column& column) { return curve.find("band_rss_" + column.quantity); };
    if (curve.columns[axes.x].source == Source::time) return {nullptr, band_of(curve.columns[axes.y])};
    const Column *band = band_of(*load), *along = load;
    if (band != nullptr && curve.find(Source::time) != nullptr) {
        if (!is_prescribed(*band, *load)) return {};
        band = band_of(*output);
        along = output;
    }
    const std::size_t by = curve.index_of(*load), over = curve.index_of(*output);
    if (std::minmax(axes.x, axes.y) != std::minmax(by, over)) return {};
    return axes.y == curve.index_of(*along) ? HalfWidths{nullptr, band} : HalfWidths{band, nullptr};
}

/// Closed outlines: the path shifted by +half, then in reverse order by -half; along the ordinate if it has a width, else along the
/// abscissa. A new outline begins where the path turns back, because an area that an outline encloses twice is not filled.
std::string band_outline(const Curve& curve, const Path& path, const PlotAxes& axes, const HalfWidths& widths,
                         std::vector<std::array<double, 2>>& edges) {
    if (widths.x == nullptr && widths.y == nullptr) return {};
    constexpr double no_motion = 1e-9;  // relative to the largest value
    const bool is_up = widths.y != nullptr;
    const std::size_t column = curve.index_of(is_up ? *widths.y : *widths.x), across = is_up ? axes.x : axes.y;
    double largest = 0;
    for (const double value : curve.columns[across].values) largest = std::max(largest, std::abs(value));
    const auto s = path.row_parameters();
    std::string outlines;
    std::vector<std::string> there, back;
    const auto close = [&] {
        if (there.empty()) return;
        if (!outlines.empty()) outlines += "\n";
        for (const std::string& point : there) outlines += point;
        for (auto point = back.rbegin(); point != back.rend(); ++point) outlines += *point;
        there.erase(there.begin(), there.end() - 1);
        back.erase(back.begin(), back.end() - 1);
    };
    int direction = 0;
    double last = 0;
    for (std::size_t i = 0; i + 1 < s.size(); ++i)
        for (int k = i == 0 ? 0 : 1; k <= samples_per_interval; ++k) {
            const std::vector<double> row = path.at(s[i] + (s[i + 1] - s[i]) * k / samples_per_interval);
            const double half = row[column], dx = is_up ? 0 : half, dy = is_up ? half : 0, step = row[across] - last;
            const int now = std::abs(step) <= no_motion * largest ? 0 : step > 0 ? 1 : -1;
            if (now != direction && there.size() > 1) close();
            direction = now;
            last = row[across];
            there.push_back(line({row[axes.x] + dx, row[axes.y] + dy}));
            back.push_back(line({row[axes.x] - dx, row[axes.y] - dy}));
            for (const double way : {1.0, -1.0}) edges.push_back({row[axes.x] + way * dx, row[axes.y] + way * dy});
        }
    close();
    return outlines;
}

void add_markers(const Curve& curve, const PlotAxes& axes, std::size_t max_markers, Blocks& blocks) {
    const Column& x = curve.columns[axes.x];
    const Column& y = curve.columns[axes.y];
    const Column* dx = error_of(curve, x);
    const Column* dy = error_of(curve, y);
    const std::size_t rows = curve.row_count(), stride = std::max<std::size_t>(1, rows / max_markers);
    for (std::size_t row = 0; row < rows; ++row) {
        if (row % stride != 0 && row + 1 != rows) continue;
        blocks.markers += line({x.values[row], y.values[row]});
        if (dx == nullptr && dy == nullptr) continue;
        const double ex = dx != nullptr ? dx->values[row] : 0, ey = dy != nullptr ? dy->values[row] : 0;
        blocks.bars += line({x.values[row], y.values[row], x.values[row] - ex, x.values[row] + ex, y.values[row] - ey,
                             y.values[row] + ey});
    }
}

/// The direction of travel in the middle of each of the first stages.
void add_arrows(const Curve& curve, const Path& path, const PlotAxes& axes, Blocks& blocks) {
    constexpr int max_arrows = 12;
    constexpr double half_length = 0.02;  // of an interval
    const Column* stage = curve.find("stage");
    if (stage == nullptr || stage->role != Role::stage) return;
    const auto s = path.row_parameters();
    const auto is_last_of_stage = [&](std::size_t i) {
        return i + 1 == s.size() || stage->values[path.rows()[i + 1]] != stage->values[path.rows()[i]];
    };
    int arrows = 0;
    for (std::size_t first = 0, i = 1; i < s.size() && arrows < max_arrows; ++i) {
        if (!is_last_of_stage(i)) continue;
        const double middle = 0.5 * (s[first] + s[i]);
        const auto next = std::upper_bound(s.begin(), s.end(), middle);
        const double reach = half_length * (*next - *std::prev(next));
        const std::vector<double> from = path.at(middle - reach), to = path.at(middle + reach);
        first = i;
        if (from[axes.x] == to[axes.x] && from[axes.y] == to[axes.y]) continue;
        blocks.arrows += line({from[axes.x], from[axes.y], to[axes.x] - from[axes.x], to[axes.y] - from[axes.y]});
        ++arrows;
    }
}

/// Adds a line "x y label" and the label for a point that has both coordinates.
void add_labelled(const Column& x, const Column& y, const model::LimitPoint& at, std::string& block,
                  std::vector<PlotLabel>& labels) {
    const auto along = value_at(x, at), up = value_at(y, at);
    if (!along || !up) return;
    const std::string text = value_text(y, *up);
    block += core::number_text(*along) + " " + core::number_text(*up) + " \"" + text + "\"\n";
    labels.push_back({*along, *up, text});
}

}  // namespace

Blocks make_blocks(const PlotSeries& series, const PlotAxes& axes, std::size_t max_markers) {
    Blocks blocks;
    const Curve& curve = series.curve;
    const Column& x = curve.columns[axes.x];
    const Column& y = curve.columns[axes.y];
    const Path path(curve);
    sample_line(series, path, axes, blocks);
    blocks.band = band_outline(curve, path, axes, {error_of(curve, x), error_of(curve, y)}, blocks.edges);
    blocks.tolerances = band_outline(curve, path, axes, tolerances_of(curve, axes), blocks.edges);
    add_markers(curve, axes, max_markers, blocks);
    add_arrows(curve, path, axes, blocks);
    for (const model::LimitPoint& limit : series.end.limit_points)
        add_labelled(x, y, limit, blocks.limits, blocks.labels);
    for (const model::Bifurcation& branch : series.end.bifurcations)
        add_labelled(x, y, branch.at, blocks.bifurcations, blocks.labels);
    return blocks;
}

std::string point_block(const Measured& measured, const PlotAxes& axes) {
    const Series* x = measured.find(axes.x);
    const Series* y = measured.find(axes.y);
    if (x == nullptr || y == nullptr) return {};
    std::string text;
    for (std::size_t row = 0; row < x->values.size(); ++row) text += line({x->values[row], y->values[row]});
    return text;
}

}  // namespace soft::post
