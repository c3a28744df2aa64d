#pragma once
/// What can be said against a static path only when it has been followed: laws used beyond where they hold, goals
/// that the loads do not reach. Plain warnings, one line each. Tested by fields/reached_test and
/// Pipeline.MisleadingDesignsAreNamed.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/case.hpp"
#include "solution/path.hpp"

namespace soft::fields {

struct Reached {
    solution::Step first, last;  ///< rows of the path
    double max_stretch_p99 = 1;
    solution::Step most_stretched;  ///< the row with the largest stretch at a point
    bool gave_way = false;          ///< a row is not stable
    std::span<const solution::LimitPoint> limit_points = {};
    std::optional<int> first_crushed_row = {};  ///< with det F below crushed_jacobian at a point
    double min_jacobian = 1;
};

/// Of rubber that keeps its volume no state, but what a mesh cannot resolve: shipped designs stay above 0.75.
inline constexpr double crushed_jacobian = 0.5;

/// Whether the row's least det F is that of a few points: of a state that is the same everywhere it is what the loads ask for.
[[nodiscard]] bool is_crushed_at_a_point(const solution::Step& row);

/// stretch    a principal stretch, exceeded in 1 % of the rubber, beyond the law's first limit in tension (Drucker's stability,
///            material/stability.hpp: in whichever mode it comes first), or beyond what small strains are; of a body that has
///            given way or whose path has ended early also where less of the rubber is beyond that limit: a rubber that
///            softens gathers its strain in a few cells, and unloads around them
/// goals      path.until names values that the path, which ends at its full load, does not come to
/// crushed    det F far below 1 at a point of rubber that hardly changes its volume: beside a held edge or a sharp corner a mesh
///            presses it together without end, and gives way there for itself
/// maximum    the load has passed a maximum below the pressure asked for, and the path has ended early behind it: inverted
///            cells, contact or divergence there are not what is wrong
/// None for a motion in time.
[[nodiscard]] std::vector<std::string> warnings_at(const model::Case& solved, const Reached& reached,
                                                   solution::StopReason end);

}  // namespace soft::fields
