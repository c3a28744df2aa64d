#include "core/program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

#include "core/error.hpp"

extern char** environ;  // POSIX leaves the declaration to the program

namespace soft::core {
namespace {

struct CloseFile {
    void operator()(std::FILE* stream) const noexcept { std::fclose(stream); }
};
using Stream = std::unique_ptr<std::FILE, CloseFile>;

/// A nameless file that is gone when closed. The child reads its input from one and complains into another: unlike
/// pipes they cannot fill up, and a child that dies early raises no SIGPIPE here.
Stream scratch(std::string_view place) {
    Stream stream{std::tmpfile()};
    if (!stream) throw Error(ExitCode::cannot_create, place, std::string("no temporary file: ") + std::strerror(errno));
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
    void drop(int to) { posix_spawn_file_actions_addopen(&actions, to, "/dev/null", O_WRONLY, 0); }
};

int wait_for(pid_t child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return -1;
    return status;
}

std::string beginning_of(std::FILE* stream) {
    std::rewind(stream);
    std::array<char, 4096> buffer{};
    return {buffer.data(), std::fread(buffer.data(), 1, buffer.size(), stream)};
}

/// The environment without what the call drops; ends with a null pointer.
std::vector<char*> environment_of(const ProgramCall& call) {
    std::vector<char*> kept;
    for (char** variable = environ; variable != nullptr && *variable != nullptr; ++variable) {
        const std::string_view text{*variable};
        if (std::ranges::none_of(call.dropped_variables, [&](std::string_view name) { return text.starts_with(name); }))
            kept.push_back(*variable);
    }
    kept.push_back(nullptr);
    return kept;
}

/// A program at work: its input handed over, its complaints collected.
struct Started {
    pid_t child;
    Stream errors;
};

Started start(const ProgramCall& call, int output, std::string_view place) {
    const Stream input = scratch(place);
    Stream errors = scratch(place);
    const bool empty = call.input.empty();  // and then perhaps without an address
    if ((!empty && std::fwrite(call.input.data(), 1, call.input.size(), input.get()) != call.input.size()) ||
        std::fflush(input.get()) != 0)
        throw Error(ExitCode::io_error, place,
                    "the input of " + call.name + " cannot be written: " + std::strerror(errno));
    std::rewind(input.get());

    Redirections redirect;
    redirect.onto(::fileno(input.get()), STDIN_FILENO);
    if (output < 0)
        redirect.drop(STDOUT_FILENO);
    else
        redirect.onto(output, STDOUT_FILENO);
    redirect.onto(::fileno(errors.get()), STDERR_FILENO);

    std::vector<std::string> words{call.name};
    words.insert(words.end(), call.arguments.begin(), call.arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    std::vector<char*> environment = environment_of(call);
    pid_t child = 0;
    const int failure =
        ::posix_spawnp(&child, words.front().c_str(), &redirect.actions, nullptr, pointers.data(), environment.data());
    if (failure == ENOENT)
        throw Error(ExitCode::cannot_create, place,
                    "the program " + call.name + ", which " + call.purpose + ", is not installed", call.remedy);
    if (failure != 0)
        throw Error(ExitCode::cannot_create, place, call.name + " cannot be started: " + std::strerror(failure));
    return {child, std::move(errors)};
}

ProgramEnd end_of(const Started& program) {
    const int status = wait_for(program.child);
    return {WIFEXITED(status) && WEXITSTATUS(status) == 0, beginning_of(program.errors.get())};
}

/// Both ends stay with this process: a writing end in the child besides its stdout would keep the pipe open.
class Pipe {
public:
    explicit Pipe(std::string_view place) {
        if (::pipe(ends_.data()) != 0)
            throw Error(ExitCode::cannot_create, place, std::string("no pipe: ") + std::strerror(errno));
        for (const int end : ends_) static_cast<void>(::fcntl(end, F_SETFD, FD_CLOEXEC));
    }
    ~Pipe() {
        close_writer();
        ::close(ends_[0]);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    [[nodiscard]] int reader() const noexcept { return ends_[0]; }
    [[nodiscard]] int writer() const noexcept { return ends_[1]; }
    void close_writer() noexcept {
        if (ends_[1] >= 0) ::close(std::exchange(ends_[1], -1));
    }

private:
    std::array<int, 2> ends_{};
};

}  // namespace

ProgramEnd run_program(const ProgramCall& call, std::string_view place) {
    return end_of(start(call, call.output, place));
}

ProgramOutput program_output(const ProgramCall& call, std::string_view place) {
    Pipe pipe(place);
    const Started program = start(call, pipe.writer(), place);
    pipe.close_writer();  // so that the end of the program is the end of the stream
    ProgramOutput result;
    result.bytes = read_descriptor(pipe.reader(), place);
    result.end = end_of(program);
    return result;
}

}  // namespace soft::core
