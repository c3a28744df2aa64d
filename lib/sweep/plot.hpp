#pragma once
/// Picture of a sweep: the curves of all designs, or one column of results.csv over another. The colour shows a parameter: as viridis for
/// numbers, as the colours of Okabe and Ito (2008) for words and for up to six values. A cross marks a path that ended early.
/// Tested by sweep/plot_test.
#include <span>
#include <string>

#include "post/gnuplot.hpp"
#include "post/plot.hpp"
#include "sweep/table.hpp"

namespace soft::sweep {

/// The gnuplot script. x and y of the request are both columns of the curves (name or label, "elongation_mm" or "elongation"), or both
/// columns of the tables; default: the load over the first output, for motions the first output over time; for a table the first output.
/// The colour is a column of the tables; default: the first factor. Throws Error: usage for unknown or mixed columns, bad_input if no
/// design has a value.
[[nodiscard]] std::string plot_script(std::span<const TableColumn> factors, std::span<const TableColumn> outputs,
                                      std::span<const Outcome> outcomes, const post::PlotRequest& request,
                                      post::PictureFormat format);

}  // namespace soft::sweep
