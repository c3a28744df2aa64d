#pragma once
/// Kinks of the path. Where a fibre becomes slack or taut, or a point in contact slides over an edge, the tangent K jumps, and with it the
/// direction of the path: it may turn by more than a right angle, and the load may reverse; then no step along the direction before the
/// kink converges.
/// Beyond the kink the path belongs to another smooth piece of the law, with the direction +-K^-1 f and the K of the far side. The
/// sign is the one that leads away from the kink and stays in that piece (paths of piecewise linear maps: Allgower and Georg,
/// Introduction to Numerical Continuation Methods (2003) 12). Internal to the module. Tested by solver/kink_test.
#include "solver/corrector.hpp"

namespace soft::solver {

/// At rest all fibres are at the point of becoming taut, and K is that of the matrix material alone, with the direction `slack`. The
/// direction of the path is that of the piece into which it leads.
[[nodiscard]] PathTangent leave_rest(Corrector& corrector, const State& rest, PathTangent slack);

/// A point beyond the kink that lies within the failed step, under arc-length control; its tangent points in the direction of travel.
/// nullopt where none is found; the memory of the corrector is then unchanged.
[[nodiscard]] std::optional<PathPoint> pass_kink(Corrector& corrector, const PathState& path, double failed_step);

}  // namespace soft::solver
