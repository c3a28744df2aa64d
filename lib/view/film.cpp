#include "view/film.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/program.hpp"
#include "core/text.hpp"

namespace soft::view {

namespace {

constexpr double min_mp4_rate = 10;  // players jump badly in films of fewer frames a second

/// Bytes for the table of contents of an MP4, which then stands before the pictures, as players in browsers like it.
/// At most 40 bytes a frame in its lists (sizes, times, key frames, chunks), and some 1100 besides.
std::size_t contents_room(std::size_t count, double rate) {
    const double frames = (static_cast<double>(count) / rate + 1) * std::max(rate, min_mp4_rate);
    return 4096 + 48 * static_cast<std::size_t>(std::ceil(frames) + 2);
}

/// What ffmpeg is to do with the frames. The last frame stays; a film for every player has 4:2:0 colours (the sides
/// of frames are even); a GIF gets the 256 colours that fit its frames.
std::vector<std::string> film_arguments(FilmFormat format, const std::string& pictures_format, std::size_t count) {
    const double rate = frames_per_second(count);
    const std::string stay = "tpad=stop_mode=clone:stop_duration=1";
    std::vector<std::string> arguments{
        "-hide_banner", "-loglevel", "error", "-f", pictures_format, "-framerate", core::rounded_text(rate, 6),
        "-i",           "pipe:0"};
    const std::vector<std::string> mp4{
        "-vf",        stay + ",fps=" + core::rounded_text(std::max(rate, min_mp4_rate), 6),
        "-c:v",       "libx264",
        "-pix_fmt",   "yuv420p",
        "-crf",       "18",
        "-moov_size", std::to_string(contents_room(count, rate)),
        "-f",         "mp4",
        "-bitexact",  "-y",
        "/dev/fd/1"};
    const std::vector<std::string> gif{
        "-filter_complex",
        stay + ",split[a][b];[a]palettegen=stats_mode=full[p];[b][p]paletteuse=dither=sierra2_4a",
        "-loop",
        "0",
        "-f",
        "gif",
        "-bitexact",
        "pipe:1"};
    const auto& rest = format == FilmFormat::mp4 ? mp4 : gif;
    arguments.insert(arguments.end(), rest.begin(), rest.end());
    return arguments;
}

core::ProgramCall ffmpeg(std::span<const std::string> arguments, std::string_view pictures) {
    return {.name = "ffmpeg",
            .arguments = arguments,
            .input = pictures,
            .purpose = "makes films",
            .remedy = "install the package ffmpeg, or name a folder (ending with /) for the single frames"};
}

/// The last line of what ffmpeg said.
std::string last_words(const core::ProgramEnd& end) {
    const auto words = core::trimmed(end.complaint);
    return words.empty() ? "it gave no reason" : core::one_line(words.substr(words.rfind('\n') + 1));
}

void check_end(const core::ProgramEnd& end, std::string_view place) {
    if (!end.well) throw Error(ExitCode::cannot_create, place, "ffmpeg failed: " + last_words(end));
}

struct CloseFile {
    void operator()(std::FILE* stream) const noexcept { std::fclose(stream); }
};

/// ffmpeg goes back in an MP4, which a pipe does not let it.
core::Bytes through_scratch(core::ProgramCall call, std::string_view place) {
    const std::unique_ptr<std::FILE, CloseFile> scratch{std::tmpfile()};  // nameless: gone when closed
    if (!scratch)
        throw Error(ExitCode::cannot_create, place, std::string("no temporary file: ") + std::strerror(errno));
    call.output = ::fileno(scratch.get());
    const core::ProgramEnd end = core::run_program(call, place);
    check_end(end, place);
    std::rewind(scratch.get());
    core::Bytes film = core::read_descriptor(call.output, place);
    if (!is_whole_mp4(film))
        throw Error(ExitCode::io_error, place, "ffmpeg could not write the whole film: " + last_words(end),
                    "make room for temporary files");
    return film;
}

std::uint64_t big_endian(std::span<const std::byte> bytes) {
    std::uint64_t value = 0;
    for (const std::byte byte : bytes) value = 256 * value + std::to_integer<std::uint64_t>(byte);
    return value;
}

}  // namespace

double frames_per_second(std::size_t frames) {
    return std::clamp(static_cast<double>(frames) / film_seconds, 2.0, 25.0);
}

core::Bytes film_bytes(FilmFormat format, std::string_view pictures, std::size_t count, std::string_view place) {
    const auto arguments = film_arguments(format, pictures.starts_with("P6") ? "ppm_pipe" : "png_pipe", count);
    const core::ProgramCall call = ffmpeg(arguments, pictures);
    if (format == FilmFormat::mp4) return through_scratch(call, place);
    core::ProgramOutput film = core::program_output(call, place);
    check_end(film.end, place);
    if (film.bytes.empty()) throw Error(ExitCode::cannot_create, place, "ffmpeg made no film: " + last_words(film.end));
    return std::move(film.bytes);
}

void try_film(FilmFormat format, std::string_view place) {
    constexpr std::size_t side = 16;
    const std::string picture = "P6 16 16 255\n" + std::string(3 * side * side, '\x7f');
    static_cast<void>(film_bytes(format, picture, 1, place));
}

bool is_whole_mp4(std::span<const std::byte> file) {
    bool contents = false, pictures = false;
    while (!file.empty()) {
        if (file.size() < 8) return false;
        const std::string_view type{reinterpret_cast<const char*>(file.data()) + 4, 4};
        std::uint64_t size = big_endian(file.first(4)), head = 8;
        if (size == 1 && file.size() >= 16) {
            size = big_endian(file.subspan(8, 8));
            head = 16;
        }
        if (size < head || size > file.size()) return false;
        contents = contents || type == "moov";
        pictures = pictures || (type == "mdat" && size > head);
        file = file.subspan(static_cast<std::size_t>(size));
    }
    return contents && pictures;
}

}  // namespace soft::view
