#include <gtest/gtest.h>

#include "process.hpp"

namespace {

using namespace soft::process;

class Revision : public testing::Test {
protected:
    void SetUp() override {
        if (run(folder_, "git --version").code != 0) GTEST_SKIP() << "git is not installed";
    }
    std::string revision() {
        const std::string script = std::string{SOFT_SOURCE_DIR} + "/tools/revision.cmake";
        const Outcome outcome = run(
            folder_, std::string{CMAKE_PROGRAM} + " -D SOURCE=$PWD/source -D OUTPUT=$PWD/revision.hpp -P " + script);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        const std::string header = slurp(folder_ / "revision.hpp");
        const auto quote = header.find('"');
        return header.substr(quote + 1, header.find('"', quote + 1) - quote - 1);
    }
    Folder folder_;
};

TEST_F(Revision, IsUnknownOutsideAClone) {
    fs::create_directory(folder_ / "source");
    EXPECT_EQ(revision(), "unknown");
}

TEST_F(Revision, ContainsTheCommitAndMarksChanges) {
    const std::string setup =
        "export HOME=$PWD; git init -q source && cd source && echo a > file && git add file && "
        "git -c user.name=n -c user.email=e@x commit -q -m m && git rev-parse --short=12 HEAD";
    const Outcome made = run(folder_, setup);
    ASSERT_EQ(made.code, 0) << made.err;
    const std::string commit = made.out.substr(0, made.out.size() - 1);
    EXPECT_EQ(revision(), commit);
    const auto written = fs::last_write_time(folder_ / "revision.hpp");
    EXPECT_EQ(revision(), commit);
    EXPECT_EQ(fs::last_write_time(folder_ / "revision.hpp"), written);  // unchanged: nothing is rebuilt
    folder_.write("source/file", "b");
    EXPECT_EQ(revision(), commit + "-dirty");
}

}  // namespace
