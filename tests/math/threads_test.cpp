#include "math/threads.hpp"

#include <gtest/gtest.h>
#include <omp.h>
#include <sys/resource.h>

#include <cstdlib>
#include <fstream>

namespace soft {
namespace {

TEST(ThreadCount, IsTheStatedNumberOrThatOfOpenMp) {
    EXPECT_EQ(thread_count(1), 1);
    EXPECT_EQ(thread_count(3), 3);
    EXPECT_EQ(thread_count(0), omp_get_max_threads());
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
