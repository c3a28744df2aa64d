#include "meshing/apart.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>

#include "core/error.hpp"

namespace soft::meshing {
namespace {

/// Of the child: never returns, and runs no handler of exit, in which the CAD library crashes.
[[noreturn]] void work_and_leave(const std::function<std::vector<double>()>& work, int out) {
    constexpr int failed = 1;
    const rlimit no_core{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL})
        std::signal(signal, SIG_DFL);  // no report of a library's crash
    if (const int nowhere = ::open("/dev/null", O_WRONLY); nowhere >= 0) {
        ::dup2(nowhere, STDOUT_FILENO);
        ::dup2(nowhere, STDERR_FILENO);
    }
    try {
        const std::vector<double> result = work();
        const char* at = reinterpret_cast<const char*>(result.data());
        for (std::size_t left = result.size() * sizeof(double); left > 0;) {
            const ssize_t written = ::write(out, at, left);
            if (written < 0) ::_exit(failed);
            at += written;
            left -= static_cast<std::size_t>(written);
        }
    } catch (...) {  // gmsh also throws strings; the caller says that it has failed
        ::_exit(failed);
    }
    ::_exit(0);
}

}  // namespace

std::optional<std::vector<double>> done_apart(const std::function<std::vector<double>()>& work,
                                              std::chrono::seconds limit) {
    std::array<int, 2> pipe{};
    const bool piped = ::pipe(pipe.data()) == 0;
    const pid_t child = piped ? ::fork() : -1;
    if (child < 0)
        throw Error(ExitCode::internal, "a process of its own", std::string{"cannot be made: "} + std::strerror(errno));
    if (child == 0) {
        ::close(pipe[0]);
        work_and_leave(work, pipe[1]);
    }
    ::close(pipe[1]);
    const auto deadline = std::chrono::steady_clock::now() + limit;
    std::vector<char> bytes;
    std::vector<char> chunk(1 << 16);
    bool ended = false;
    while (!ended) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now()).count();
        pollfd watched{pipe[0], POLLIN, 0};
        const int ready = left > 0 ? ::poll(&watched, 1, static_cast<int>(left)) : 0;
        if (ready == 0) break;  // out of time
        if (ready < 0 && errno == EINTR) continue;
        const ssize_t got = ::read(pipe[0], chunk.data(), chunk.size());
        if (got > 0) bytes.insert(bytes.end(), chunk.begin(), chunk.begin() + got);
        ended = got == 0 || (got < 0 && errno != EINTR);
    }
    ::close(pipe[0]);
    if (!ended) ::kill(child, SIGKILL);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {}
    if (!ended || !WIFEXITED(status) || WEXITSTATUS(status) != 0) return std::nullopt;
    std::vector<double> result(bytes.size() / sizeof(double));
    if (!result.empty()) std::memcpy(result.data(), bytes.data(), result.size() * sizeof(double));
    return result;
}

}  // namespace soft::meshing
