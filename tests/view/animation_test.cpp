#include "view/animation.hpp"

#include <gtest/gtest.h>

#include <array>

#include "core/error.hpp"
#include "core/files.hpp"
#include "picture_samples.hpp"

namespace soft::view {
namespace {

using namespace test;
namespace fs = std::filesystem;

TEST(Animation, TheNameSelectsTheFormat) {
    EXPECT_EQ(film_format("a.gif"), FilmFormat::gif);
    EXPECT_EQ(film_format("b/a.mp4"), FilmFormat::mp4);
    EXPECT_EQ(film_format("frames/"), FilmFormat::folder);
    EXPECT_EQ(film_format(fresh_folder("soft_known_folder")), FilmFormat::folder);
    EXPECT_THROW(static_cast<void>(film_format("a.avi")), Error);
    EXPECT_THROW(static_cast<void>(film_format("frames")), Error);
}

TEST(Animation, AFolderGetsAFrameForEachShot) {
    const Cube cube;
    const std::array<Shot, 3> shots{cube.pulled(1.0), cube.pulled(1.5), cube.pulled(2.0)};
    const auto folder = fresh_folder("soft_frames") / "new/";
    std::vector<std::size_t> progress;
    draw_animation(cube.body, cube.look, shots, folder, [&](std::size_t done) { progress.push_back(done); });
    for (const char* name : {"frame-0000.png", "frame-0001.png", "frame-0002.png"})
        EXPECT_TRUE(fs::exists(folder / name)) << name;
    EXPECT_EQ(progress, (std::vector<std::size_t>{0, 1, 2, 3}));
}

TEST(Animation, FilmsHaveTheMagicNumbersOfTheirFormats) {
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

TEST(Animation, AShorterAnimationRemovesTheFramesOfAnEarlierLongerOne) {
    const Cube cube;
    const std::array<Shot, 3> shots{cube.pulled(1.0), cube.pulled(1.5), cube.pulled(2.0)};
    const auto folder = fresh_folder("soft_fewer_frames");
    EXPECT_EQ(draw_animation(cube.body, cube.look, shots, folder, [](std::size_t) {}), 0U);
    EXPECT_EQ(draw_animation(cube.body, cube.look, {shots.data(), 2}, folder, [](std::size_t) {}), 1U);
    EXPECT_TRUE(fs::exists(folder / "frame-0001.png"));
    EXPECT_FALSE(fs::exists(folder / "frame-0002.png"));
}

TEST(Animation, FileNamesAreNotInterpretedAsProtocolOptionOrPattern) {
    if (program("ffmpeg").empty()) GTEST_SKIP() << "ffmpeg is not installed";
    const Cube cube;
    const Shot shot = cube.pulled(1.5);
    const auto folder = fresh_folder("soft_film_names"), before = fs::current_path();
    fs::current_path(folder);
    for (const char* name : {"run:3.gif", "-x%d.gif", "a b'\"$.mp4"}) {
        prepare_animation(name);
        EXPECT_TRUE(fs::is_empty(folder)) << name;  // prepare_animation leaves no file
        draw_animation(cube.body, cube.look, {&shot, 1}, name, [](std::size_t) {});
        EXPECT_TRUE(fs::remove(name)) << name;
    }
    fs::current_path(before);
}

std::string refusal(const fs::path& file) {
    try {
        prepare_animation(file);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::cannot_create);
        return error.what();
    }
    return "none";
}

TEST(Animation, ErrorsAreReportedBeforeTheFirstFrame) {
    const auto folder = fresh_folder("soft_no_ffmpeg"), bin = fresh_folder("soft_gnuplot_alone");
    EXPECT_EQ(refusal(folder / "none/a.gif"),
              (folder / "none/a.gif").string() + ": cannot be created: No such file or directory");
    EXPECT_NE(refusal(folder / "none/a/").find("does not exist; create it first"), std::string::npos);
    {
        const PathVariable path{bin.string()};
        EXPECT_NE(refusal(folder / "a.mp4").find("install the package ffmpeg"), std::string::npos);
    }
    EXPECT_TRUE(fs::is_empty(folder));
}

}  // namespace
}  // namespace soft::view
