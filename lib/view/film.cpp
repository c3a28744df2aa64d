#include "view/film.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "core/program.hpp"
#include "core/text.hpp"

namespace soft::view {

namespace {

constexpr double min_mp4_rate = 10;  // players seek poorly in films with fewer frames per second

/// Bytes reserved for the index of an MP4, which is then stored before the pictures so that browsers can start playing at once.
/// It needs at most 40 bytes per frame (sizes, times, key frames, chunks) and about 1100 in addition.
std::size_t index_bytes(std::size_t count, double rate) {
    const double frames = (static_cast<double>(count) / rate + 1) * std::max(rate, min_mp4_rate);
    return 4096 + 48 * static_cast<std::size_t>(std::ceil(frames) + 2);
}

/// Arguments of ffmpeg. The last frame is held; an MP4 uses 4:2:0 colours for compatibility (width and height are even); a GIF uses a
/// palette of 256 colours computed from its frames.
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
        "-moov_size", std::to_string(index_bytes(count, rate)),
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

/// The last line of ffmpeg's error output.
std::string last_line(const core::ProgramStatus& end) {
    const auto words = core::trimmed(end.error_output);
    return words.empty() ? "no reason given" : core::one_line(words.substr(words.rfind('\n') + 1));
}

void check_end(const core::ProgramStatus& end, std::string_view location) {
    if (!end.succeeded) throw Error(ExitCode::cannot_create, location, "ffmpeg failed: " + last_line(end));
}

/// Uses an unnamed temporary file, because ffmpeg seeks in an MP4, which a pipe does not support.
core::Bytes encode_to_temporary_file(core::ProgramCall call, std::string_view location) {
    const core::Stream scratch = core::temporary_file(location);
    call.output = ::fileno(scratch.get());
    const core::ProgramStatus end = core::run_program(call, location);
    check_end(end, location);
    std::rewind(scratch.get());
    core::Bytes film = core::read_descriptor(call.output, location);
    if (!is_whole_mp4(film))
        throw Error(ExitCode::io_error, location, "ffmpeg could not write the complete film: " + last_line(end),
                    "free disk space for temporary files");
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

core::Bytes film_bytes(FilmFormat format, std::string_view pictures, std::size_t count, std::string_view location) {
    const auto arguments = film_arguments(format, pictures.starts_with("P6") ? "ppm_pipe" : "png_pipe", count);
    const core::ProgramCall call = ffmpeg(arguments, pictures);
    if (format == FilmFormat::mp4) return encode_to_temporary_file(call, location);
    core::ProgramOutput film = core::capture_program_output(call, location);
    check_end(film.status, location);
    if (film.bytes.empty())
        throw Error(ExitCode::cannot_create, location, "ffmpeg produced no film: " + last_line(film.status));
    return std::move(film.bytes);
}

void try_film(FilmFormat format, std::string_view location) {
    constexpr std::size_t side = 16;
    const std::string picture = "P6 16 16 255\n" + std::string(3 * side * side, '\x7f');
    static_cast<void>(film_bytes(format, picture, 1, location));
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
