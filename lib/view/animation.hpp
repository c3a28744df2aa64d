#pragma once
/// A picture for each step: in a folder, or as a film. Tested by view/animation_test.
#include <filesystem>
#include <functional>

#include "view/film.hpp"
#include "view/picture.hpp"

namespace soft::view {

/// By the ending of the name; a folder ends with '/' or is one already. Throws Error(usage, place "--animate") for
/// anything else.
[[nodiscard]] FilmFormat film_format(const std::filesystem::path& file);

/// What draw_animation would refuse at its end is refused here, before any work: no ffmpeg or one without the format,
/// a place where no file can be made. Makes the folder of frames where it is missing, its parent it does not.
/// Error(cannot_create).
void prepare_animation(const std::filesystem::path& file);

/// Called before each frame with the number of those done.
using Progress = std::function<void(std::size_t)>;

/// FILE.gif or FILE.mp4, whole or not at all; or FOLDER/frame-0000.png and so on. All frames share one framing.
/// Returns how many frames of an earlier, longer animation were removed from the folder. Errors: as prepare_animation
/// and draw_picture.
std::size_t draw_animation(const Body& body, const Look& look, std::span<const Shot> shots,
                           const std::filesystem::path& file, const Progress& progress);

}  // namespace soft::view
