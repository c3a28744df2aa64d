#pragma once
/// What the pressure does on the growing cavity is stored in the rubber: the two along a path.
#include "problem.hpp"

namespace soft::verification {

/// The integral of p dV up to each step [J]: between two rows p is the cubic in V that has the solver's slopes dp/dV.
[[nodiscard]] std::vector<double> work_J(const Run& run);

/// The stored energy of the row where it differs most from the work, among those with a hundredth of the final energy
/// and more. The run must have recorded its energy.
[[nodiscard]] Row work_row(const Run& run);

}  // namespace soft::verification
