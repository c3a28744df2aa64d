#pragma once
/// Compares the work of the pressure on the cavity with the energy stored in the rubber along a path.
#include "problem.hpp"

namespace soft::verification {

/// Integral of p dV up to each step [J]. Between two rows p is the cubic in V with the solver's slopes dp/dV.
[[nodiscard]] std::vector<double> work_J(const Run& run);

/// The stored energy of the row with the largest difference from the work, among rows with at least a hundredth of the final energy. The
/// run must have recorded its energy.
[[nodiscard]] Row work_row(const Run& run);

}  // namespace soft::verification
