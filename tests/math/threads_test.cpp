#include "math/threads.hpp"

#include <gtest/gtest.h>
#include <omp.h>
#include <sys/resource.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <vector>

namespace soft {
namespace {

TEST(ThreadCount, IsTheStatedNumberOrThatOfOpenMp) {
    EXPECT_EQ(thread_count(1), 1);
    EXPECT_EQ(thread_count(3), 3);
    EXPECT_EQ(thread_count(0), omp_get_max_threads());
}

TEST(ForRanges, DividesAllNumbersAmongTheThreads) {
    for (const std::size_t count : {0, 1, 2, 7, 100})
        for (const int threads : {1, 2, 3, 8}) {
            std::vector<int> visits(count, 0);
            for_ranges(count, threads, [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) ++visits[i];
            });
            EXPECT_EQ(visits, std::vector<int>(count, 1)) << count << ' ' << threads;
        }
}

TEST(ForRanges, RethrowsAnException) {
    const auto fail_at_seven = [](std::size_t begin, std::size_t end) {
        if (begin <= 7 && 7 < end) throw std::runtime_error("seven");
    };
    for (const int threads : {1, 3}) {
        EXPECT_THROW(for_ranges(10, threads, fail_at_seven), std::runtime_error);
        EXPECT_NO_THROW(for_ranges(7, threads, fail_at_seven));
    }
}

#ifndef SOFT_SANITIZED  // reserves terabytes of address space
TEST(ThreadCount, IsNoLargerThanTheSystemAllows) {
    const auto count_with_little_memory = [] {
        long pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        const auto bytes = static_cast<rlim_t>(pages) * 4096 + (rlim_t{100} << 20);
        const rlimit limit{bytes, bytes};
        setrlimit(RLIMIT_AS, &limit);
        std::exit(thread_count(1000) < 1000 ? 0 : 2);  // libgomp would exit with 1
    };
    EXPECT_EXIT(count_with_little_memory(), testing::ExitedWithCode(0), "");
}
#endif

}  // namespace
}  // namespace soft
