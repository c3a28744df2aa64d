#pragma once
/// --plot: the result, those to be drawn beside it, and measured points. Tested by tests/pipeline/checks.sh.
#include "io/result_file.hpp"
#include "post/curve.hpp"
#include "post/measured.hpp"
#include "post/plot.hpp"
#include "postprocess_options.hpp"

namespace soft {

/// What draw_plot and the report draw: `curve` of `result` first, then those of --with.
[[nodiscard]] std::vector<post::PlotSeries> plot_series(const PlotOptions& options, const io::Result& result,
                                                        const post::Curve& curve);

/// Without --plot nothing. `measured` may be nullptr.
void draw_plot(const PlotOptions& options, std::span<const post::PlotSeries> series, const post::Measured* measured,
               const std::string& title);

}  // namespace soft
