#include "view/film.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "core/error.hpp"
#include "picture_samples.hpp"

namespace soft::view {
namespace {

using namespace test;

/// `count` concatenated grey pictures (PPM).
std::string greys(std::size_t count) {
    std::string all;
    for (std::size_t k = 0; k < count; ++k)
        all += "P6 64 48 255\n" + std::string(3 * 64 * 48, static_cast<char>(8 * k));
    return all;
}

TEST(Film, TheFrameRateGrowsWithTheNumberOfFramesWithinItsLimits) {
    EXPECT_DOUBLE_EQ(frames_per_second(3), 2.0);
    EXPECT_DOUBLE_EQ(frames_per_second(50), 10.0);
    EXPECT_DOUBLE_EQ(frames_per_second(1000), 25.0);
}

TEST(Film, ATruncatedMp4IsDetected) {
    if (program("ffmpeg").empty()) GTEST_SKIP() << "ffmpeg is not installed";
    const core::Bytes film = film_bytes(FilmFormat::mp4, greys(9), 9, "x");
    EXPECT_TRUE(is_whole_mp4(film));
    for (std::size_t size = 0; size < film.size(); size += 1 + size / 50)
        EXPECT_FALSE(is_whole_mp4(std::span{film}.first(size))) << size;
    EXPECT_FALSE(is_whole_mp4(std::span{film}.first(film.size() - 1)));
}

TEST(Film, TheIndexOfAnMp4PrecedesThePictures) {
    if (program("ffmpeg").empty()) GTEST_SKIP() << "ffmpeg is not installed";
    for (const std::size_t count : {1UL, 2UL, 60UL, 600UL}) {
        const core::Bytes film = film_bytes(FilmFormat::mp4, greys(count), count, "x");
        const std::string_view text{reinterpret_cast<const char*>(film.data()), film.size()};
        EXPECT_LT(text.find("moov"), text.find("mdat")) << count;
    }
}

TEST(Film, AGifEndsWithItsTrailer) {
    if (program("ffmpeg").empty()) GTEST_SKIP() << "ffmpeg is not installed";
    const core::Bytes film = film_bytes(FilmFormat::gif, greys(3), 3, "x");
    const std::string_view text{reinterpret_cast<const char*>(film.data()), film.size()};
    EXPECT_EQ(text.substr(0, 6), "GIF89a");
    EXPECT_EQ(text.back(), ';');  // GIF89a specification, 27
}

TEST(Film, TryFilmReportsAMissingEncoder) {
    const auto bin = fresh_folder("soft_ffmpeg_without_encoders");
    write_program(bin / "ffmpeg", "echo \"Unknown encoder 'libx264'\" >&2; exit 1");
    const PathVariable path{bin.string()};
    try {
        try_film(FilmFormat::mp4, "a.mp4");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::cannot_create);
        EXPECT_STREQ(error.what(), "a.mp4: ffmpeg failed: Unknown encoder 'libx264'");
    }
}

/// ffmpeg 5.1 behaves this way on a full disk.
TEST(Film, AnIncompleteFilmWithExitCode0IsAnError) {
    const auto bin = fresh_folder("soft_ffmpeg_on_a_full_disk");
    write_program(bin / "ffmpeg",
                  "printf '\\000\\000\\000\\020ftypisom\\000\\000\\000\\000\\000\\000\\100\\000moov'; "
                  "echo 'Error writing trailer: No space left on device' >&2");
    const PathVariable path{bin.string()};
    try {
        static_cast<void>(film_bytes(FilmFormat::mp4, greys(1), 1, "a.mp4"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::io_error);
        EXPECT_NE(std::string(error.what()).find("No space left on device; free disk space"), std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace soft::view
