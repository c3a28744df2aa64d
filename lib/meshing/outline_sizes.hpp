#pragma once
/// How long the cells of a freely meshed outline should be: `size_m`, but shorter where a wall is thin, where an edge bends
/// or is short, toward re-entrant corners and where a held face ends. From each such place the length grows at the same
/// rate, so that neighbours differ little. Tested by meshing/outline_mesher_test.
#include <string>
#include <vector>

#include "meshing/outline.hpp"

namespace soft::meshing {

/// Growth of the length of cells with the distance from a place where they must be short. A third gives neighbours that
/// differ by about so much; smaller rates refine far around each corner and cost cells without gain.
inline constexpr double size_growth = 1.0 / 3;

struct SizeWishes {
    double size_m;
    int through_wall;               ///< at least so many cells through every wall
    double grading;                 ///< size over the cells at corners; 1: not refined there
    std::vector<std::string> held;  ///< faces at whose ends the strain is singular as in a re-entrant corner
};

[[nodiscard]] std::function<double(PlanePoint)> cell_sizes(const Outline& outline, const SizeWishes& wishes);

/// About how many cells there will be.
[[nodiscard]] double expected_cells(const Outline& outline);

}  // namespace soft::meshing
