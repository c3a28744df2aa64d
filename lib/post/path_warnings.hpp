#pragma once
/// Warnings about a finished static path: material laws used outside their range, goals that the loads do not reach. One line per
/// warning. Tested by post/path_warnings_test and Pipeline.MisleadingDesignsAreReported.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/case.hpp"
#include "model/path.hpp"

namespace soft::post {

struct PathSummary {
    model::Step first, last;  ///< first and last row of the path
    double max_stretch_p99 = 1;
    model::Step max_stretch_step;  ///< the row with the largest stretch at a point
    bool became_unstable = false;  ///< a row is not stable
    std::span<const model::LimitPoint> limit_points = {};
    std::optional<int> first_crushed_row = {};  ///< with det F below crushed_jacobian at a point
    double min_jacobian = 1;
    bool is_inelastic = false;  ///< the rubber itself dissipates energy
    double largest_work_J = 0;  ///< of the loads up to any row, absolute
};

/// det F below this is not a physical state of nearly incompressible rubber but a local error of the mesh; the shipped designs stay
/// above 0.75.
inline constexpr double crushed_jacobian = 0.5;

/// Whether det F is below crushed_jacobian at a few points only. In a homogeneous state the loads prescribe the compression.
[[nodiscard]] bool is_crushed_at_a_point(const model::Step& row);

/// Warnings for
/// stretch    a principal stretch, exceeded in 1 % of the rubber, beyond the first tensile stability limit of the law (Drucker,
///            material/stability.hpp; the mode with the lowest limit), or beyond the range of small strains. If the path is unstable or
///            ended early, also if less of the rubber is beyond that limit: a softening rubber localizes its strain in a few
///            cells and unloads around them
/// goals      path.until has values that are not reached at full load
/// crushed    det F far below 1 at a point of nearly incompressible rubber: next to a fixed edge or a sharp corner a mesh can be
///            compressed without limit and become unstable, which is a mesh artefact
/// snaps      energy that snaps have set free, 1 % of the largest work of the loads or more
/// maximum    the pressure has passed a maximum below the requested pressure and the path ended early after it: inverted
///            cells, contact or divergence there are consequences, not the cause
/// No warnings for a motion in time.
[[nodiscard]] std::vector<std::string> path_warnings(const model::Case& solved, const PathSummary& reached,
                                                     model::StopReason end);

}  // namespace soft::post
