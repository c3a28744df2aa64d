#include "post/gnuplot.hpp"

#include <utility>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/program.hpp"
#include "core/text.hpp"

namespace soft::post {
namespace {

/// gnuplot's complaint as one line: the text behind the caret it draws, or all of a short message.
std::string reason(std::string text) {
    if (const auto caret = text.find("^\n"); caret != std::string::npos) text.erase(0, caret + 2);
    const auto words = core::trimmed(text);
    return words.empty() ? "it gave no reason" : core::one_line(words.substr(0, words.find('\n')));
}

}  // namespace

core::Bytes gnuplot_bytes(std::string_view script, std::string_view place) {
    core::ProgramOutput drawn = core::program_output(
        {.name = "gnuplot",
         .arguments = {},
         .input = script,
         .purpose = "draws the picture",
         .remedy = "install the package gnuplot-nox (Debian, Ubuntu) or gnuplot (Fedora, Homebrew)"},
        place);
    if (!drawn.end.well || drawn.bytes.empty())
        throw Error(ExitCode::cannot_create, place, "gnuplot failed: " + reason(drawn.end.complaint));
    return std::move(drawn.bytes);
}

void run_gnuplot(std::string_view script, const std::filesystem::path& file) {
    const core::Bytes picture = gnuplot_bytes(script, file.string());
    core::AtomicFile target(file);  // only now: whatever ends the program before leaves no temporary file
    static_cast<void>(target.write(picture));
    target.commit();
}

std::string gnuplot_output(std::string_view script, std::string_view place) {
    const core::Bytes bytes = gnuplot_bytes(script, place);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace soft::post
