#include "sweep/gray_code.hpp"

#include <cmath>

namespace soft::sweep {

double GrayCode::size() const noexcept { return std::pow(base, digits); }

std::vector<int> GrayCode::at(std::size_t k) const {
    const auto b = static_cast<std::size_t>(base);
    std::vector<int> code;
    for (int i = 0; i < digits; ++i, k /= b) {
        const int digit = static_cast<int>(k % b);
        const bool is_reflected = k / b % 2 == 1;  // the faster digits decrease in every other block
        code.push_back(is_reflected ? base - 1 - digit : digit);
    }
    return code;
}

}  // namespace soft::sweep
