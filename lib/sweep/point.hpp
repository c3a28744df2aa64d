#pragma once
/// A point of `at` on a curve. Internal; tested by sweep/outcome_test.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/path.hpp"
#include "post/curve.hpp"
#include "post/request.hpp"
#include "sweep/sweep.hpp"

namespace soft::sweep {

/// Whether the column is an output of the sweep: listed, or any except the step number if the sweep lists none.
[[nodiscard]] bool is_requested(const Sweep& sweep, const post::Column& column);

/// Whether the point is `end` or `limit`.
[[nodiscard]] bool is_named_point(const SourceText& point);

/// Throws Error(bad_input), with the location in the sweep file, for a quantity or a value that the curve cannot have.
[[nodiscard]] std::vector<post::Request> requests_of(const SourceText& point, const post::Curve& curve);

struct PointRow {
    std::optional<std::vector<double>> values;  ///< all columns, in the order of the curve
    std::string missing;                        ///< the reason if there are no values
};
/// The first row at the point. Errors as requests_of.
[[nodiscard]] PointRow row_at(const SourceText& point, const post::Curve& curve,
                              std::span<const model::LimitPoint> limit_points);

/// "pressure at elongation=40mm" or "pressure by geometry.wall at elongation=40mm", for axes.
[[nodiscard]] std::string label_at(const std::string& quantity, const std::string& point, const std::string& by = "");

}  // namespace soft::sweep
