#include "interrupt.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstring>

#include "core/text.hpp"

namespace soft::cli {
namespace {

/// A signal handler may use only lock-free static data. set() writes the line to the slot that is not in use, then switches slots.
struct Line {
    std::array<char, 8192> text{};
    std::size_t size = 0;
};
std::array<Line, 2> slots;
std::atomic<int> slot_in_use{0};
static_assert(std::atomic<int>::is_always_lock_free);

constexpr std::array<int, 2> handled{SIGINT, SIGTERM};

extern "C" void print_and_end(int signal) {
    const Line& line = slots[static_cast<std::size_t>(slot_in_use.load())];
    static_cast<void>(!::write(STDERR_FILENO, line.text.data(), line.size));
    ::raise(signal);  // SA_RESETHAND has restored the default action: the process ends when the handler returns
}

}  // namespace

InterruptNotice::InterruptNotice(std::string_view tool, Verbosity verbosity)
    : tool_(tool), active_(verbosity != Verbosity::quiet) {
    if (!active_) return;
    for (const int signal : handled) {
        struct sigaction before {
        }, notice{};
        notice.sa_handler = print_and_end;
        notice.sa_flags = static_cast<int>(SA_RESETHAND);
        if (::sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_DFL)
            ::sigaction(signal, &notice, nullptr);
    }
}

InterruptNotice::~InterruptNotice() {
    if (!active_) return;
    for (const int signal : handled) {
        struct sigaction now {};
        if (::sigaction(signal, nullptr, &now) == 0 && now.sa_handler == print_and_end)
            static_cast<void>(std::signal(signal, SIG_DFL));
    }
}

void InterruptNotice::set(std::string_view line) {
    if (!active_) return;
    const int free = 1 - slot_in_use.load();
    Line& slot = slots[static_cast<std::size_t>(free)];
    // Clear the progress bar first.
    const std::string text = (::isatty(STDERR_FILENO) == 1 ? "\r\033[K" : "") + tool_ + ": interrupted; " +
                             core::one_line(line, slot.text.size() / 2) + "\n";
    slot.size = std::min(text.size(), slot.text.size());
    std::memcpy(slot.text.data(), text.data(), slot.size);
    slot_in_use.store(free);
}

std::string interrupted_text(const std::string& output, int rows, std::string_view obstacle) {
    if (output == "-") return "no row is saved; with -o FILE each row is saved as soon as it is computed";
    if (rows == 0) return "no row was computed yet; " + output + " is unchanged";
    const std::string saved = output + " contains " + core::counted(rows, "row") + ": ";
    if (!obstacle.empty()) return saved + "`postprocess " + output + "` reads them; " + std::string{obstacle};
    return saved + "`solve --resume " + output + "` continues, `postprocess " + output + "` reads them";
}

}  // namespace soft::cli
