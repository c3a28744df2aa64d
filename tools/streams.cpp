#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "cli.hpp"
#include "core/text.hpp"

namespace soft::cli {
namespace {

void to_stderr(std::string_view text) {
    static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
    std::fflush(stderr);
}

/// Open MPI gives each rank a pseudo-terminal as stdout and forwards the bytes unchanged; the stdout of the launcher decides.
bool writes_to_terminal() {
    if (::isatty(STDOUT_FILENO) != 1) return false;
    if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr) return true;
    std::error_code unknown;
    const auto target = std::filesystem::read_symlink("/proc/" + std::to_string(::getppid()) + "/fd/1", unknown);
    return unknown || target.string().starts_with("/dev/pts/") || target.string().starts_with("/dev/tty");
}

bool wants_colour(bool terminal) {
    const char* no_colour = std::getenv("NO_COLOR");  // https://no-color.org: any non-empty text
    return terminal && (no_colour == nullptr || *no_colour == '\0');
}

}  // namespace

Input read_input(const std::string& name, std::size_t limit, std::string_view signature) {
    if (!name.empty() && name != "-") return {core::read_file(name, limit, signature), name};
    if (name.empty() && ::isatty(STDIN_FILENO) == 1)
        throw Error(ExitCode::usage, "", "no input is given and stdin is a terminal", "give a file, or use a pipe");
    return {core::read_descriptor(STDIN_FILENO, "<stdin>", limit, signature), "<stdin>"};
}

Input read_design(const std::string& name) {
    namespace fs = std::filesystem;
    std::error_code failed;
    const fs::path program = fs::read_symlink("/proc/self/exe", failed);
    const fs::path installed = program.parent_path().parent_path() / "share" / "soft-actuator" / name;
    const bool is_installed = !name.empty() && !fs::exists(name, failed) && fs::is_regular_file(installed, failed);
    return read_input(is_installed ? installed.string() : name, max_design_bytes);
}

bool stdout_is_file() {
    struct stat status {};
    return ::fstat(STDOUT_FILENO, &status) == 0 && S_ISREG(status.st_mode);
}

void check_output(const std::string& name, Content content) {
    std::error_code failed;
    // A temporary file, removed at once; a device or a named pipe is not touched.
    if (name != "-" && !std::filesystem::is_other(name, failed)) core::AtomicFile{name};
    if (name == "-" && content == Content::binary && writes_to_terminal())
        throw Error(ExitCode::usage, "<stdout>", "binary data is not written to a terminal", "use -o FILE or a pipe");
}

void write_output(const std::string& name, std::span<const std::byte> bytes, Content content) {
    if (name == "-") {
        check_output(name, content);
        static_cast<void>(core::write_all(STDOUT_FILENO, bytes, "<stdout>"));
        return;
    }
    core::AtomicFile file{name};
    static_cast<void>(file.write(bytes));
    file.commit();
}

void write_output(const std::string& name, std::string_view text) {
    write_output(name, std::as_bytes(std::span{text}), Content::text);
}

void make_folder(const std::string& name) {
    std::error_code failed;
    std::filesystem::create_directories(name, failed);
    if (failed) throw Error(ExitCode::cannot_create, name, "cannot be created: " + failed.message());
}

void write_json(const std::string& name, const nlohmann::ordered_json& json) {
    // File names may contain invalid UTF-8, which JSON does not allow.
    constexpr int indent = 2;
    write_output(name, json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

StdoutRedirection::StdoutRedirection() : saved_(::dup(STDOUT_FILENO)) {
    if (saved_ >= 0) static_cast<void>(::dup2(STDERR_FILENO, STDOUT_FILENO));
}

StdoutRedirection::~StdoutRedirection() {
    if (saved_ < 0) return;
    std::fflush(stdout);
    static_cast<void>(::dup2(saved_, STDOUT_FILENO));
    static_cast<void>(::close(saved_));
}

Console::Console(std::string_view tool, Verbosity verbosity)
    : tool_(tool), verbosity_(verbosity), terminal_(::isatty(STDERR_FILENO) == 1), colour_(wants_colour(terminal_)) {}

Console::~Console() { clear_bar(); }

void Console::put(std::string_view label, std::string_view line) {
    clear_bar();
    to_stderr(tool_ + ": " + std::string{label} + core::one_line(line, std::string_view::npos) + "\n");
}

std::string_view Console::warning_label() const { return colour_ ? "\033[33mwarning\033[0m: " : "warning: "; }

void Console::say(std::string_view line) {
    if (verbosity_ != Verbosity::quiet) error(line);
}

void Console::detail(std::string_view line) {
    if (verbosity_ == Verbosity::verbose) say(line);
}

void Console::warn(std::string_view line) {
    if (verbosity_ != Verbosity::quiet) warn_always(line);
}

void Console::warn_always(std::string_view line) { put(warning_label(), line); }

void Console::error(std::string_view line) { put("", line); }

void Console::progress(double share, std::string_view text) {
    if (verbosity_ == Verbosity::quiet) return;
    share = std::clamp(std::isfinite(share) ? share : 0.0, 0.0, 1.0);
    if (terminal_) {
        constexpr int width = 24;
        const int done = static_cast<int>(std::lround(share * width));
        const std::string bar =
            std::string(static_cast<std::size_t>(done), '#') + std::string(static_cast<std::size_t>(width - done), '.');
        to_stderr("\r\033[K" + tool_ + ": [" + bar + "] " + core::one_line(text, 80));
        bar_shown_ = true;
        return;
    }
    const int tenths = static_cast<int>(share * 10);
    if (tenths == tenths_) return;
    tenths_ = tenths;
    say(std::to_string(tenths * 10) + " % " + std::string{text});
}

void Console::clear_bar() {
    if (bar_shown_) to_stderr("\r\033[K");
    bar_shown_ = false;
}

}  // namespace soft::cli
