#pragma once
/// Reference for locking: the converged section of the paper's bellows, cavity open, kappa/mu = 100.
#include <array>

#include "problem.hpp"

namespace soft::verification {

/// Within 0.05 % of the independent code (the rows 'bellows, open').
[[nodiscard]] Run converged_bellows();

inline constexpr std::array compared_elongations_mm{5.0, 20.0, 40.0, 80.0, 130.0};

}  // namespace soft::verification
