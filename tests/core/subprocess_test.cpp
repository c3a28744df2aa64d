/// Work in a child process: its result, and each kind of failure.
#include "core/subprocess.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <string>
#include <vector>

namespace soft::core {
namespace {

using std::chrono::seconds;

Bytes bytes_of(std::string_view text) {
    const auto bytes = std::as_bytes(std::span{text});
    return {bytes.begin(), bytes.end()};
}

TEST(Subprocess, ResultIsReturnedCompletely) {
    const Bytes large(std::size_t{1} << 20, std::byte{7});  // more than the capacity of a pipe
    const SubprocessOutcome end = run_in_subprocess([&] { return large; }, {.wall = seconds{60}});
    ASSERT_TRUE(end.result.has_value()) << end.reason;
    EXPECT_EQ(*end.result, large);
}

TEST(Subprocess, ChangesStayInTheChild) {
    int here = 1;
    const SubprocessOutcome end = run_in_subprocess(
        [&] {
            here = 2;
            return bytes_of(std::to_string(here));
        },
        {.wall = seconds{60}});
    EXPECT_EQ(end.result, bytes_of("2"));
    EXPECT_EQ(here, 1);
}

TEST(Subprocess, ExceptionIsAFailure) {
    const SubprocessOutcome end = run_in_subprocess([]() -> Bytes { throw "a text"; }, {.wall = seconds{60}});
    EXPECT_FALSE(end.result.has_value());
    EXPECT_EQ(end.reason, "it fails");
}

TEST(Subprocess, CrashIsReportedWithItsSignal) {
    const SubprocessOutcome end = run_in_subprocess(
        []() -> Bytes {
            ::raise(SIGSEGV);
            return {};
        },
        {.wall = seconds{60}});
    EXPECT_FALSE(end.result.has_value());
    EXPECT_EQ(end.reason, "it crashes (Segmentation fault)");
}

TEST(Subprocess, SleepingChildIsKilledAtTheWallClockLimit) {
    const SubprocessOutcome end = run_in_subprocess(
        []() -> Bytes {
            for (;;) ::pause();
        },
        {.wall = seconds{1}});
    EXPECT_FALSE(end.result.has_value());
    EXPECT_EQ(end.reason, "it exceeds the time limit");
}

TEST(Subprocess, LoopingChildIsKilledAtTheCpuTimeLimit) {
    const auto start = std::chrono::steady_clock::now();
    const SubprocessOutcome end = run_in_subprocess(
        []() -> Bytes {
            for (std::atomic<int> i = 0;; ++i) {}
        },
        {.wall = seconds{600}, .processor = seconds{1}});
    EXPECT_FALSE(end.result.has_value());
    EXPECT_EQ(end.reason, "it exceeds the time limit");
    EXPECT_LT(std::chrono::steady_clock::now() - start, seconds{300});
}

/// The reason is not compared: the allocators of the sanitizers use memory that they have reserved before the limit is set.
TEST(Subprocess, AllocationBeyondTheMemoryLimitFails) {
    constexpr std::size_t limit = std::size_t{64} << 20;
    const auto asks_for = [](std::size_t size) {
        return [size]() -> Bytes {
            const std::vector<char> taken(size, 'x');
            return {std::byte{static_cast<unsigned char>(taken[size / 2])}};
        };
    };
    EXPECT_TRUE(run_in_subprocess(asks_for(limit / 4), {.wall = seconds{60}, .memory = limit}).result.has_value());
    const SubprocessOutcome end = run_in_subprocess(asks_for(4 * limit), {.wall = seconds{60}, .memory = limit});
    EXPECT_FALSE(end.result.has_value());
    EXPECT_NE(end.reason, "");
}

TEST(Subprocess, OutputIsDiscarded) {
    ::testing::internal::CaptureStderr();
    static_cast<void>(run_in_subprocess(
        [] {
            std::fputs("noise\n", stderr);
            return Bytes{};
        },
        {.wall = seconds{60}}));
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace soft::core
