#include "core/subprocess.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <new>

namespace soft::core {
namespace {

constexpr int exit_failed = 1, exit_out_of_memory = 2;  // exit codes of the child

/// Private writable memory of the process as the kernel counts it for RLIMIT_DATA (proc(5), statm: data + stack).
std::size_t data_bytes() {
    std::ifstream file("/proc/self/statm");
    std::array<std::size_t, 6> pages{};
    for (std::size_t& number : pages) file >> number;
    return pages.back() * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

void set_limit(int what, std::size_t max_value) {
    rlimit limit{};
    ::getrlimit(static_cast<__rlimit_resource>(what), &limit);
    limit.rlim_cur = std::min<rlim_t>(max_value, limit.rlim_max);
    ::setrlimit(static_cast<__rlimit_resource>(what), &limit);
}

/// Runs in the child and never returns. It skips exit handlers, because some libraries crash in them.
[[noreturn]] void run_child(const std::function<Bytes()>& work, const SubprocessLimits& limits, int out) {
    set_limit(RLIMIT_CORE, 0);
    if (limits.processor) set_limit(RLIMIT_CPU, static_cast<std::size_t>(limits.processor->count()));
    if (limits.memory != no_limit) set_limit(RLIMIT_DATA, data_bytes() + limits.memory);
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL, SIGXCPU})
        std::signal(signal, SIG_DFL);  // suppress the crash reports of libraries
    if (const int null_device = ::open("/dev/null", O_WRONLY); null_device >= 0) {
        ::dup2(null_device, STDOUT_FILENO);
        ::dup2(null_device, STDERR_FILENO);
    }
    try {
        const Bytes result = work();
        if (write_all(out, result, "") != WriteStatus::complete) ::_exit(exit_failed);
    } catch (const std::bad_alloc&) {
        ::_exit(exit_out_of_memory);
    } catch (...) {  // libraries also throw types other than std::exception; the caller reports the failure
        ::_exit(exit_failed);
    }
    ::_exit(0);
}

std::string reason_of(int status) {
    if (WIFEXITED(status))
        return WEXITSTATUS(status) == exit_out_of_memory ? "it exceeds the memory limit" : "it fails";
    if (WTERMSIG(status) == SIGXCPU) return "it exceeds the time limit";
    return std::string{"it crashes ("} + ::strsignal(WTERMSIG(status)) + ")";
}

}  // namespace

SubprocessOutcome run_in_subprocess(const std::function<Bytes()>& work, const SubprocessLimits& limits) {
    std::array<int, 2> pipe{};
    const bool piped = ::pipe(pipe.data()) == 0;
    const pid_t child = piped ? ::fork() : -1;
    if (child < 0)
        throw Error(ExitCode::internal, "subprocess", std::string{"cannot be created: "} + std::strerror(errno));
    if (child == 0) {
        ::close(pipe[0]);
        run_child(work, limits, pipe[1]);
    }
    ::close(pipe[1]);
    const auto deadline = std::chrono::steady_clock::now() + limits.wall;
    Bytes bytes;
    Bytes chunk(1 << 16);
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
    if (!ended) return {std::nullopt, "it exceeds the time limit"};
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return {std::nullopt, reason_of(status)};
    return {std::move(bytes), {}};
}

}  // namespace soft::core
