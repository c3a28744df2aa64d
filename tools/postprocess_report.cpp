#include "postprocess_report.hpp"

#include "report/report.hpp"

namespace soft {

void write_report(const PostprocessOptions& options, const io::Result& result, const post::Curve& curve,
                  std::span<const post::PlotSeries> series, const std::optional<Comparison>& comparison) {
    if (options.report.empty()) return;
    report::Content content{.result = result, .curve = curve, .series = series};
    if (comparison) {
        content.measured = &comparison->measured;
        content.errors = comparison->errors;
    }
    content.plot = {series.size() == 1 ? result.model.name : "", options.plot.x, options.plot.y};
    content.made_by = "postprocess " + std::string{cli::version()} + " (" + std::string{cli::revision()} +
                      "): " + options.common.command_line;
    cli::write_output(options.report, report::make_report(content));
}

}  // namespace soft
