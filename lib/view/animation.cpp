#include "view/animation.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <system_error>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/program.hpp"
#include "core/text.hpp"

namespace soft::view {

namespace {

namespace fs = std::filesystem;

std::string frame_name(std::size_t k) {
    const std::string digits = std::to_string(k);
    return "frame-" + std::string(digits.size() < 4 ? 4 - digits.size() : 0, '0') + digits + ".png";
}

/// A folder that goes away with what is in it.
class Scratch {
public:
    explicit Scratch(const fs::path& place) {
        std::error_code failure;
        std::string name = (fs::temp_directory_path(failure) / "soft-film-XXXXXX").string();
        if (failure || ::mkdtemp(name.data()) == nullptr)
            throw Error(ExitCode::cannot_create, place.string(),
                        "no temporary folder can be made in " + fs::path(name).parent_path().string());
        folder_ = name;
    }
    ~Scratch() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    [[nodiscard]] const fs::path& folder() const noexcept { return folder_; }

private:
    fs::path folder_;
};

void draw_frames(const Body& body, const Look& look, std::span<const Shot> shots, const fs::path& folder,
                 const Progress& progress) {
    const Framing frame = framing(body, look, shots);
    for (std::size_t k = 0; k < shots.size(); ++k) {
        progress(k);
        draw_picture(body, look, frame, shots[k], folder / frame_name(k));
    }
    progress(shots.size());
}

/// What ffmpeg is to do with the frames. The last frame stays; a film for every player has 4:2:0 colours
/// (the sides of frames are even); a GIF
/// gets the 256 colours that fit its frames.
std::vector<std::string> film_arguments(FilmFormat format, double rate) {
    const std::string stay = "tpad=stop_mode=clone:stop_duration=1";
    if (format == FilmFormat::mp4)
        return {"-vf",       stay + ",fps=" + core::rounded_text(std::max(rate, 10.0), 6) + "",
                "-c:v",      "libx264",
                "-pix_fmt",  "yuv420p",
                "-crf",      "18",
                "-movflags", "+faststart",
                "-f",        "mp4"};
    return {"-filter_complex",
            stay + ",split[a][b];[a]palettegen=stats_mode=full[p];[b][p]paletteuse=dither=sierra2_4a",
            "-loop",
            "0",
            "-f",
            "gif"};
}

void make_film(FilmFormat format, double rate, const fs::path& frames, const fs::path& file) {
    core::AtomicFile film(file);
    std::vector<std::string> arguments{"-hide_banner",
                                       "-loglevel",
                                       "error",
                                       "-nostdin",
                                       "-y",
                                       "-framerate",
                                       core::rounded_text(rate, 6),
                                       "-i",
                                       (frames / "frame-%04d.png").string()};
    for (std::string& word : film_arguments(format, rate)) arguments.push_back(std::move(word));
    arguments.push_back("-bitexact");
    arguments.push_back(film.written_path().string());
    const core::ProgramEnd end = core::run_program(
        {.name = "ffmpeg",
         .arguments = arguments,
         .input = {},
         .purpose = "makes films",
         .remedy = "install the package ffmpeg, or name a folder (ending with /) for the single frames"},
        file.string());
    if (!end.well) {
        const auto words = core::trimmed(end.complaint);
        throw Error(ExitCode::cannot_create, file.string(),
                    "ffmpeg failed: " + core::one_line(words.substr(words.rfind('\n') + 1)));
    }
    film.commit();
}

}  // namespace

FilmFormat film_format(const fs::path& file) {
    std::error_code ignored;
    if (!file.has_filename() || fs::is_directory(file, ignored)) return FilmFormat::folder;
    if (file.extension() == ".gif") return FilmFormat::gif;
    if (file.extension() == ".mp4") return FilmFormat::mp4;
    throw Error(ExitCode::usage, "--animate " + file.string(),
                "animations are written as .gif, .mp4 or into a FOLDER/");
}

double frames_per_second(std::size_t frames) {
    return std::clamp(static_cast<double>(frames) / film_seconds, 2.0, 25.0);
}

void draw_animation(const Body& body, const Look& look, std::span<const Shot> shots, const fs::path& file,
                    const Progress& progress) {
    const FilmFormat format = film_format(file);
    if (format == FilmFormat::folder) {
        std::error_code failure;
        fs::create_directory(file.has_filename() ? file : file.parent_path(), failure);
        if (failure) throw Error(ExitCode::cannot_create, file.string(), failure.message());
        return draw_frames(body, look, shots, file, progress);
    }
    const Scratch scratch(file);
    draw_frames(body, look, shots, scratch.folder(), progress);
    make_film(format, frames_per_second(shots.size()), scratch.folder(), file);
}

}  // namespace soft::view
