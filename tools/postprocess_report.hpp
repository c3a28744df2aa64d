#pragma once
/// --report: the HTML report of a result. Tested by tests/report.
#include <optional>

#include "postprocess_checks.hpp"
#include "postprocess_options.hpp"
#include "view/report.hpp"

namespace soft {

/// Does nothing without --report. Adds the comparison and the plot settings to `content`.
void write_report(const PostprocessOptions& options, view::Content content,
                  const std::optional<Comparison>& comparison);

}  // namespace soft
