#pragma once
/// --plot: the curves of the result and of other results, and measured points. Tested by tests/pipeline/checks.sh.
#include "io/result_file.hpp"
#include "post/curve.hpp"
#include "post/measured.hpp"
#include "post/plot.hpp"
#include "postprocess_options.hpp"

namespace soft {

/// Series for draw_plot and the report: `curve` of `result` first, then those of --with.
[[nodiscard]] std::vector<post::PlotSeries> plot_series(const PlotOptions& options, const io::Result& result,
                                                        const post::Curve& curve);

/// Does nothing without --plot. `measured` may be nullptr.
void draw_plot(const PlotOptions& options, std::span<const post::PlotSeries> series, const post::Measured* measured,
               const std::string& title);

}  // namespace soft
