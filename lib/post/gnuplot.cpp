#include "post/gnuplot.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

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

/// Script in, picture into the descriptor of a file.
void draw(const std::string& script, int descriptor, std::string_view place) {
    const core::ProgramEnd end =
        core::run_program({.name = "gnuplot",
                           .arguments = {},
                           .input = script,
                           .output = descriptor,
                           .purpose = "draws the picture",
                           .remedy = "install the package gnuplot-nox (Debian, Ubuntu) or gnuplot (Fedora, Homebrew)"},
                          place);
    if (!end.well || ::lseek(descriptor, 0, SEEK_END) <= 0)
        throw Error(ExitCode::cannot_create, place, "gnuplot failed: " + reason(end.complaint));
}

struct CloseFile {
    void operator()(std::FILE* stream) const noexcept { std::fclose(stream); }
};

}  // namespace

void run_gnuplot(const std::string& script, const std::filesystem::path& file) {
    core::AtomicFile picture(file);
    draw(script, picture.descriptor(), file.string());
    picture.commit();
}

std::string gnuplot_output(const std::string& script, std::string_view place) {
    const std::unique_ptr<std::FILE, CloseFile> scratch{std::tmpfile()};  // nameless: gone when closed
    if (!scratch)
        throw Error(ExitCode::cannot_create, place, std::string("no temporary file: ") + std::strerror(errno));
    draw(script, ::fileno(scratch.get()), place);
    std::rewind(scratch.get());
    const core::Bytes bytes = core::read_descriptor(::fileno(scratch.get()), place);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace soft::post
