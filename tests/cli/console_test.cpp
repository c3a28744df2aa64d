#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cli.hpp"
#include "process.hpp"

namespace {

using namespace soft;
using namespace soft::process;

std::string stderr_of(cli::Verbosity verbosity, auto&& action) {
    testing::internal::CaptureStderr();  // a file, not a terminal
    {
        cli::Console console{"tool", verbosity};
        action(console);
    }
    return testing::internal::GetCapturedStderr();
}

TEST(Console, QuietPrintsNothingAndVerbosePrintsMore) {
    const auto action = [](cli::Console& console) {
        console.say("said");
        console.detail("detail");
        console.warn("careful");
        console.progress(0.5, "half");
    };
    EXPECT_EQ(stderr_of(cli::Verbosity::quiet, action), "");
    EXPECT_EQ(stderr_of(cli::Verbosity::normal, action), "tool: said\ntool: warning: careful\ntool: 50 % half\n");
    EXPECT_EQ(stderr_of(cli::Verbosity::verbose, action),
              "tool: said\ntool: detail\ntool: warning: careful\ntool: 50 % half\n");
}

TEST(Console, RemovesControlCharactersAndLineBreaks) {
    const std::string wild = "a\nb\033[31m\xff";
    const auto action = [&](cli::Console& console) {
        console.say(wild);
        console.warn(wild);
        console.progress(0.5, wild);
    };
    EXPECT_EQ(stderr_of(cli::Verbosity::normal, action),
              "tool: a?b?[31m?\ntool: warning: a?b?[31m?\ntool: 50 % a?b?[31m?\n");
}

TEST(Console, RemovesControlCharactersFromNamesInErrors) {
    Folder folder;
    ASSERT_EQ(run(folder, "mesh-gen --template tube > tube.yaml").code, 0);
    const std::string name = "n=$(printf 'x\\033[31m\\ny\\377'); ";  // an escape sequence, a line break, invalid UTF-8
    for (const char* command :
         {"mesh-gen \"$n\"", "mesh-gen tube.yaml -o \"$n/a\"", "cp tube.yaml \"$n\"; mesh-gen \"$n\" --set a.b=1",
          "mesh-gen tube.yaml --set \"supports={$n: fixed}\"", "mesh-gen tube.yaml --set \"geometry.$n=1\"",
          "printf 'a: [\\033[31m' > \"$n\"; mesh-gen \"$n\""}) {
        const Outcome outcome = run(folder, name + command);
        EXPECT_NE(outcome.code, 0) << command;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        EXPECT_FALSE(contains(outcome.err, "\033") || contains(outcome.err, "\377")) << outcome.err;
    }
}

TEST(Console, ProgressWithoutATerminalPrintsOneLinePerTenPercent) {
    const std::string text = stderr_of(cli::Verbosity::normal, [](cli::Console& console) {
        for (int i = 0; i <= 1000; ++i) console.progress(i / 1000.0, "steps");
        console.progress(std::nan(""), "odd");
    });
    EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 12) << text;
    EXPECT_FALSE(contains(text, "\r"));
    EXPECT_FALSE(contains(text, "\033"));
}

TEST(Console, UsesColourOnlyOnTerminalsWithoutNoColor) {
    Folder folder;
    ASSERT_EQ(run(folder, "mesh-gen --template tube > tube.yaml").code, 0);
    const std::string command = "mesh-gen tube.yaml --set mesh.size=9mm -o x.h5";  // coarse: one warning
    EXPECT_TRUE(contains(run_on_terminal(folder, 2, command).out, "\033[33mwarning"));
    EXPECT_FALSE(contains(run_on_terminal(folder, 2, "NO_COLOR=1 " + command).out, "\033"));
    const Outcome plain = run(folder, command);
    EXPECT_TRUE(contains(plain.err, "mesh-gen: warning: mesh.size")) << plain.err;
    EXPECT_FALSE(contains(plain.err, "\033"));
}

}  // namespace
