#include "post/gnuplot.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "core/error.hpp"

namespace soft::post {
namespace {

/// Another PATH for the length of a test.
class PathVariable {
public:
    explicit PathVariable(const std::string& value) : before_(std::getenv("PATH") ? std::getenv("PATH") : "") {
        ::setenv("PATH", value.c_str(), 1);
    }
    ~PathVariable() { ::setenv("PATH", before_.c_str(), 1); }
    PathVariable(const PathVariable&) = delete;
    PathVariable& operator=(const PathVariable&) = delete;

private:
    std::string before_;
};

std::filesystem::path fresh_folder(const char* name) {
    const auto folder = std::filesystem::path(::testing::TempDir()) / name;
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
}

TEST(Gnuplot, ItsAbsenceNamesThePackageAndLeavesNoFile) {
    const auto folder = fresh_folder("soft_no_gnuplot");
    const PathVariable path{folder.string()};
    try {
        run_gnuplot("plot x\n", folder / "a.svg");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::cannot_create);
        EXPECT_NE(std::string(error.what()).find("install the package gnuplot-nox"), std::string::npos) << error.what();
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST(Gnuplot, ARefusedScriptIsReportedInOneLineAndLeavesNoFile) {
    const auto folder = fresh_folder("soft_bad_script");
    try {
        run_gnuplot("set terminal svg\nplot nonsense_function(x)\n", folder / "a.svg");
        FAIL();
    } catch (const Error& error) {
        const std::string text = error.what();
        EXPECT_EQ(error.code(), ExitCode::cannot_create);
        EXPECT_NE(text.find("undefined function"), std::string::npos) << text;
        EXPECT_EQ(text.find('\n'), std::string::npos);
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST(Gnuplot, AFolderThatDoesNotExistIsAnOutputThatCannotBeCreated) {
    try {
        run_gnuplot("set terminal svg\nplot x\n", "/nonexistent-folder/a.svg");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::cannot_create);
    }
}

}  // namespace
}  // namespace soft::post
