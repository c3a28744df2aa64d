#pragma once
/// The rigid motions of the body as vectors of unknowns: an unconstrained elastic body does not resist them. Smoothed aggregation
/// (linalg: gamg) builds its coarse spaces from them (Vanek, Mandel and Brezina 1996). Fixed components and pressures are
/// omitted, so the vectors are near the null space of K, not in it.
#include "fem/system.hpp"

namespace soft::fem {

/// Orthonormal, the rotations about the centre of the points; a motion that the supports prevent completely is omitted.
/// Tested by fem/near_nullspace_test.
[[nodiscard]] std::vector<linalg::Vector> rigid_motions(const System& system);

/// Gives K, a matrix of the system, the rigid motions as its near-nullspace. K keeps a reference to them.
void attach_rigid_motions(const System& system, Mat K);

}  // namespace soft::fem
