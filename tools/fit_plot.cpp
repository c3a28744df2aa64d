#include "fit_plot.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/text.hpp"
#include "post/gnuplot.hpp"
#include "post/plot.hpp"

namespace soft::cli {
namespace {

constexpr std::size_t max_laws = 3;  // more lines are hard to distinguish
constexpr int samples = 200;
constexpr int panel_width = 520, height = 640;

std::string terminal(post::PictureFormat format, std::size_t panels) {
    const int width = panel_width * static_cast<int>(panels);
    const auto size = [&](int factor) {
        return std::to_string(factor * width) + "," + std::to_string(factor * height);
    };
    switch (format) {
        case post::PictureFormat::svg:
            return "set terminal svg size " + size(1) + " font 'Helvetica,13' background rgb 'white'\n";
        case post::PictureFormat::pdf:
            return "set terminal pdfcairo size " + std::to_string(static_cast<int>(panels) * 12) +
                   "cm,15cm font 'Helvetica,9' linewidth 1.2\n";
        case post::PictureFormat::png: break;
    }
    return "if (strstrt(GPVAL_TERMINALS, 'pngcairo')) set terminal pngcairo size " + size(2) +
           " font 'Sans,24' linewidth 2; else set terminal png size " + size(2) + "\n";
}

std::string point(double x, double y) { return core::number_text(x) + " " + core::number_text(y) + "\n"; }

std::string block(const std::string& name, const std::string& data) {
    return "$" + name + " << END\n" + data + "END\n";
}

/// Measured stress, and the residual of each law, of one mode.
struct Panel {
    fit::Mode mode;
    std::string data, measured, lines, residuals;  // `data`: gnuplot data blocks
};

std::string law_name(const fit::RankedFit& one) { return std::string{one.fit.candidate.name}; }

Panel panel_of(fit::Mode mode, const std::vector<fit::RankedFit>& ranked, const std::vector<fit::TestCurve>& tests) {
    const std::string id{fit::name_of(mode)};
    Panel panel{
        mode, {}, "$" + id + " with points pointtype 6 pointsize 1 linecolor rgb '#202020' title 'test'", {}, {}};
    std::string measured;
    double longest = 1, shortest = 1;
    for (const fit::TestCurve& test : tests)
        for (std::size_t i = 0; test.mode == mode && i < test.stretch.size(); ++i) {
            measured += point(test.stretch[i], test.nominal_Pa[i] / 1e3);
            longest = std::max(longest, test.stretch[i]);
            shortest = std::min(shortest, test.stretch[i]);
        }
    panel.data = block(id, measured);
    for (std::size_t law = 0; law < std::min(max_laws, ranked.size()); ++law) {
        const fit::Fit& fitted = ranked[law].fit;
        std::string curve, residual;
        const bool in_time = !fitted.predicted_Pa.empty();
        for (std::size_t t = 0; in_time && t < tests.size(); ++t) {
            for (std::size_t i = 0; tests[t].mode == mode && i < tests[t].stretch.size(); ++i)
                curve += point(tests[t].stretch[i], fitted.predicted_Pa[t][i] / 1e3);
            curve += "\n";  // a gap between tests
        }
        for (int i = 0; !in_time && i <= samples; ++i) {
            const double stretch = shortest + (longest - shortest) * i / samples;
            curve += point(stretch, fitted.nominal_stress_Pa(mode, stretch) / 1e3);
        }
        for (std::size_t t = 0; t < tests.size(); ++t)
            for (std::size_t i = 0; tests[t].mode == mode && i < tests[t].stretch.size(); ++i)
                residual +=
                    point(tests[t].stretch[i],
                          ((in_time ? fitted.predicted_Pa[t][i] : fitted.nominal_stress_Pa(mode, tests[t].stretch[i])) +
                           fitted.tests[t].offset_Pa.value_or(0) - tests[t].nominal_Pa[i]) /
                              1e3);
        const std::string name = id + std::to_string(law), style = " linewidth 2 linecolor " + std::to_string(law + 1);
        panel.data += block(name, curve) + block(name + "r", residual);
        const std::string drawn = " with lines" + style + " dashtype " + std::to_string(law + 1);
        panel.lines.append(", $" + name + drawn + " title '" + law_name(ranked[law]) + "'");
        panel.residuals.append((law == 0 ? "$" : ", $") + name + "r" + drawn + " notitle");
    }
    return panel;
}

}  // namespace

void draw_fits(const std::vector<fit::RankedFit>& ranked, const std::vector<fit::TestCurve>& tests,
               const std::filesystem::path& file) {
    std::set<fit::Mode> modes;
    for (const fit::TestCurve& test : tests) modes.insert(test.mode);
    std::vector<Panel> panels;
    for (const fit::Mode mode : modes) panels.push_back(panel_of(mode, ranked, tests));
    std::string script = terminal(post::picture_format(file), panels.size());
    for (const Panel& panel : panels) script += panel.data;
    script +=
        "set encoding utf8\nset grid linecolor rgb '#b0b0b0' linewidth 0.5\nset border 3\nset tics nomirror out\n"
        "set key top left reverse Left samplen 3\nset xlabel 'stretch'\n"
        "set multiplot layout 2," +
        std::to_string(panels.size()) + " rowsfirst\n";
    for (const Panel& panel : panels)
        script += "set title '" + std::string{fit::name_of(panel.mode)} +
                  "'\nset ylabel 'nominal stress (kPa)'\nplot " + panel.measured + panel.lines + "\n";
    for (const Panel& panel : panels)
        script += "set title ''\nset ylabel 'residual, law minus test (kPa)'\nplot " + panel.residuals +
                  ", 0 with lines linecolor rgb "
                  "'#808080' notitle\n";
    post::run_gnuplot(script + "unset multiplot\n", file);
}

}  // namespace soft::cli
