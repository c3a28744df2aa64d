#include <gtest/gtest.h>

#include <algorithm>
#include <new>

#include "cli.hpp"
#include "process.hpp"

namespace {

using namespace soft;
using namespace soft::process;

/// Expects this exit code, one line on stderr that starts with "mesh-gen: ", and nothing on stdout.
void expect_refusal(const Folder& folder, const std::string& command, int code, const std::string& part) {
    const Outcome outcome = run(folder, command);
    EXPECT_EQ(outcome.code, code) << command << "\n" << outcome.err;
    EXPECT_EQ(outcome.out, "") << command;
    EXPECT_EQ(outcome.err.find("mesh-gen: "), 0u) << command << "\n" << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << command << "\n" << outcome.err;
    EXPECT_TRUE(contains(outcome.err, part)) << command << "\n" << outcome.err;
}

class ExitCodes : public testing::Test {
protected:
    void SetUp() override { ASSERT_EQ(run(folder_, "mesh-gen --template tube > tube.yaml").code, 0); }
    [[nodiscard]] std::ptrdiff_t entries() const {
        return std::distance(fs::directory_iterator{folder_.path()}, fs::directory_iterator{});
    }
    Folder folder_;
};

TEST_F(ExitCodes, UsageIs64) {
    expect_refusal(folder_, "mesh-gen --chek tube.yaml", 64, "did you mean '--check'?");
    expect_refusal(folder_, "mesh-gen tube.yaml more.yaml", 64, "one argument too many: 'more.yaml'");
    expect_refusal(folder_, "mesh-gen tube.yaml a/tube.yaml --output-folder f", 64,
                   "two designs would write 'f/tube.h5'");
    expect_refusal(folder_, "mesh-gen --output-folder f < tube.yaml", 64, "a design from stdin has no name");
    expect_refusal(folder_, "mesh-gen tube.yaml --output-folder f -o a.h5", 64, "exclude each other");
    expect_refusal(folder_, "mesh-gen --list --explain", 64, "exclude each other");
    expect_refusal(folder_, "mesh-gen --template tub", 64, "tub not in {");
    expect_refusal(folder_, "mesh-gen -o", 64, "");
    expect_refusal(folder_, "mesh-gen --set wall tube.yaml", 64, "no '='");
    expect_refusal(folder_, "mesh-gen --json - tube.yaml", 64, "cannot both go to stdout");
    expect_refusal(folder_, "mesh-gen --quiet --verbose tube.yaml", 64, "exclude each other");
}

TEST_F(ExitCodes, InvalidInputIs65) {
    expect_refusal(folder_, "sed 's/cap: auto/cap: 5/' tube.yaml | mesh-gen", 65, "<stdin>:");
    expect_refusal(folder_, "sed 's/cap: auto/cpa: 5/' tube.yaml > x.yaml; mesh-gen x.yaml", 65,
                   "geometry.cpa: unknown key; did you mean 'cap'?");
    expect_refusal(folder_, "mesh-gen < /dev/null", 65, "the design is empty");
    expect_refusal(folder_, "head -c 3000 /dev/urandom | mesh-gen", 65, "<stdin>:");
    expect_refusal(folder_, "yes | mesh-gen", 65, "");  // an endless design
    expect_refusal(folder_, "mesh-gen --set geometry.cap=80mm tube.yaml -o x.h5", 65,
                   "--set geometry.cap: 80 mm is not smaller than");
    EXPECT_FALSE(fs::exists(folder_ / "x.h5"));
}

TEST_F(ExitCodes, AnInputThatCannotBeOpenedIs66) {
    expect_refusal(folder_, "mesh-gen absent.yaml", 66, "absent.yaml: cannot be opened: No such file");
    expect_refusal(folder_, "mesh-gen .", 66, "is a folder");
}

TEST_F(ExitCodes, AnOutputThatCannotBeCreatedIs73) {
    expect_refusal(folder_, "mesh-gen tube.yaml -o no/such/folder.h5", 73, "no/such/folder.h5: cannot be created");
    expect_refusal(folder_, "mesh-gen tube.yaml -o .", 73, "is a folder");
}

TEST_F(ExitCodes, AFullDiskIs74AndLeavesNothing) {
    expect_refusal(folder_, "mesh-gen tube.yaml > /dev/full", 74, "No space left");
    // A file size limit causes the same write error as a full disk, without a mount.
    const auto before = entries();
    expect_refusal(folder_, "ulimit -f 8; mesh-gen tube.yaml -o x.h5", 74, "x.h5: cannot be written");
    EXPECT_EQ(entries(), before);
}

TEST_F(ExitCodes, AClosedStreamIsAnErrorAndItsDescriptorIsNotReused) {
    expect_refusal(folder_, "mesh-gen tube.yaml >&-", 74, "<stdout>");
    expect_refusal(folder_, "mesh-gen - <&-", 74, "<stdin>");
    EXPECT_EQ(run(folder_, "mesh-gen tube.yaml -o x.h5 2>&-").code, 0);
    EXPECT_EQ(slurp(folder_ / "x.h5").substr(1, 3), "HDF");  // messages did not go into the file
}

TEST_F(ExitCodes, AClosedPipeEndsTheWriterWithoutAnError) {
    const Outcome outcome = run(folder_, "mesh-gen --quiet tube.yaml | head -c 5 > /dev/null; exit ${PIPESTATUS[0]}");
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "");
}

TEST_F(ExitCodes, BinaryDataAreNotWrittenToATerminal) {
    const Outcome outcome = run_on_terminal(folder_, 1, "mesh-gen tube.yaml");
    EXPECT_EQ(outcome.code, 64);
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(contains(outcome.err, "use -o FILE")) << outcome.err;
}

TEST_F(ExitCodes, ATerminalIsNotAcceptedAsInput) {
    const Outcome outcome = run_on_terminal(folder_, 0, "mesh-gen -o x.h5");
    EXPECT_EQ(outcome.code, 64);
    EXPECT_TRUE(contains(outcome.err, "stdin is a terminal; give a file")) << outcome.err;
}

TEST(Guarded, MapsEveryExceptionToItsExitCode) {
    char name[] = "path/to/tool";
    char* argv[] = {name, nullptr};
    testing::internal::CaptureStderr();
    EXPECT_EQ(cli::guarded(1, argv, [] { return ExitCode::stopped_early; }), 2);
    EXPECT_EQ(cli::guarded(1, argv, []() -> ExitCode { throw Error(ExitCode::bad_input, "f:1:2", "wrong", "right"); }),
              65);
    EXPECT_EQ(cli::guarded(1, argv, []() -> ExitCode { throw Error(ExitCode::internal, "", "odd"); }), 70);
    EXPECT_EQ(cli::guarded(1, argv, []() -> ExitCode { throw std::bad_alloc{}; }), 74);
    EXPECT_EQ(cli::guarded(1, argv, []() -> ExitCode { throw std::logic_error{"a\nb"}; }), 70);
    EXPECT_EQ(cli::guarded(1, argv, []() -> ExitCode { throw 5; }), 70);
    const std::string text = testing::internal::GetCapturedStderr();
    EXPECT_EQ(text.find("tool: f:1:2: wrong; right\n"), 0u) << text;
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 5) << text;
    EXPECT_TRUE(contains(text, "this is a bug, please report it")) << text;
}

TEST(TakeLibraryOptions, SplitsAtTheFirstDoubleDash) {
    std::string words[] = {"solve", "case.h5", "--", "-ksp_view", "--", "x"};
    char* argv[] = {words[0].data(), words[1].data(), words[2].data(), words[3].data(),
                    words[4].data(), words[5].data(), nullptr};
    int argc = 6;
    EXPECT_EQ(cli::take_library_options(argc, argv), (std::vector<std::string>{"-ksp_view", "--", "x"}));
    EXPECT_EQ(argc, 2);
    EXPECT_TRUE(cli::take_library_options(argc, argv).empty());
}

}  // namespace
