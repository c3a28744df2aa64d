#include "post/gnuplot.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/text.hpp"

extern char** environ;  // POSIX leaves the declaration to the program

namespace soft::post {
namespace {

struct CloseFile {
    void operator()(std::FILE* stream) const noexcept { std::fclose(stream); }
};
using Stream = std::unique_ptr<std::FILE, CloseFile>;

/// A nameless file that is gone when closed. The child reads the script from one and complains into another: unlike
/// pipes they cannot fill up, and a child that dies early raises no SIGPIPE here.
Stream scratch() {
    Stream stream{std::tmpfile()};
    if (!stream)
        throw Error(ExitCode::cannot_create, "--plot", std::string("no temporary file: ") + std::strerror(errno));
    return stream;
}

/// posix_spawn's list of redirections, freed on every way out.
struct Redirections {
    posix_spawn_file_actions_t actions;
    Redirections() { posix_spawn_file_actions_init(&actions); }
    ~Redirections() { posix_spawn_file_actions_destroy(&actions); }
    Redirections(const Redirections&) = delete;
    Redirections& operator=(const Redirections&) = delete;
    void onto(int from, int to) { posix_spawn_file_actions_adddup2(&actions, from, to); }
};

int wait_for(pid_t child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return -1;
    return status;
}

/// gnuplot's complaint as one line: the text behind the caret it draws, or all of a short message.
std::string complaint(std::FILE* stream) {
    std::rewind(stream);
    std::array<char, 2048> buffer{};
    std::string text{buffer.data(), std::fread(buffer.data(), 1, buffer.size(), stream)};
    if (const auto caret = text.find("^\n"); caret != std::string::npos) text.erase(0, caret + 2);
    const auto words = core::trimmed(text);
    return words.empty() ? "it gave no reason" : core::one_line(words.substr(0, words.find('\n')));
}

}  // namespace

void run_gnuplot(const std::string& script, const std::filesystem::path& file) {
    const Stream input = scratch(), errors = scratch();
    if (std::fwrite(script.data(), 1, script.size(), input.get()) != script.size() || std::fflush(input.get()) != 0)
        throw Error(ExitCode::io_error, "--plot", std::string("the script cannot be written: ") + std::strerror(errno));
    std::rewind(input.get());

    core::AtomicFile picture(file);
    Redirections redirect;
    redirect.onto(::fileno(input.get()), STDIN_FILENO);
    redirect.onto(picture.descriptor(), STDOUT_FILENO);
    redirect.onto(::fileno(errors.get()), STDERR_FILENO);
    std::array<char, 8> program{"gnuplot"};
    std::array<char*, 2> arguments{program.data(), nullptr};
    pid_t child = 0;
    const int failure = ::posix_spawnp(&child, program.data(), &redirect.actions, nullptr, arguments.data(), environ);
    if (failure == ENOENT)
        throw Error(ExitCode::cannot_create, file.string(),
                    "the program gnuplot, which draws the picture, is not installed",
                    "install the package gnuplot-nox (Debian, Ubuntu) or gnuplot (Fedora, Homebrew)");
    if (failure != 0)
        throw Error(ExitCode::cannot_create, file.string(),
                    std::string("gnuplot cannot be started: ") + std::strerror(failure));

    const int status = wait_for(child);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || ::lseek(picture.descriptor(), 0, SEEK_END) <= 0)
        throw Error(ExitCode::cannot_create, file.string(), "gnuplot failed: " + complaint(errors.get()));
    picture.commit();
}

}  // namespace soft::post
