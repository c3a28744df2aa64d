#pragma once
/// Reflected Gray code: an order of all combinations of digits in which consecutive ones differ in one digit by 1.
/// Source: Knuth, The Art of Computer Programming 4A (2011), 7.2.1.1. Tested by sweep/gray_code_test.
#include <cstddef>
#include <vector>

namespace soft::sweep {

struct GrayCode {
    int digits;
    int base;  ///< digits are 0 ... base - 1

    [[nodiscard]] double size() const noexcept;  ///< base^digits
    /// The digits of the k-th combination; the first digit changes fastest. All digits are 0 for k = 0.
    [[nodiscard]] std::vector<int> at(std::size_t k) const;
};

}  // namespace soft::sweep
