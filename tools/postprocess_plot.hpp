#pragma once
/// --plot and --report: the curves of the result and of other results, measured points, and the HTML report. Tested by
/// tests/pipeline (checks.sh, reports.sh).
#include "io/result_file.hpp"
#include "post/curve.hpp"
#include "post/measured.hpp"
#include "post/plot.hpp"
#include "postprocess_checks.hpp"
#include "postprocess_options.hpp"
#include "view/report.hpp"

namespace soft {

/// Series for draw_plot and the report: `curve` of `result` first, then those of --with.
[[nodiscard]] std::vector<post::PlotSeries> plot_series(const PlotOptions& options, const io::Result& result,
                                                        const post::Curve& curve);

/// Does nothing without --plot. `measured` may be nullptr.
void draw_plot(const PlotOptions& options, std::span<const post::PlotSeries> series, const post::Measured* measured,
               const std::string& title);

/// Does nothing without --report. Adds the comparison and the plot settings to `content`.
void write_report(const PostprocessOptions& options, view::Content content,
                  const std::optional<Comparison>& comparison);

}  // namespace soft
