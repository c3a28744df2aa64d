#pragma once
/// Points in the unit cube [0, 1)^d that are identical on every machine for the same seed. The C++ standard fixes the sequence of
/// std::mt19937_64 but not the algorithms of its distributions, so they are implemented here. Tested by sweep/sampling_test.
#include <cstddef>
#include <cstdint>
#include <vector>

namespace soft::sweep {

using Points = std::vector<std::vector<double>>;  ///< [sample][dimension]

struct SampleSize {
    int samples;
    int dimensions;
};

/// Independent, uniformly distributed points. A larger sample with the same seed begins with the points of a smaller one.
[[nodiscard]] Points random_points(SampleSize size, std::uint64_t seed);

/// Latin hypercube sample: one point in each of n equal intervals of every dimension, uniform within the interval; the intervals are
/// paired at random. A different n gives different points. Source: McKay, Beckman, Conover, Technometrics 21 (1979) 239.
[[nodiscard]] Points latin_hypercube(SampleSize size, std::uint64_t seed);

/// Reflected Gray code: an order of all combinations of digits in which consecutive ones differ in one digit by 1.
/// Source: Knuth, The Art of Computer Programming 4A (2011), 7.2.1.1. Tested by sweep/gray_code_test.
struct GrayCode {
    int digits;
    int base;  ///< digits are 0 ... base - 1

    [[nodiscard]] double size() const noexcept;  ///< base^digits
    /// The digits of the k-th combination; the first digit changes fastest. All digits are 0 for k = 0.
    [[nodiscard]] std::vector<int> at(std::size_t k) const;
};

}  // namespace soft::sweep
