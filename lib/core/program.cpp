#include "core/program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>
#include <vector>

#include "core/error.hpp"

extern char** environ;  // POSIX leaves the declaration to the program

namespace soft::core {
namespace {

/// The list of redirections of posix_spawn (RAII).
struct Redirections {
    posix_spawn_file_actions_t actions;
    Redirections() { posix_spawn_file_actions_init(&actions); }
    ~Redirections() { posix_spawn_file_actions_destroy(&actions); }
    Redirections(const Redirections&) = delete;
    Redirections& operator=(const Redirections&) = delete;
    void onto(int from, int to) { posix_spawn_file_actions_adddup2(&actions, from, to); }
    void discard(int to) { posix_spawn_file_actions_addopen(&actions, to, "/dev/null", O_WRONLY, 0); }
};

int wait_for(pid_t child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return -1;
    return status;
}

std::string read_beginning(std::FILE* stream) {
    std::rewind(stream);
    std::array<char, 4096> buffer{};
    return {buffer.data(), std::fread(buffer.data(), 1, buffer.size(), stream)};
}

/// The environment without the dropped variables of the call, terminated by a null pointer.
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

/// A running program and the file that collects its standard error.
struct RunningProgram {
    pid_t child;
    Stream errors;
};

/// The program reads its input from a file and writes its errors to another. Unlike pipes they cannot fill up, and a program that ends
/// early raises no SIGPIPE in this process.
RunningProgram start_program(const ProgramCall& call, int output, std::string_view location) {
    const Stream input = temporary_file(location);
    Stream errors = temporary_file(location);
    const bool empty = call.input.empty();  // data() may then be null, which fwrite does not accept
    if ((!empty && std::fwrite(call.input.data(), 1, call.input.size(), input.get()) != call.input.size()) ||
        std::fflush(input.get()) != 0)
        throw Error(ExitCode::io_error, location,
                    "the input of " + call.name + " cannot be written: " + std::strerror(errno));
    std::rewind(input.get());

    Redirections redirect;
    redirect.onto(::fileno(input.get()), STDIN_FILENO);
    if (output < 0)
        redirect.discard(STDOUT_FILENO);
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
        throw Error(ExitCode::cannot_create, location,
                    "the program " + call.name + ", which " + call.purpose + ", is not installed", call.remedy);
    if (failure != 0)
        throw Error(ExitCode::cannot_create, location, call.name + " cannot be started: " + std::strerror(failure));
    return {child, std::move(errors)};
}

ProgramStatus wait_for_program(const RunningProgram& program) {
    const int status = wait_for(program.child);
    return {WIFEXITED(status) && WEXITSTATUS(status) == 0, read_beginning(program.errors.get())};
}

/// Both ends are close-on-exec: a second writing end, in the child or in one that another thread starts, would keep the pipe open.
class Pipe {
public:
    explicit Pipe(std::string_view location) {
        if (::pipe2(ends_.data(), O_CLOEXEC) != 0)
            throw Error(ExitCode::cannot_create, location,
                        std::string("cannot create a pipe: ") + std::strerror(errno));
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

Stream temporary_file(std::string_view location) {
    Stream stream{std::tmpfile()};
    if (!stream)
        throw Error(ExitCode::cannot_create, location,
                    std::string("cannot create a temporary file: ") + std::strerror(errno));
    return stream;
}

ProgramStatus run_program(const ProgramCall& call, std::string_view location) {
    return wait_for_program(start_program(call, call.output, location));
}

ProgramOutput capture_program_output(const ProgramCall& call, std::string_view location) {
    Pipe pipe(location);
    const RunningProgram program = start_program(call, pipe.writer(), location);
    pipe.close_writer();  // so that the stream ends when the program exits
    ProgramOutput result;
    result.bytes = read_descriptor(pipe.reader(), location);
    result.status = wait_for_program(program);
    return result;
}

}  // namespace soft::core
