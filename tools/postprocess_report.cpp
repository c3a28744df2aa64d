#include "postprocess_report.hpp"

#include "view/report.hpp"

namespace soft {

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
