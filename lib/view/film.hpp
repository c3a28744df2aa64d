#pragma once
/// Encodes a sequence of pictures as a film in memory, with the program ffmpeg. It uses no named files: nothing is left behind when the
/// program is killed, and no file name is interpreted as a protocol, an option or a pattern. Tested by view/film_test.
#include <span>
#include <string_view>

#include "core/files.hpp"

namespace soft::view {

enum class FilmFormat { gif, mp4, folder };

/// Frame rate of a film: about `film_seconds` in total, limited to 2 to 25 frames per second. The last frame is held for one second.
/// A GIF repeats from the beginning.
inline constexpr double film_seconds = 5;
[[nodiscard]] double frames_per_second(std::size_t frames);

/// `pictures`: `count` concatenated PNG (or PPM) files of equal size with even width and height. `format`: gif or mp4.
/// Error(cannot_create, `location`): ffmpeg is missing (names the package) or failed; Error(io_error): not enough disk space for an
/// MP4, which ffmpeg writes to an unnamed temporary file because its header is written last.
[[nodiscard]] core::Bytes film_bytes(FilmFormat format, std::string_view pictures, std::size_t count,
                                     std::string_view location);

/// Encodes one small picture and discards the result, so that the errors of film_bytes are reported before any picture is drawn.
void try_film(FilmFormat format, std::string_view location);

/// Whether the sizes of the boxes of an MP4 file add up to its length and include an index (moov) and media data (mdat). Needed
/// because ffmpeg may end with exit code 0 on a full disk. Source: ISO/IEC 14496-12, 4.2 (size, type, 64-bit size).
[[nodiscard]] bool is_whole_mp4(std::span<const std::byte> file);

}  // namespace soft::view
