#include "post/plot.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/text.hpp"
#include "post/gnuplot.hpp"
#include "post/interpolate.hpp"

namespace soft::post {
namespace {

constexpr int samples_per_interval = 16;  // a cubic over at most a twentieth of the picture looks smooth

/// Inside gnuplot's single quotes only the quote itself is special.
std::string gnuplot_text(std::string_view text) {
    std::string out = "'";
    for (const char c : text) {
        if (c == '\'') out += '\'';
        out += c == '\n' ? ' ' : c;
    }
    return out + "'";
}

std::string point(double x, double y) { return core::number_text(x) + " " + core::number_text(y) + "\n"; }

bool is_motion(const Curve& curve) { return curve.find("time") != nullptr && curve.find("time")->source == Source::time; }

/// A case without a cavity volume is loaded on a face: its pressure is no cavity's.
std::string axis_label(const Curve& curve, const Column& column) {
    const bool of_cavity = column.source == Source::volume ||
                           (column.quantity == "pressure" && curve.find("volume") != nullptr);
    std::string text = (of_cavity ? "cavity " : "") + column.quantity;
    if (column.source == Source::load) std::replace(text.begin(), text.end(), '_', ' ');   // "load factor"
    return gnuplot_text(column.unit.empty() ? text : text + " (" + column.unit + ")");
}

/// SVG scales; the PNG has twice the pixels so that it prints well.
std::string terminal(PictureFormat format) {
    switch (format) {
        case PictureFormat::svg: return "set terminal svg size 800,560 font 'Helvetica,15' background rgb 'white'\n";
        case PictureFormat::png: break;
    }
    return "if (strstrt(GPVAL_TERMINALS, 'pngcairo')) set terminal pngcairo size 1600,1120 font 'Sans,26' linewidth 2;"
           " else set terminal png size 1600,1120 font 'Sans,26' linewidth 2\n";
}

template <class Wanted>
std::size_t first_column(const Curve& curve, Wanted wanted) {
    const auto hit = std::find_if(curve.columns.begin(), curve.columns.end(), wanted);
    if (hit == curve.columns.end())
        throw Error(ExitCode::bad_input, "--plot", "the case measures neither an output nor a cavity volume",
                    "name one under 'outputs:' of the design");
    return static_cast<std::size_t>(hit - curve.columns.begin());
}

std::size_t measured(const Curve& curve) {   // outputs stand before the volume
    return first_column(curve, [](const Column& column) {
        return column.source == Source::output || column.source == Source::volume;
    });
}

std::size_t column_of(const Curve& curve, Source source) {
    return first_column(curve, [&](const Column& column) { return column.source == source; });
}

/// The load over what is measured; of a motion what is measured over time.
std::size_t abscissa(const Curve& curve) { return is_motion(curve) ? column_of(curve, Source::time) : measured(curve); }
std::size_t ordinate(const Curve& curve) { return is_motion(curve) ? measured(curve) : column_of(curve, Source::load); }

struct Blocks {
    std::string rows, stable, unstable, limits, bifurcations;
};

/// Sampled path in two blocks; a change of stability between two rows is drawn half-way.
void sample_line(const Curve& curve, std::size_t x, std::size_t y, Blocks& blocks) {
    const Path path(curve);
    const std::vector<double>& flags = curve.find("stable")->values;
    const auto s = path.row_parameters();
    const auto part = [&](std::size_t i, int half) -> std::string& {
        return flags[path.rows()[i + static_cast<std::size_t>(half)]] > 0 ? blocks.stable : blocks.unstable;
    };
    const std::string* current = nullptr;
    for (std::size_t i = 0; i + 1 < s.size(); ++i)
        for (int half = 0; half < 2; ++half) {
            std::string& block = part(i, half);
            if (&block != current && !block.empty()) block += "\n";  // a gap: gnuplot starts a new stroke
            current = &block;
            for (int k = 0; k <= samples_per_interval / 2; ++k) {
                const double t = (half + 2.0 * k / samples_per_interval) / 2;
                const std::vector<double> row = path.at(s[i] + t * (s[i + 1] - s[i]));
                block += point(row[x], row[y]);
            }
        }
}

/// A line "x y label" for a point with both coordinates.
std::string labelled(const Column& x, const Column& y, const solution::LimitPoint& at) {
    const auto along = value_at(x, at), load = value_at(y, at);
    if (!along || !load) return {};
    const std::string unit = y.unit.empty() ? "" : " " + y.unit;
    return core::number_text(*along) + " " + core::number_text(*load) + " \"" + core::rounded_text(*load, 4) + unit +
           "\"\n";
}

Blocks make_blocks(const Curve& curve, const solution::PathEnd& end, std::size_t x, std::size_t y) {
    Blocks blocks;
    const Column& along = curve.columns[x];
    const Column& load = curve.columns[y];
    for (std::size_t row = 0; row < curve.row_count(); ++row) blocks.rows += point(along.values[row], load.values[row]);
    sample_line(curve, x, y, blocks);
    for (const solution::LimitPoint& limit : end.limit_points) blocks.limits += labelled(along, load, limit);
    for (const solution::Bifurcation& branch : end.bifurcations) blocks.bifurcations += labelled(along, load, branch.at);
    return blocks;
}

}  // namespace

PictureFormat picture_format(const std::filesystem::path& file) {
    const std::string ending = file.extension().string();
    if (ending == ".svg") return PictureFormat::svg;
    if (ending == ".png") return PictureFormat::png;
    throw Error(ExitCode::usage, file.string(), "pictures are written as .svg or .png");
}

std::string plot_script(const Curve& curve, const solution::PathEnd& end, const PlotText& text, PictureFormat format) {
    std::string script = terminal(format);
    const std::size_t x = abscissa(curve), y = ordinate(curve);
    const Blocks blocks = make_blocks(curve, end, x, y);

    script += "set encoding utf8\nset title " + gnuplot_text(text.title) + " noenhanced\n";
    script += "set xlabel " + axis_label(curve, curve.columns[x]) + " noenhanced\n";
    script += "set ylabel " + axis_label(curve, curve.columns[y]) + " noenhanced\n";
    script += "set grid linecolor rgb '#b0b0b0' linewidth 0.5\nset border 3 linewidth 1\nset tics nomirror out\n";
    script +=
        "set key outside top center horizontal reverse Left samplen 3\nset offsets graph 0, graph 0.03, graph 0.08, 0\n";

    std::string plots;
    const auto add = [&](const char* name, const std::string& data, const std::string& how) {
        if (data.empty()) return;
        script += std::string("$") + name + " << END\n" + data + "END\n";
        plots += (plots.empty() ? "plot $" : ", $") + std::string(name) + " " + how;
    };
    add("stable", blocks.stable,
        std::string{"with lines linewidth 2 linecolor rgb '#0b5394' title '"} + (is_motion(curve) ? "motion" : "equilibrium path") + "'");
    add("unstable", blocks.unstable,
        "with lines linewidth 2 dashtype (8,6) linecolor rgb '#0b5394' title 'unstable part of the path'");
    add("rows", blocks.rows, "with points pointtype 6 pointsize 1 linecolor rgb '#202020' title 'converged steps'");
    add("limits", blocks.limits, "with points pointtype 9 pointsize 2.2 linecolor rgb '#b00000' title 'limit point'");
    add("bifurcations", blocks.bifurcations,
        "with points pointtype 5 pointsize 1.8 linecolor rgb '#b05a00' title 'bifurcation'");
    for (const auto& [name, data] : {std::pair{"limits", &blocks.limits}, {"bifurcations", &blocks.bifurcations}})
        if (!data->empty()) plots += std::string(", $") + name + " using 1:2:3 with labels offset 0,1.2 noenhanced notitle";
    return script + plots + "\n";
}

void draw_plot(const Curve& curve, const solution::PathEnd& end, const PlotText& text,
               const std::filesystem::path& file) {
    run_gnuplot(plot_script(curve, end, text, picture_format(file)), file);
}

}  // namespace soft::post
