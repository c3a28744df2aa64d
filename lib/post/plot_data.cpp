#include "post/plot_data.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/text.hpp"
#include "post/interpolate.hpp"

namespace soft::post {
namespace {

constexpr int samples_per_band_piece = 64;  // a piece may span many rows of the path
constexpr int samples_per_interval = 16;    // smooth enough: a cubic spans at most a twentieth of the picture

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
    const std::vector<double>& flags = series.curve.find("stable")->values;
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

/// Closed outline: the path shifted by +error, then in reverse order by -error; along the ordinate if its error is known, else along the
/// abscissa.
std::string band_outline(const Curve& curve, const Path& path, const PlotAxes& axes,
                         std::vector<std::array<double, 2>>& edges) {
    const Column* up = error_of(curve, curve.columns[axes.y]);
    const Column* across = error_of(curve, curve.columns[axes.x]);
    if (up == nullptr && across == nullptr) return {};
    const std::size_t error = curve.index_of(up != nullptr ? *up : *across);
    const auto s = path.row_parameters();
    std::string there;
    std::vector<std::string> back;
    for (std::size_t i = 0; i + 1 < s.size(); ++i)
        for (int k = i == 0 ? 0 : 1; k <= samples_per_interval; ++k) {
            const std::vector<double> row = path.at(s[i] + (s[i + 1] - s[i]) * k / samples_per_interval);
            const double half = row[error], dx = up != nullptr ? 0 : half, dy = up != nullptr ? half : 0;
            there += line({row[axes.x] + dx, row[axes.y] + dy});
            back.push_back(line({row[axes.x] - dx, row[axes.y] - dy}));
            for (const double way : {1.0, -1.0}) edges.push_back({row[axes.x] + way * dx, row[axes.y] + way * dy});
        }
    for (auto point = back.rbegin(); point != back.rend(); ++point) there += *point;
    return there;
}

/// A row of the band's table in the plane of the axes. The bar is drawn along the axis whose other quantity is prescribed, or along both
/// if neither is.
struct BandPoint {
    double x, y, dx, dy;
    std::optional<double> s;  ///< path parameter of the nearest crossing with the prescribed value
};

std::optional<double> nearest_crossing(const Path& path, std::size_t fixed, double value, std::size_t other,
                                       double other_value) {
    std::optional<double> nearest;
    double least = 0;
    for (const double s : path.crossings(fixed, path.within_reach(fixed, value))) {
        const double distance = std::abs(path.at(s)[other] - other_value);
        if (!nearest || distance < least) nearest = s, least = distance;
    }
    return nearest;
}

std::vector<BandPoint> band_points(const Band& band, const Path& path, const PlotAxes& axes) {
    const Band::Width* x = band.find(axes.x);
    const Band::Width* y = band.find(axes.y);
    std::vector<BandPoint> points;
    for (std::size_t row = 0; x != nullptr && y != nullptr && row < x->values.size(); ++row) {
        const double dx = x->half(row), dy = y->half(row);
        BandPoint point{x->values[row], y->values[row], std::isnan(dx) ? 0 : dx, std::isnan(dy) ? 0 : dy, {}};
        if (std::isnan(dx) && point.dy > 0) point.s = nearest_crossing(path, axes.x, point.x, axes.y, point.y);
        if (std::isnan(dy) && point.dx > 0) point.s = nearest_crossing(path, axes.y, point.y, axes.x, point.x);
        if (point.dx > 0 || point.dy > 0) points.push_back(point);
    }
    std::ranges::stable_sort(points, {}, [](const BandPoint& point) { return point.s.value_or(0); });
    return points;
}

/// Closed outline of the band between two rows of its table; the width is linear in the path parameter.
std::string band_piece(const Path& path, const PlotAxes& axes, const BandPoint& from, const BandPoint& to,
                       std::vector<std::array<double, 2>>& edges) {
    std::string there;
    std::vector<std::string> back;
    for (int k = 0; k <= samples_per_band_piece; ++k) {
        const double t = static_cast<double>(k) / samples_per_band_piece;
        const std::vector<double> row = path.at(*from.s + t * (*to.s - *from.s));
        const double dx = from.dx + t * (to.dx - from.dx), dy = from.dy + t * (to.dy - from.dy);
        there += line({row[axes.x] + dx, row[axes.y] + dy});
        back.push_back(line({row[axes.x] - dx, row[axes.y] - dy}));
        for (const double way : {1.0, -1.0}) edges.push_back({row[axes.x] + way * dx, row[axes.y] + way * dy});
    }
    for (auto point = back.rbegin(); point != back.rend(); ++point) there += *point;
    return there;
}

/// Throws Error(bad_input) for a point far from the curve: the table belongs to another material or case.
void check_band_point(const BandPoint& point, const Curve& curve, const Path& path, const PlotAxes& axes) {
    constexpr double max_distance =
        0.05;  // of the largest value of an axis: above the errors of meshes and interpolation
    if (!point.s) return;
    const std::vector<double> state = path.at(*point.s);
    for (const auto& [axis, value] : {std::pair{axes.x, point.x}, {axes.y, point.y}}) {
        const Column& column = curve.columns[axis];
        if (std::abs(state[axis] - value) <=
            max_distance * std::abs(std::ranges::max(column.values, {}, [](double v) { return std::abs(v); })))
            continue;
        throw Error(ExitCode::bad_input, "--band",
                    "the table has " + column.quantity + " " + value_text(column, value) + " where the curve has " +
                        value_text(column, state[axis]),
                    "give the table of a result with the material of the fit");
    }
}

void add_constants(const Band& band, const Curve& curve, const Path& path, const PlotAxes& axes, Blocks& blocks) {
    const std::vector<BandPoint> points = band_points(band, path, axes);
    for (const BandPoint& point : points) check_band_point(point, curve, path, axes);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const BandPoint& p = points[i];
        blocks.constants_bars += line({p.x, p.y, p.x - p.dx, p.x + p.dx, p.y - p.dy, p.y + p.dy});
        if (i == 0 || !points[i - 1].s || !p.s || (points[i - 1].dx > 0) != (p.dx > 0)) continue;
        if (!blocks.constants.empty()) blocks.constants += "\n";
        blocks.constants += band_piece(path, axes, points[i - 1], p, blocks.edges);
    }
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
    blocks.band = band_outline(curve, path, axes, blocks.edges);
    if (series.band) add_constants(*series.band, curve, path, axes, blocks);
    add_markers(curve, axes, max_markers, blocks);
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
