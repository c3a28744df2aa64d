#pragma once
/// Load levels: the factors that multiply a case's loads. One entry per load, in the order of the case.
/// Tested by fem/system_test.
#include <vector>

#include "model/case.hpp"

namespace soft::fem {

struct LoadLevels {
    std::vector<double> pressures_Pa;         ///< gauge
    std::vector<double> dead_loads, motions;  ///< 1: as the case states them
    double time_s = 0;                        ///< since the start of a path in time; else 0
};

[[nodiscard]] LoadLevels no_loads(const model::Case& input);

/// Sum over all loads of a x b: the directional derivative from a derivative with respect to the levels (at a fixed time).
[[nodiscard]] double product(const LoadLevels& a, const LoadLevels& b);

/// levels + share x direction
[[nodiscard]] LoadLevels moved(const LoadLevels& levels, double share, const LoadLevels& direction);

}  // namespace soft::fem
