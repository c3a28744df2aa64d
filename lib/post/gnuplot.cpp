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

constexpr int panel_width = 800, panel_height = 560;  // of SVG and PNG

std::string size_text(int factor, int panels) {
    // Each of several panels is narrower than a single one.
    const int width = panels == 1 ? panel_width : panel_width * 3 / 4 * panels;
    return std::to_string(factor * width) + "," + std::to_string(factor * panel_height);
}

}  // namespace

PictureFormat picture_format(const std::filesystem::path& file) {
    const std::string ending = file.extension().string();
    if (ending == ".svg") return PictureFormat::svg;
    if (ending == ".png") return PictureFormat::png;
    if (ending == ".pdf") return PictureFormat::pdf;
    throw Error(ExitCode::usage, file.string(), "unknown picture format", "use .svg, .png or .pdf");
}

std::string terminal(PictureFormat format, int panels) {
    switch (format) {
        case PictureFormat::svg:
            return "set terminal svg size " + size_text(1, panels) + " font 'Helvetica,15' background rgb 'white'\n";
        case PictureFormat::pdf: {
            const std::string size = panels == 1 ? "16cm,11.2cm" : std::to_string(panels * 12) + "cm,11.2cm";
            return "set terminal pdfcairo size " + size + " font 'Helvetica,11' linewidth 1.2\n";
        }
        case PictureFormat::png: break;
    }
    const std::string size = size_text(2, panels);
    return "if (strstrt(GPVAL_TERMINALS, 'pngcairo')) set terminal pngcairo size " + size +
           " font 'Sans,26' linewidth 2; else set terminal png size " + size + " font 'Sans,26' linewidth 2\n";
}

std::string axes_style() {
    return "set grid linecolor rgb '#b0b0b0' linewidth 0.5\nset border 3 linewidth 1\nset tics nomirror out\n";
}

std::string gnuplot_text(std::string_view text) {
    constexpr std::size_t max_length = 200;  // bytes; longer text does not fit in a picture
    return core::single_quoted(core::one_line(text, max_length));
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
