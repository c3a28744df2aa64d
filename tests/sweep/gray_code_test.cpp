#include "sweep/sampling.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

namespace {

using soft::sweep::GrayCode;

TEST(GrayCode, VisitsEachCombinationOnceAndChangesOneDigitByOne) {
    for (const GrayCode code : {GrayCode{1, 2}, GrayCode{1, 5}, GrayCode{2, 3}, GrayCode{3, 4}, GrayCode{4, 2}}) {
        std::set<std::vector<int>> seen;
        std::vector<int> before(static_cast<std::size_t>(code.digits), 0);
        for (std::size_t k = 0; k < static_cast<std::size_t>(code.size()); ++k) {
            const std::vector<int> now = code.at(k);
            int difference = 0;
            for (std::size_t i = 0; i < now.size(); ++i) {
                EXPECT_TRUE(now[i] >= 0 && now[i] < code.base);
                difference += std::abs(now[i] - before[i]);
            }
            EXPECT_EQ(difference, k == 0 ? 0 : 1);
            seen.insert(now);
            before = now;
        }
        EXPECT_EQ(static_cast<double>(seen.size()), code.size());
    }
}

}  // namespace
