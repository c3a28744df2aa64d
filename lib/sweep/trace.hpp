#pragma once
/// The curve of a design with few points, for plots and reports of a sweep. Tested by sweep/trace_test.
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "post/curve.hpp"

namespace soft::sweep {

struct TraceColumn {
    std::string name, label, unit;  ///< "elongation_mm", "elongation", "mm"
    std::vector<double> values;     ///< one per point
};
using Trace = std::vector<TraceColumn>;

/// The columns of the table except counters and flags, at points of the smooth curve through the rows (post::Path). At most `max_points`
/// of them (at least 2), chosen so that straight lines between them deviate little: both ends, then repeatedly the point that is farthest
/// from its line, with every column divided by its range. A curve without rows has no columns.
[[nodiscard]] Trace make_trace(const post::Curve& curve, std::size_t max_points);

/// Indices of the abscissa and the ordinate: the load over the first output or the volume; for motions the first output over time.
[[nodiscard]] std::array<std::size_t, 2> usual_axes(const Trace& trace);

}  // namespace soft::sweep
