#pragma once
/// Assigns the rows of a table to positions on a path. Tested by post/golden_test.
#include <limits>
#include <span>
#include <vector>

#include "post/interpolate.hpp"

namespace soft::post {

/// A quantity of the table: the column of the curve and the value in each row.
struct Track {
    std::size_t column = 0;
    std::span<const double> values;
    double largest = std::numeric_limits<double>::infinity();  ///< its squared distance counts at most as this
};

/// Index of the track with the fewest reversals (ideally a monotonic one); the first of equals. `tracks` must not be empty.
[[nodiscard]] std::size_t leading_track(std::span<const Track> tracks);

/// Path parameter of each row, at a crossing of the leading track with its value; where that hardly changes from row to row, as where a
/// stage holds it, of any track. Among several crossings the choice minimises the sum of squared distances in the tracks, each divided by
/// its range, without moving backwards along the path. NaN for a row whose value the path does not cross. `targets`: the values to cross,
/// by track; none for the last tracks, which only decide between crossings.
[[nodiscard]] std::vector<double> align(const Path& path, std::span<const Track> tracks, std::size_t leader,
                                        std::span<const std::vector<double>> targets);

}  // namespace soft::post
