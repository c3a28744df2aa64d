#include "core/program.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <vector>

#include "core/error.hpp"
#include "path_variable.hpp"

namespace soft::core {
namespace {

using Arguments = std::vector<std::string>;

TEST(Program, PassesInputAndArgumentsAndCapturesOutput) {
    std::FILE* out = std::tmpfile();
    ASSERT_NE(out, nullptr);
    const Arguments arguments{"-c", "printf '%s|' \"$1\"; cat", "sh", "a b'c"};
    const ProgramStatus end = run_program(
        {.name = "sh", .arguments = arguments, .input = "text", .output = ::fileno(out), .purpose = {}, .remedy = {}},
        "x");
    EXPECT_TRUE(end.succeeded);
    std::rewind(out);
    char buffer[64] = {};
    const std::size_t size = std::fread(buffer, 1, sizeof buffer, out);
    std::fclose(out);
    EXPECT_EQ(std::string(buffer, size), "a b'c|text");
}

TEST(Program, LongOutputIsReadCompletely) {
    const Arguments arguments{"-c", "cat; head -c 1000000 /dev/zero"};  // far more than the capacity of a pipe
    const ProgramOutput output = capture_program_output(
        {.name = "sh", .arguments = arguments, .input = "text", .purpose = {}, .remedy = {}}, "x");
    EXPECT_TRUE(output.status.succeeded);
    ASSERT_EQ(output.bytes.size(), 1000004U);
    EXPECT_EQ(output.bytes[3], std::byte{'t'});
    EXPECT_EQ(output.bytes.back(), std::byte{0});
}

TEST(Program, DroppedVariablesAreNotPassedOn) {
    const test::Variable dropped{"SOFT_DROPPED_NAME", "1"}, kept{"SOFT_KEPT", "2"};
    const Arguments arguments{"-c", "printf '%s' \"$SOFT_DROPPED_NAME,$SOFT_KEPT\""};
    const std::vector<std::string_view> names{"SOFT_DROPPED"};
    const ProgramOutput output = capture_program_output(
        {.name = "sh", .arguments = arguments, .input = {}, .purpose = {}, .remedy = {}, .dropped_variables = names},
        "x");
    EXPECT_EQ(std::string(reinterpret_cast<const char*>(output.bytes.data()), output.bytes.size()), ",2");
}

TEST(Program, FailureIsReportedWithTheErrorOutput) {
    const Arguments arguments{"-c", "echo too bad >&2; exit 3"};
    const ProgramStatus end =
        run_program({.name = "sh", .arguments = arguments, .input = {}, .purpose = {}, .remedy = {}}, "x");
    EXPECT_FALSE(end.succeeded);
    EXPECT_EQ(end.error_output, "too bad\n");
}

TEST(Program, MissingProgramIsNamedWithTheRemedy) {
    try {
        static_cast<void>(run_program({.name = "no-such-program-xyz",
                                       .arguments = {},
                                       .input = {},
                                       .purpose = "makes films",
                                       .remedy = "install the package p"},
                                      "a.mp4"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::cannot_create);
        EXPECT_STREQ(
            error.what(),
            "a.mp4: the program no-such-program-xyz, which makes films, is not installed; install the package p");
    }
}

}  // namespace
}  // namespace soft::core
