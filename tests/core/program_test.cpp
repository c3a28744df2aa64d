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

TEST(Program, InputAndArgumentsGoInAndOutputComesOut) {
    std::FILE* out = std::tmpfile();
    ASSERT_NE(out, nullptr);
    const Arguments arguments{"-c", "printf '%s|' \"$1\"; cat", "sh", "a b'c"};
    const ProgramEnd end = run_program(
        {.name = "sh", .arguments = arguments, .input = "text", .output = ::fileno(out), .purpose = {}, .remedy = {}},
        "x");
    EXPECT_TRUE(end.well);
    std::rewind(out);
    char buffer[64] = {};
    const std::size_t size = std::fread(buffer, 1, sizeof buffer, out);
    std::fclose(out);
    EXPECT_EQ(std::string(buffer, size), "a b'c|text");
}

TEST(Program, OutputOfAnyLengthIsReadWhole) {
    const Arguments arguments{"-c", "cat; head -c 1000000 /dev/zero"};  // far more than a pipe holds
    const ProgramOutput output =
        program_output({.name = "sh", .arguments = arguments, .input = "text", .purpose = {}, .remedy = {}}, "x");
    EXPECT_TRUE(output.end.well);
    ASSERT_EQ(output.bytes.size(), 1000004U);
    EXPECT_EQ(output.bytes[3], std::byte{'t'});
    EXPECT_EQ(output.bytes.back(), std::byte{0});
}

TEST(Program, VariablesThatAreDroppedAreNotSeen) {
    const test::Variable dropped{"SOFT_DROPPED_NAME", "1"}, kept{"SOFT_KEPT", "2"};
    const Arguments arguments{"-c", "printf '%s' \"$SOFT_DROPPED_NAME,$SOFT_KEPT\""};
    const std::vector<std::string_view> names{"SOFT_DROPPED"};
    const ProgramOutput output = program_output(
        {.name = "sh", .arguments = arguments, .input = {}, .purpose = {}, .remedy = {}, .dropped_variables = names},
        "x");
    EXPECT_EQ(std::string(reinterpret_cast<const char*>(output.bytes.data()), output.bytes.size()), ",2");
}

TEST(Program, AFailureIsReportedWithWhatItSaid) {
    const Arguments arguments{"-c", "echo too bad >&2; exit 3"};
    const ProgramEnd end =
        run_program({.name = "sh", .arguments = arguments, .input = {}, .purpose = {}, .remedy = {}}, "x");
    EXPECT_FALSE(end.well);
    EXPECT_EQ(end.complaint, "too bad\n");
}

TEST(Program, OneThatIsNotInstalledIsNamedWithTheRemedy) {
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
