#include "post/gnuplot.hpp"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "../core/path_variable.hpp"
#include "core/error.hpp"

namespace soft::post {
namespace {

using soft::test::PathVariable;
using soft::test::Variable;

std::filesystem::path fresh_folder(const char* name) {
    const auto folder = std::filesystem::path(::testing::TempDir()) / name;
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
}

TEST(Gnuplot, NamesThePackageIfMissingAndLeavesNoFile) {
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

TEST(Gnuplot, ReportsAnInvalidScriptInOneLineAndLeavesNoFile) {
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

TEST(Gnuplot, IgnoresTheSettingsOfTheUser) {
    const std::string script = "set terminal svg\nplot x\n";
    const std::string plain = gnuplot_output(script, "a.svg");
    const auto home = fresh_folder("soft_home");
    std::ofstream(home / ".gnuplot") << "set xrange [0:1e6]\nset logscale y\nset output '" << (home / "lost").string()
                                     << "'\n";
    const Variable home_variable{"HOME", home.string()};
    for (const char* terminal : {"dumb", "x11", "no-such-terminal"}) {
        const Variable terminal_variable{"GNUTERM", terminal};
        EXPECT_EQ(gnuplot_output(script, "a.svg"), plain) << terminal;
    }
    const Variable terminal_variable{"GNUTERM", "dumb; set output '" + (home / "lost").string() + "'"};
    EXPECT_EQ(gnuplot_output(script, "a.svg"), plain);
    EXPECT_FALSE(std::filesystem::exists(home / "lost"));
}

TEST(Gnuplot, ReportsAMissingFolderAsCannotCreate) {
    try {
        run_gnuplot("set terminal svg\nplot x\n", "/nonexistent-folder/a.svg");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::cannot_create);
    }
}

/// Limits the file size, to simulate a full disk.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

private:
    rlimit before_{};
    void (*handler_)(int);
};

TEST(Gnuplot, KeepsTheOldPictureIfTheDiskIsFull) {
    const auto folder = fresh_folder("soft_no_room");
    const auto file = folder / "a.svg";
    std::ofstream(file) << "old";
    for (const char* terminal : {"svg", "pngcairo", "pdfcairo"}) {
        ExitCode code = ExitCode::ok;
        {
            const FileSizeLimit limit{2000};
            try {
                run_gnuplot("set terminal " + std::string(terminal) + "\nset samples 5000\nplot sin(10*x)\n", file);
            } catch (const Error& error) {
                code = error.code();
            }
        }
        EXPECT_EQ(code, ExitCode::io_error) << terminal;
        EXPECT_EQ(std::filesystem::file_size(file), 3U) << terminal;
    }
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);  // no temporary file
}

}  // namespace
}  // namespace soft::post
