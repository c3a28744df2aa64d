#pragma once
/// Pictures one after the other -> a film in memory, by the program ffmpeg. No file has a name while it works, so
/// nothing stays behind whatever ends the program, and no name is taken for a protocol, an option or a pattern.
/// Tested by view/film_test.
#include <span>
#include <string_view>

#include "core/files.hpp"

namespace soft::view {

enum class FilmFormat { gif, mp4, folder };

/// How long a film takes: every frame alike, about `film_seconds` in all, but 2 to 25 frames a second; the last frame
/// stays for a second. It repeats from the beginning (GIF).
inline constexpr double film_seconds = 5;
[[nodiscard]] double frames_per_second(std::size_t frames);

/// `pictures`: `count` PNG (or PPM) files of one size with even sides, one behind the other. `format`: gif or mp4.
/// Error(cannot_create, `place`): no ffmpeg (names the package), or it refused; Error(io_error): there was no room for
/// the whole of an MP4, which ffmpeg writes to a nameless temporary file because its head is known last.
[[nodiscard]] core::Bytes film_bytes(FilmFormat format, std::string_view pictures, std::size_t count,
                                     std::string_view place);

/// Makes a film of one small picture and drops it: the errors of film_bytes before there are pictures to lose.
void try_film(FilmFormat format, std::string_view place);

/// Whether the boxes of an MP4 file add up to its length, with a table of contents (moov) and pictures (mdat) among
/// them: ffmpeg may end with exit code 0 on a full disk. Source: ISO/IEC 14496-12, 4.2 (size, type, 64-bit size).
[[nodiscard]] bool is_whole_mp4(std::span<const std::byte> file);

}  // namespace soft::view
