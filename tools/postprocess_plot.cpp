#include "postprocess_plot.hpp"

#include <algorithm>
#include <filesystem>

#include "cli.hpp"
#include "geometry/build.hpp"

namespace soft {
namespace {

/// "FILE" or "FILE:LABEL"; an existing file whose name contains a colon is not split.
post::PlotSeries read_other(const std::string& text) {
    std::string file = text, label;
    const std::size_t colon = text.rfind(':');
    std::error_code unreadable;  // set for an unusable name; reading it then reports the reason
    if (colon != std::string::npos && !std::filesystem::exists(text, unreadable)) {
        file = text.substr(0, colon);
        label = text.substr(colon + 1);
    }
    cli::Input input = cli::read_hdf5_input(file);
    const io::Result other = io::read_result(std::move(input.bytes), input.source, geometry::rebuild_case);
    if (label.empty()) label = other.model.name;
    model::PathEnd end = other.end.value_or(model::PathEnd{});
    return {label, post::make_curve(other.model, other.steps, end), std::move(end)};
}

}  // namespace

std::vector<post::PlotSeries> plot_series(const PlotOptions& options, const io::Result& result,
                                          const post::Curve& curve) {
    std::vector<post::PlotSeries> series = {{result.model.name, curve, result.end.value_or(model::PathEnd{})}};
    for (const std::string& other : options.with) {
        series.push_back(read_other(other));
        const auto same = [&](const post::PlotSeries& one) { return one.label == series.back().label; };
        if (std::count_if(series.begin(), series.end(), same) > 1)  // two runs of one design
            series.back().label += " (" + std::filesystem::path(other).stem().string() + ")";
    }
    return series;
}

void draw_plot(const PlotOptions& options, std::span<const post::PlotSeries> series, const post::Measured* measured,
               const std::string& title) {
    if (options.file.empty()) return;
    post::draw_plot(series, measured, {series.size() == 1 ? title : "", options.x, options.y, options.colour},
                    options.file);
}

void write_report(const PostprocessOptions& options, view::Content content,
                  const std::optional<Comparison>& comparison) {
    if (options.report.empty()) return;
    if (comparison) {
        content.measured = &comparison->measured;
        content.errors = comparison->errors;
    }
    content.plot = {content.series.size() == 1 ? content.result.model.name : "", options.plot.x, options.plot.y,
                    options.plot.colour};
    content.made_by = cli::stamp(postprocess_about(), options.common);
    cli::write_output(options.report, view::make_report(content));
}

}  // namespace soft
