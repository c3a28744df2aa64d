#include "post/gnuplot.hpp"

#include <array>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/program.hpp"
#include "core/text.hpp"

namespace soft::post {
namespace {

/// gnuplot's error message as one line: the text after the caret that it draws, or all of a short message.
std::string reason(std::string text) {
    if (const auto caret = text.find("^\n"); caret != std::string::npos) text.erase(0, caret + 2);
    const auto words = core::trimmed(text);
    return words.empty() ? "no error message" : core::one_line(words.substr(0, words.find('\n')));
}

/// Start-up files (~/.gnuplot, the system's) and variables (GNUTERM, GNUPLOT_FONTPATH) are disabled: they would change the picture or
/// its destination.
const std::array<std::string, 1> default_settings{"-d"};
constexpr std::array<std::string_view, 3> user_variables{"GNU", "GDFONTPATH", "FIT_"};

}  // namespace

std::string gnuplot_text(std::string_view text) {
    constexpr std::size_t max_length = 200;  // bytes; longer text does not fit in a picture
    std::string out = "'";
    for (const char c : core::one_line(text, max_length)) out += c == '\'' ? "''" : std::string(1, c);
    return out + "'";
}

core::Bytes gnuplot_bytes(std::string_view script, std::string_view location) {
    core::ProgramOutput drawn = core::capture_program_output(
        {.name = "gnuplot",
         .arguments = default_settings,
         .input = script,
         .purpose = "draws the picture",
         .remedy = "install the package gnuplot-nox (Debian, Ubuntu) or gnuplot (Fedora, Homebrew)",
         .dropped_variables = user_variables},
        location);
    if (!drawn.status.succeeded || drawn.bytes.empty())
        throw Error(ExitCode::cannot_create, location, "gnuplot failed: " + reason(drawn.status.error_output));
    return std::move(drawn.bytes);
}

void run_gnuplot(std::string_view script, const std::filesystem::path& file) {
    const core::Bytes picture = gnuplot_bytes(script, file.string());
    core::AtomicFile target(file);  // created only now: an earlier abort leaves no temporary file
    static_cast<void>(target.write(picture));
    target.commit();
}

std::string gnuplot_output(std::string_view script, std::string_view location) {
    const core::Bytes bytes = gnuplot_bytes(script, location);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace soft::post
