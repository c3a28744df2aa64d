#pragma once
/// Animations: one picture per step, written into a folder or encoded as a film. Tested by view/animation_test.
#include <filesystem>
#include <functional>

#include "view/film.hpp"
#include "view/picture.hpp"

namespace soft::view {

/// The format that the file extension selects; a folder is a name that ends with '/' or an existing folder. Throws Error(usage,
/// location "--animate") for anything else.
[[nodiscard]] FilmFormat film_format(const std::filesystem::path& file);

/// Reports the errors of draw_animation before any work is done: ffmpeg is missing or lacks the format, or the file cannot be
/// created. Creates the folder of frames if it is missing, but not its parent. Error(cannot_create).
void prepare_animation(const std::filesystem::path& file);

/// Called before each frame and at the end with the number of finished frames.
using Progress = std::function<void(std::size_t)>;

/// Writes FILE.gif or FILE.mp4 atomically, or FOLDER/frame-0000.png and so on. All frames share one framing.
/// Returns the number of frames of an earlier, longer animation that were removed from the folder. Errors: as prepare_animation
/// and draw_picture.
std::size_t draw_animation(const Body& body, const PictureStyle& style, std::span<const Shot> shots,
                           const std::filesystem::path& file, const Progress& progress);

}  // namespace soft::view
