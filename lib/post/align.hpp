#pragma once
/// Places on a path for the rows of a table that follows it. Tested by post/golden_test.
#include <span>
#include <vector>

#include "post/interpolate.hpp"

namespace soft::post {

/// A quantity of the table: column of the curve and its value in each row.
struct Track {
    std::size_t column = 0;
    std::span<const double> values;
};

/// The track among `tracks` that goes one way, else the one that turns back least; the first of equals. Not for no tracks.
[[nodiscard]] std::size_t leading_track(std::span<const Track> tracks);

/// Path parameter of each row: where the leading track crosses its value (`targets`), by the least sum of squared distances
/// in the other tracks, each over its range, without going back. nan for a row whose target the path does not cross.
[[nodiscard]] std::vector<double> align(const Path& path, std::span<const Track> tracks, std::size_t leader,
                                        std::span<const double> targets);

}  // namespace soft::post
