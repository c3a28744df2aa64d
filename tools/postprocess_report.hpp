#pragma once
/// --report: the page about a result. Tested by tests/report.
#include <optional>

#include "postprocess_checks.hpp"
#include "postprocess_options.hpp"
#include "report/report.hpp"

namespace soft {

/// Without --report nothing. The content lacks the comparison and what stands in the options.
void write_report(const PostprocessOptions& options, report::Content content,
                  const std::optional<Comparison>& comparison);

}  // namespace soft
