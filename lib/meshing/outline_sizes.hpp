#pragma once
/// Requested cell lengths of an unstructured mesh of an outline: `size_m`, but shorter where a wall is thin, where an edge bends or
/// is short, toward re-entrant corners and at the ends of fixed faces. From each such position the length grows at the same rate,
/// so that neighbours differ little. Tested by meshing/outline_mesher_test.
#include <string>
#include <vector>

#include "meshing/outline.hpp"

namespace soft::meshing {

/// Growth of the cell length with the distance from a position where cells must be short. With 1/3, neighbours differ by about a
/// third; smaller rates refine far around each corner and cost cells without gain.
inline constexpr double size_growth = 1.0 / 3;

struct SizeRequest {
    double size_m;
    int through_wall;                ///< minimum number of cells through every wall
    double grading;                  ///< size_m relative to the cells at corners; 1: no refinement
    std::vector<std::string> fixed;  ///< fixed faces; the strain at their ends is singular as in a re-entrant corner
};

/// A position at which cells must be short.
struct SizeSeed {
    PlanePoint position;
    double size_m;
};
/// `size_m`, but shorter around the seeds.
[[nodiscard]] std::function<double(PlanePoint)> shorter_at(std::function<double(PlanePoint)> size_m,
                                                           std::vector<SizeSeed> seeds);

[[nodiscard]] std::function<double(PlanePoint)> cell_sizes(const Outline& outline, const SizeRequest& request);

/// Estimated number of cells.
[[nodiscard]] double expected_cells(const Outline& outline);

}  // namespace soft::meshing
