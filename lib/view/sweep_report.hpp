#pragma once
/// `scripts/sweep --report`: the results of a sweep as one self-contained HTML page: a scatter plot with the Pareto front of two outputs,
/// parallel coordinates, the curves and a table of the selected designs, and the designs that failed with their reason. The page fetches
/// nothing, and no text of a design is executed (view/page.hpp).
/// The same results give the same bytes. Tested by view/sweep_report_test and tests/view/sweep_browser.sh (headless Chromium).
#include <span>
#include <string>
#include <vector>

#include "sweep/table.hpp"

namespace soft::view {

struct SweepContent {
    std::string title;
    std::span<const std::string> ids;  ///< of the designs
    std::span<const sweep::TableColumn> factors, outputs;
    std::span<const sweep::Outcome> outcomes;  ///< with traces
    std::string sweep_text = {};               ///< the sweep file
    std::string made_by = {};                  ///< program and version
};

/// Points of each curve, so that the curves of a sweep with this number of designs have about 24 MB in the page; 40, fewer for more than
/// 10000 designs, at least 8.
[[nodiscard]] std::size_t trace_points(std::size_t designs);

/// Returns the page.
[[nodiscard]] std::string make_sweep_report(const SweepContent& content);

}  // namespace soft::view
