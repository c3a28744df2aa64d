#pragma once
/// Points of the unit cube [0, 1)^d, the same on every machine for the same seed: the standard fixes the numbers of
/// std::mt19937_64, but not what its distributions make of them, so that these are here. Tested by sweep/sampling_test.
#include <cstdint>
#include <vector>

namespace soft::sweep {

using Points = std::vector<std::vector<double>>;  ///< [sample][dimension]

struct SampleSize {
    int samples;
    int dimensions;
};

/// Independent and uniform. The first n points do not depend on how many follow: a larger sample goes on with a smaller one.
[[nodiscard]] Points random_points(SampleSize size, std::uint64_t seed);

/// One point in each of n equal intervals of every dimension, uniform within it, the intervals paired at random.
/// Source: McKay, Beckman, Conover, Technometrics 21 (1979) 239. Points of another n are others.
[[nodiscard]] Points latin_hypercube(SampleSize size, std::uint64_t seed);

}  // namespace soft::sweep
