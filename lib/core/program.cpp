#include "core/program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
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

}  // namespace

ProgramEnd run_program(const ProgramCall& call, std::string_view place) {
    const Stream input = scratch(place), errors = scratch(place);
    const bool empty = call.input.empty();   // and then perhaps without an address
    if ((!empty && std::fwrite(call.input.data(), 1, call.input.size(), input.get()) != call.input.size()) ||
        std::fflush(input.get()) != 0)
        throw Error(ExitCode::io_error, place,
                    "the input of " + call.name + " cannot be written: " + std::strerror(errno));
    std::rewind(input.get());

    Redirections redirect;
    redirect.onto(::fileno(input.get()), STDIN_FILENO);
    if (call.output < 0)
        redirect.drop(STDOUT_FILENO);
    else
        redirect.onto(call.output, STDOUT_FILENO);
    redirect.onto(::fileno(errors.get()), STDERR_FILENO);

    std::vector<std::string> words{call.name};
    words.insert(words.end(), call.arguments.begin(), call.arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    pid_t child = 0;
    const int failure =
        ::posix_spawnp(&child, words.front().c_str(), &redirect.actions, nullptr, pointers.data(), environ);
    if (failure == ENOENT)
        throw Error(ExitCode::cannot_create, place,
                    "the program " + call.name + ", which " + call.purpose + ", is not installed", call.remedy);
    if (failure != 0)
        throw Error(ExitCode::cannot_create, place, call.name + " cannot be started: " + std::strerror(failure));

    const int status = wait_for(child);
    return {WIFEXITED(status) && WEXITSTATUS(status) == 0, beginning_of(errors.get())};
}

}  // namespace soft::core
