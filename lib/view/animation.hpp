#pragma once
/// A picture for each step, and films made of them by the program ffmpeg. Held by view/animation_test.
#include <filesystem>
#include <functional>

#include "view/picture.hpp"

namespace soft::view {

enum class FilmFormat { gif, mp4, folder };

/// By the ending of the name; a folder ends with '/' or is one already. Throws Error(usage, place "--animate") for
/// anything else.
[[nodiscard]] FilmFormat film_format(const std::filesystem::path& file);

/// How long a film takes: every frame alike, about `film_seconds` in all, but 2 to 25 frames a second; the last frame
/// stays for a second. It repeats from the beginning (GIF).
inline constexpr double film_seconds = 5;
[[nodiscard]] double frames_per_second(std::size_t frames);

/// Called before each frame with the number of those done.
using Progress = std::function<void(std::size_t)>;

/// FILE.gif or FILE.mp4, whole or not at all; or FOLDER/frame-0000.png and so on (the folder is made where it is
/// missing, its parent is not). All frames share one framing. Error(cannot_create) without gnuplot or (films) ffmpeg,
/// or where the file cannot be written.
void draw_animation(const Body& body, const Look& look, std::span<const Shot> shots, const std::filesystem::path& file,
                    const Progress& progress);

}  // namespace soft::view
