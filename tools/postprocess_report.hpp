#pragma once
/// --report: the page about a result. Held by tests/report.
#include <optional>
#include <span>

#include "io/result_file.hpp"
#include "post/plot.hpp"
#include "postprocess_checks.hpp"
#include "postprocess_options.hpp"

namespace soft {

/// Without --report nothing.
void write_report(const PostprocessOptions& options, const io::Result& result, const post::Curve& curve,
                  std::span<const post::PlotSeries> series, const std::optional<Comparison>& comparison);

}  // namespace soft
