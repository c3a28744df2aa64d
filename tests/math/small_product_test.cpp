#include "math/small_product.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <thread>
#include <vector>

namespace soft {
namespace {

/// Sample entries, followed by the padding that the product reads; the padding is NaN so that any use of it shows.
std::vector<double> numbers(int count, double phase) {
    std::vector<double> values(static_cast<std::size_t>(count + gemm_padding),
                               std::numeric_limits<double>::quiet_NaN());
    for (int i = 0; i < count; ++i) values[static_cast<std::size_t>(i)] = std::sin(1.7 * i + phase);
    return values;
}

struct Shape {
    int depth, rows, columns;
};

/// Compares each entry with a reference in long double.
void expect_product(const Shape& s) {
    const std::vector<double> A = numbers(s.depth * s.rows, 0), B = numbers(s.depth * s.columns, 1);
    const int next = s.columns + 3;
    constexpr double untouched = 7;
    std::vector<double> C(static_cast<std::size_t>(s.rows * next), untouched);
    transposed_product(s.depth, {A.data(), s.rows}, {B.data(), s.columns}, C.data(), next);
    for (int i = 0; i < s.rows; ++i)
        for (int j = 0; j < next; ++j) {
            long double sum = 0;
            for (int d = 0; d < s.depth && j < s.columns; ++d)
                sum += static_cast<long double>(A[static_cast<std::size_t>(d * s.rows + i)]) *
                       B[static_cast<std::size_t>(d * s.columns + j)];
            const double expected = j < s.columns ? static_cast<double>(sum) : untouched;
            EXPECT_NEAR(C[static_cast<std::size_t>(i * next + j)], expected, 1e-15 * s.depth)
                << s.depth << " " << s.rows << " " << s.columns << ": " << i << " " << j;
        }
}

TEST(SmallProduct, MatchesTheReferenceForEveryTileRemainder) {
    for (int rows = 1; rows <= 13; ++rows)
        for (int columns = 1; columns <= 17; ++columns) expect_product({5, rows, columns});
    expect_product({81, 27, 85});
    expect_product({0, 3, 4});
}

TEST(SmallProduct, GivesTheSameResultOnConcurrentThreads) {
    const std::vector<double> A = numbers(81 * 27, 0), B = numbers(81 * 85, 1);
    const auto product = [&] {
        std::vector<double> C(27 * 85);
        transposed_product(81, {A.data(), 27}, {B.data(), 85}, C.data(), 85);
        return C;
    };
    const std::vector<double> alone = product();
    std::vector<int> different(4, 0);
    std::vector<std::thread> threads;
    for (int& count : different)
        threads.emplace_back([&] {
            for (int repeat = 0; repeat < 200; ++repeat) count += product() == alone ? 0 : 1;
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(different, std::vector<int>(4, 0));
}

}  // namespace
}  // namespace soft
