#pragma once
/// Plot of fits: data as points and laws as lines on top, residuals below, one column per mode.
/// Tested by tests/pipeline/fit.sh.
#include <filesystem>
#include <vector>

#include "fit/rank.hpp"

namespace soft::cli {

/// Draws the first three of `ranked`. Errors as post::draw_plot.
void draw_fits(const std::vector<fit::RankedFit>& ranked, const std::vector<fit::TestCurve>& tests,
               const std::filesystem::path& file);

}  // namespace soft::cli
