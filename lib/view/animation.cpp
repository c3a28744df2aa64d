#include "view/animation.hpp"

#include <algorithm>
#include <deque>
#include <functional>
#include <future>
#include <set>
#include <string>
#include <system_error>

#include "core/error.hpp"
#include "core/files.hpp"
#include "math/threads.hpp"
#include "view/numbered_files.hpp"

namespace soft::view {

namespace {

namespace fs = std::filesystem;

/// Draws the frames side by side, and takes them one after the other.
void draw_side_by_side(std::size_t count, const std::function<core::Bytes(std::size_t)>& draw,
                       const std::function<void(const core::Bytes&)>& take, const Progress& progress) {
    constexpr int most = 8;  // 40 MB each
    const auto at_once = static_cast<std::size_t>(std::clamp(thread_count(0), 1, most));
    std::deque<std::future<core::Bytes>> frames;
    for (std::size_t k = 0, next = 0; k < count; ++k) {
        for (; next < std::min(count, k + at_once); ++next)
            frames.push_back(std::async(std::launch::async, draw, next));
        progress(k);
        take(frames.front().get());
        frames.pop_front();
    }
    progress(count);
}

std::size_t draw_frames(const Body& body, const PictureStyle& style, std::span<const Shot> shots,
                        const fs::path& folder, const Progress& progress) {
    const Framing frame = framing(body, style, shots);
    std::set<std::size_t> drawn;
    const auto write = [&](const core::Bytes& picture) {
        const std::size_t k = drawn.size();
        core::AtomicFile file(folder / numbered_name(frame_numbering, k));
        static_cast<void>(file.write(picture));
        file.commit();
        drawn.insert(k);
    };
    draw_side_by_side(
        shots.size(), [&](std::size_t k) { return picture_png(body, style, frame, shots[k], folder.string()); }, write,
        progress);
    return remove_stale_files(folder, frame_numbering, drawn);
}

void draw_film(const Body& body, const PictureStyle& style, std::span<const Shot> shots, const fs::path& file,
               const Progress& progress) {
    const Framing frame = framing(body, style, shots);
    std::string pictures;
    draw_side_by_side(
        shots.size(), [&](std::size_t k) { return picture_png(body, style, frame, shots[k], file.string()); },
        [&](const core::Bytes& picture) {
            pictures.append(reinterpret_cast<const char*>(picture.data()), picture.size());
        },
        progress);
    const core::Bytes film = film_bytes(film_format(file), pictures, shots.size(), file.string());
    core::AtomicFile target(file);
    static_cast<void>(target.write(film));
    target.commit();
}

}  // namespace

FilmFormat film_format(const fs::path& file) {
    std::error_code ignored;
    if (!file.has_filename() || fs::is_directory(file, ignored)) return FilmFormat::folder;
    if (file.extension() == ".gif") return FilmFormat::gif;
    if (file.extension() == ".mp4") return FilmFormat::mp4;
    throw Error(ExitCode::usage, "--animate " + file.string(), "not an animation format",
                "use a name that ends in .gif or .mp4, or a folder that ends in /");
}

void prepare_animation(const fs::path& file) {
    const FilmFormat format = film_format(file);
    if (format == FilmFormat::folder) return make_folder(file, "--animate " + file.string());
    std::error_code ignored;
    // A pipe must not be opened for this test: its reader would interpret the closing as the end of the data.
    if (!fs::exists(file, ignored) || fs::is_regular_file(file, ignored)) const core::AtomicFile trial(file);
    try_film(format, file.string());
}

std::size_t draw_animation(const Body& body, const PictureStyle& style, std::span<const Shot> shots,
                           const fs::path& file, const Progress& progress) {
    if (film_format(file) == FilmFormat::folder) {
        make_folder(file, "--animate " + file.string());
        return draw_frames(body, style, shots, file, progress);
    }
    draw_film(body, style, shots, file, progress);
    return 0;
}

}  // namespace soft::view
