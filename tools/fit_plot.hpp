#pragma once
/// Picture of fits: data as points and laws as lines above, residuals below, one panel a mode.
/// Tested by tests/pipeline/fit.sh.
#include <filesystem>
#include <vector>

#include "fit/rank.hpp"

namespace soft::cli {

/// The first three of `ranked` are drawn. Errors as post::draw_plot.
void draw_fits(const std::vector<fit::Ranked>& ranked, const std::vector<fit::TestCurve>& tests,
               const std::filesystem::path& file);

}  // namespace soft::cli
