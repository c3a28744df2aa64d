#include "post/plot.hpp"

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "core/text.hpp"
#include "post/gnuplot.hpp"
#include "post/plot_data.hpp"

namespace soft::post {
namespace {

/// Style that distinguishes a path: one of gnuplot's open point types and a colour. Filled triangles and squares are reserved for limit
/// points and bifurcations.
struct Style {
    int point;
    const char* colour;
};
constexpr std::array<Style, 7> styles = {{{6, "#0072B2"},
                                          {12, "#D55E00"},
                                          {4, "#009E73"},
                                          {10, "#CC79A7"},
                                          {14, "#E69F00"},
                                          {8, "#56B4E9"},
                                          {1, "#000000"}}};
constexpr std::size_t max_markers_single = 400, max_markers_several = 16;

/// A case without a cavity volume is loaded on a face, so its pressure is not called a cavity pressure.
std::string axis_label(const Curve& curve, const Column& column) {
    const bool of_cavity =
        column.source == Source::volume || (column.quantity == "pressure" && curve.find("volume") != nullptr);
    std::string text = of_cavity ? "cavity " : "";
    text += column.quantity;
    std::replace(text.begin(), text.end(), '_', ' ');  // "load factor"
    return gnuplot_text(column.unit.empty() ? text : text + " (" + column.unit + ")");
}

std::size_t output_column(const Curve& curve, const Measured* measured) {  // outputs come before the volume
    for (std::size_t i = 0; i < curve.columns.size(); ++i)
        if (const Source source = curve.columns[i].source; source == Source::output || source == Source::volume)
            if (measured == nullptr || measured->find(i) != nullptr) return i;
    throw Error(ExitCode::bad_input, "--plot", "the case measures neither an output nor a cavity volume",
                "name one under 'outputs:' of the design");
}

std::size_t named_column(const Curve& curve, const std::string& name, const char* option) {
    std::vector<std::string> known;
    for (std::size_t i = 0; i < curve.columns.size(); ++i) {
        if (curve.columns[i].quantity == name || curve.columns[i].name == name) return i;
        known.push_back(curve.columns[i].quantity);
    }
    throw Error(ExitCode::usage, option, "the curve has no " + core::quoted(name), core::did_you_mean(name, known));
}

/// A path in time without inertia is drawn as any path: its loops show what the rubber dissipates.
bool is_motion(const Curve& curve) { return curve.find("kinetic_energy") != nullptr; }

/// The axes of the first series in another series.
PlotAxes same_axes(const PlotSeries& first, const PlotAxes& axes, const PlotSeries& other) {
    const auto same = [&](std::size_t column) {
        const std::string& name = first.curve.columns[column].name;
        for (std::size_t i = 0; i < other.curve.columns.size(); ++i)
            if (other.curve.columns[i].name == name) return i;
        throw Error(ExitCode::bad_input, "--with " + other.label, "the curve has no " + core::quoted(name),
                    "choose other axes with --x and --y");
    };
    return {same(axes.x), same(axes.y), axes.colour ? std::optional{same(*axes.colour)} : std::nullopt};
}

/// Builds a script from data blocks and entries of the plot command.
class Script {
public:
    Script(std::string head, PictureFormat format)
        : head_(std::move(head)), scale_(format == PictureFormat::svg ? 0.45 : 1) {}

    /// Scales point sizes: relative to its text, the SVG terminal draws larger points than the others.
    [[nodiscard]] std::string points(int type, double size) const {
        return "pointtype " + std::to_string(type) + " pointsize " + core::rounded_text(scale_ * size, 3);
    }

    void block(const std::string& name, const std::string& data) { head_ += "$" + name + " << END\n" + data + "END\n"; }
    void plot(const std::string& what) { plots_.append(plots_.empty() ? "plot " : ", ").append(what); }
    /// Adds the block and its plot entry; does nothing for empty data.
    void add(const std::string& name, const std::string& data, const std::string& how) {
        if (data.empty()) return;
        block(name, data);
        plot("$" + name + " " + how);
    }
    void legend(const std::string& how, const std::string& title) { plot("keyentry " + how + " title " + title); }
    [[nodiscard]] std::string text() const { return head_ + plots_ + "\n"; }

private:
    std::string head_, plots_;
    double scale_;
};

constexpr const char* filled = "with filledcurves closed fillstyle transparent solid 0.2 noborder";

/// Colour map viridis, with uniformly increasing lightness (Smith and van der Walt, 2015).
constexpr const char* path_palette =
    "set palette defined (0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#5ec962', 4 '#fde725')\n";

/// The axis starts at 0 if the curve starts near 0 and stays positive, even if error bands extend below 0.
std::string from_zero(const char* range, std::span<const std::array<double, 2>> points, std::size_t i) {
    constexpr double max_start = 0.02, rounding = 1e-6;  // relative to the largest value
    double low = 0, high = 0;
    for (const auto& point : points) {
        low = &point == points.data() ? point[i] : std::min(low, point[i]);
        high = std::max(high, point[i]);
    }
    return low >= -rounding * high && low < max_start * high ? std::string{"set "} + range + " [0:*]\n" : "";
}

std::string heading(const Curve& curve, const PlotAxes& axes, const PlotRequest& request, PictureFormat format) {
    return terminal(format) + "set encoding utf8\n" + "set xlabel " + axis_label(curve, curve.columns[axes.x]) +
           " noenhanced\n" + "set ylabel " + axis_label(curve, curve.columns[axes.y]) + " noenhanced\n" + axes_style() +
           "set bars 0.5\n" +
           (axes.colour ? std::string{path_palette} +
                              ("set cblabel " + axis_label(curve, curve.columns[*axes.colour]) + " noenhanced\n")
                        : std::string{}) +
           "set key outside top center horizontal reverse Left samplen 3 noenhanced\n" +
           (request.title.empty() ? "" : "set title " + gnuplot_text(request.title) + " noenhanced\n") +
           "set offsets graph 0, graph 0.03, graph 0.08, 0\n";
}

/// Elements that the legend explains once for all paths.
struct LegendEntries {
    bool unstable = false, band = false, tolerances = false, limits = false, bifurcations = false;
};

void add_path(Script& script, const Blocks& blocks, const PlotAxes& axes, std::size_t index, double point_size,
              LegendEntries& legend) {
    const Style style = styles[index % styles.size()];
    const std::string n = std::to_string(index + 1), colour = std::string{" linecolor rgb '"} + style.colour + "'";
    const std::string stroke =
        axes.colour ? "using 1:2:3 with lines linewidth 5 linecolor palette" : "with lines linewidth 2" + colour;
    script.add("band" + n, blocks.band, filled + colour + " notitle");
    script.add("stable" + n, blocks.stable, stroke + " notitle");
    script.add("unstable" + n, blocks.unstable, stroke + " dashtype (8,6) notitle");
    script.add("bars" + n, blocks.bars, "with xyerrorbars linewidth 1 pointtype 0" + colour + " notitle");
    script.add("tolerances" + n, blocks.tolerances, std::string{filled} + " linecolor rgb '#E69F00' notitle");
    script.add("markers" + n, blocks.markers,
               "with points " + script.points(style.point, point_size) + colour + " notitle");
    script.add("limits" + n, blocks.limits,
               "with points " + script.points(9, 2.2) + " linecolor rgb '#b00000' notitle");
    script.add("bifurcations" + n, blocks.bifurcations,
               "with points " + script.points(5, 1.8) + " linecolor rgb '#b05a00' notitle");
    script.add("arrows" + n, blocks.arrows,
               "with vectors head filled size screen 0.02,20,60 fixed linewidth 1" + colour + " notitle");
    legend.unstable |= !blocks.unstable.empty();
    legend.band |= !blocks.band.empty();
    legend.tolerances |= !blocks.tolerances.empty();
    legend.limits |= !blocks.limits.empty();
    legend.bifurcations |= !blocks.bifurcations.empty();
}

/// A path whose colour shows a quantity has no colour of its own: the legend shows only its markers.
void add_legend(Script& script, std::span<const PlotSeries> series, const PlotAxes& axes, const LegendEntries& legend) {
    const std::string shown = axes.colour ? "with points " : "with linespoints ";
    const auto sign = [&](std::size_t i) {
        const Style style = styles[i % styles.size()];
        return script.points(style.point, 1.5) + " linewidth 2 linecolor rgb '" + style.colour + "'";
    };
    if (series.size() == 1)
        script.legend(shown + sign(0), is_motion(series[0].curve) ? "'motion'" : "'converged steps'");
    else
        for (std::size_t i = 0; i < series.size(); ++i) script.legend(shown + sign(i), gnuplot_text(series[i].label));
    if (legend.unstable) script.legend("with lines linewidth 2 dashtype (8,6) linecolor rgb '#404040'", "'unstable'");
    if (legend.band) script.legend(filled + std::string{" linecolor rgb '#0072B2'"}, "'mesh error'");
    if (legend.tolerances) script.legend(filled + std::string{" linecolor rgb '#E69F00'"}, "'tolerances'");
    if (legend.limits)
        script.legend("with points " + script.points(9, 2.2) + " linecolor rgb '#b00000'", "'limit point'");
    if (legend.bifurcations)
        script.legend("with points " + script.points(5, 1.8) + " linecolor rgb '#b05a00'", "'bifurcation'");
}

}  // namespace

PlotAxes plot_axes(const Curve& curve, const PlotRequest& request, const Measured* measured) {
    const bool moves = is_motion(curve);
    const auto usual_x = [&] {
        return moves ? curve.index_of(*curve.find(Source::time)) : output_column(curve, measured);
    };
    const auto usual_y = [&] {
        return moves ? output_column(curve, measured) : curve.index_of(*curve.find(Source::load));
    };
    const auto named = [&](const std::string& name, const char* option) {
        const std::size_t column = named_column(curve, name, option);
        if (measured != nullptr && measured->find(column) == nullptr)
            throw Error(ExitCode::usage, option, core::quoted(name) + " was not measured",
                        "plot without --compare, or choose a measured quantity");
        return column;
    };
    return {request.x.empty() ? usual_x() : named(request.x, "--x"),
            request.y.empty() ? usual_y() : named(request.y, "--y"),
            request.colour.empty() ? std::nullopt : std::optional{named_column(curve, request.colour, "--colour")}};
}

std::string plot_script(std::span<const PlotSeries> series, const Measured* measured, const PlotRequest& request,
                        PictureFormat format) {
    const PlotSeries& first = series.front();
    const PlotAxes axes = plot_axes(first.curve, request, measured);
    const bool single = series.size() == 1;
    std::vector<Blocks> blocks;
    std::vector<std::array<double, 2>> drawn, edges;
    std::vector<PlotLabel> labels;
    for (std::size_t i = 0; i < series.size(); ++i) {
        const PlotAxes own = i == 0 ? axes : same_axes(first, axes, series[i]);
        blocks.push_back(make_blocks(series[i], own, single ? max_markers_single : max_markers_several));
        drawn.insert(drawn.end(), blocks.back().points.begin(), blocks.back().points.end());
        edges.insert(edges.end(), blocks.back().edges.begin(), blocks.back().edges.end());
        labels.insert(labels.end(), blocks.back().labels.begin(), blocks.back().labels.end());
    }
    const std::string ranges = measured != nullptr ? "" : from_zero("xrange", drawn, 0) + from_zero("yrange", drawn, 1);
    edges.insert(edges.end(), drawn.begin(), drawn.end());
    Script script(heading(first.curve, axes, request, format) + ranges + label_commands(labels, edges), format);
    LegendEntries legend;
    for (std::size_t i = 0; i < series.size(); ++i) add_path(script, blocks[i], axes, i, single ? 1.2 : 2, legend);
    const std::string crosses = "with points " + script.points(2, 1.5) + " linewidth 1.5 linecolor rgb '#000000'";
    const std::string points = measured != nullptr ? point_block(*measured, axes) : "";
    script.add("measured", points, crosses + " notitle");
    add_legend(script, series, axes, legend);
    if (!points.empty()) script.legend(crosses, "'measured'");
    return script.text();
}

void draw_plot(std::span<const PlotSeries> series, const Measured* measured, const PlotRequest& request,
               const std::filesystem::path& file) {
    run_gnuplot(plot_script(series, measured, request, picture_format(file)), file);
}

}  // namespace soft::post
