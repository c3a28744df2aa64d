#include "view/animation.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "core/error.hpp"
#include "core/files.hpp"
#include "picture_samples.hpp"

namespace soft::view {
namespace {

using namespace test;
namespace fs = std::filesystem;

/// Where a program stands, or an empty path.
fs::path program(const std::string& name) {
    std::string path = std::getenv("PATH") ? std::getenv("PATH") : "";
    for (std::size_t start = 0; start <= path.size();) {
        const std::size_t end = std::min(path.find(':', start), path.size());
        const fs::path file = fs::path(path.substr(start, end - start)) / name;
        if (fs::exists(file)) return file;
        start = end + 1;
    }
    return {};
}

TEST(Animation, TheFormatIsToldByTheName) {
    EXPECT_EQ(film_format("a.gif"), FilmFormat::gif);
    EXPECT_EQ(film_format("b/a.mp4"), FilmFormat::mp4);
    EXPECT_EQ(film_format("frames/"), FilmFormat::folder);
    EXPECT_EQ(film_format(fresh_folder("soft_known_folder")), FilmFormat::folder);
    EXPECT_THROW(static_cast<void>(film_format("a.avi")), Error);
    EXPECT_THROW(static_cast<void>(film_format("frames")), Error);
}

TEST(Animation, ALongPathIsShownFasterThanAShortOne) {
    EXPECT_DOUBLE_EQ(frames_per_second(3), 2.0);
    EXPECT_DOUBLE_EQ(frames_per_second(50), 10.0);
    EXPECT_DOUBLE_EQ(frames_per_second(1000), 25.0);
}

TEST(Animation, AFolderGetsAFrameForEachShot) {
    const Cube cube;
    const std::array<Shot, 3> shots{cube.pulled(1.0), cube.pulled(1.5), cube.pulled(2.0)};
    const auto folder = fresh_folder("soft_frames") / "new/";
    std::vector<std::size_t> told;
    draw_animation(cube.body, cube.look, shots, folder, [&](std::size_t done) { told.push_back(done); });
    for (const char* name : {"frame-0000.png", "frame-0001.png", "frame-0002.png"})
        EXPECT_TRUE(fs::exists(folder / name)) << name;
    EXPECT_EQ(told, (std::vector<std::size_t>{0, 1, 2, 3}));
}

TEST(Animation, FilmsHaveTheirFormatsMagicNumbers) {
    if (program("ffmpeg").empty()) GTEST_SKIP() << "ffmpeg is not installed";
    const Cube cube;
    const std::array<Shot, 3> shots{cube.pulled(1.0), cube.pulled(1.5), cube.pulled(2.0)};
    const auto folder = fresh_folder("soft_films");
    draw_animation(cube.body, cube.look, shots, folder / "a.gif", [](std::size_t) {});
    draw_animation(cube.body, cube.look, shots, folder / "a.mp4", [](std::size_t) {});
    const auto head = [&](const char* name) {
        const core::Bytes bytes = core::read_file(folder / name);
        return std::string(reinterpret_cast<const char*>(bytes.data()), 12);
    };
    EXPECT_EQ(head("a.gif").substr(0, 6), "GIF89a");
    EXPECT_EQ(head("a.mp4").substr(4, 4), "ftyp");
}

TEST(Animation, TheAbsenceOfFfmpegNamesThePackageAndLeavesNoFile) {
    const auto folder = fresh_folder("soft_no_ffmpeg"), bin = fresh_folder("soft_gnuplot_alone");
    ASSERT_FALSE(program("gnuplot").empty());
    fs::create_symlink(program("gnuplot"), bin / "gnuplot");
    const std::string before = std::getenv("PATH");
    ::setenv("PATH", bin.c_str(), 1);
    std::string message;
    const Cube cube;
    const Shot shot = cube.pulled(1.5);
    try {
        draw_animation(cube.body, cube.look, {&shot, 1}, folder / "a.mp4", [](std::size_t) {});
    } catch (const Error& error) {
        message = error.what();
    }
    ::setenv("PATH", before.c_str(), 1);
    EXPECT_NE(message.find("install the package ffmpeg"), std::string::npos) << message;
    EXPECT_TRUE(fs::is_empty(folder));
}

}  // namespace
}  // namespace soft::view
