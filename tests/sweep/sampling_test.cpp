#include "sweep/sampling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace {

using namespace soft::sweep;

/// genrand64_real2 of Nishimura and Matsumoto's mt19937-64, seed 1, computed independently from their recurrence in another language.
TEST(RandomPoints, MatchTheReferenceGenerator) {
    const Points points = random_points({2, 2}, 1);
    EXPECT_EQ(points[0][0], 0.13387664401253263);
    EXPECT_EQ(points[0][1], 0.13640703636619722);
    EXPECT_EQ(points[1][0], 0.4512149038445381);
    EXPECT_EQ(points[1][1], 0.02102422841672702);
}

TEST(RandomPoints, LargerSampleBeginsWithASmallerOne) {
    const Points few = random_points({10, 3}, 7), many = random_points({1000, 3}, 7);
    EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
    EXPECT_NE(random_points({10, 3}, 8), few);
}

TEST(RandomPoints, FillTheUnitCubeEvenly) {
    constexpr int samples = 20000;
    double sum = 0, squares = 0, products = 0;
    for (const auto& point : random_points({samples, 2}, 3)) {
        ASSERT_TRUE(point[0] >= 0 && point[0] < 1 && point[1] >= 0 && point[1] < 1);
        sum += point[0] - 0.5, squares += std::pow(point[0] - 0.5, 2), products += (point[0] - 0.5) * (point[1] - 0.5);
    }
    const double deviation = 1 / std::sqrt(12.0 * samples);  // standard deviation of the mean of `samples` values
    EXPECT_LT(std::abs(sum / samples), 4 * deviation);
    EXPECT_NEAR(squares / samples, 1.0 / 12, 0.002);
    EXPECT_LT(std::abs(products / samples), 4 / (12 * std::sqrt(samples)));
}

TEST(LatinHypercube, HasOnePointInEachIntervalOfEveryDimension) {
    for (const int samples : {1, 2, 7, 100}) {
        const Points points = latin_hypercube({samples, 4}, 1);
        for (std::size_t d = 0; d < 4; ++d) {
            std::vector<int> counts(static_cast<std::size_t>(samples));
            for (const auto& point : points) ++counts.at(static_cast<std::size_t>(point[d] * samples));
            EXPECT_EQ(std::ranges::count(counts, 1), samples);
        }
    }
}

/// Over all seeds, the first point of three is in each pair of intervals equally often: intervals are not tied to rows.
TEST(LatinHypercube, PairsTheIntervalsAtRandom) {
    constexpr int seeds = 3000;
    std::array<int, 9> counts{};
    for (int seed = 0; seed < seeds; ++seed) {
        const auto first = latin_hypercube({3, 2}, static_cast<std::uint64_t>(seed)).front();
        ++counts.at(static_cast<std::size_t>(first[0] * 3) * 3 + static_cast<std::size_t>(first[1] * 3));
    }
    for (const int count : counts) EXPECT_NEAR(count, seeds / 9.0, 5 * std::sqrt(seeds / 9.0));
}

TEST(LatinHypercube, IsTheSameForTheSameSeed) {
    EXPECT_EQ(latin_hypercube({50, 3}, 11), latin_hypercube({50, 3}, 11));
    EXPECT_NE(latin_hypercube({50, 3}, 11), latin_hypercube({50, 3}, 12));
}

}  // namespace
