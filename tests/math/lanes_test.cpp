#include "math/lanes.hpp"

#include <gtest/gtest.h>

#include <array>

namespace soft {
namespace {

TEST(Lanes, LoadAndStoreFourNumbersAtAnyAddress) {
    const std::array<double, 6> from{0, 1.5, -2.5, 3.5, 4.5, 5};
    std::array<double, 6> to{};
    Lanes four;
    load(&from[1], four);
    store(2.0 * four + 1.0, &to[1]);
    EXPECT_EQ(to, (std::array<double, 6>{0, 4, -4, 8, 10, 0}));
}

TEST(Lanes, RowsArePaddedToAMultipleOfTheLaneCount) {
    EXPECT_EQ(padded(1), 4);
    EXPECT_EQ(padded(4), 4);
    EXPECT_EQ(padded(27), 28);
}

}  // namespace
}  // namespace soft
