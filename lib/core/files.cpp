#include "core/files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>
#include <utility>

#include "core/text.hpp"

namespace soft::core {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) { return std::generic_category().message(error); }

/// File names may contain any character; messages show them on one line.
std::string printable(const fs::path& path) {
    constexpr std::size_t max_length = 4096;  // PATH_MAX
    return one_line(path.string(), max_length);
}

/// Closes the descriptor on destruction. The result is ignored: a failed close after reading loses no data.
class Descriptor {
public:
    explicit Descriptor(int value) noexcept : value_(value) {}
    ~Descriptor() {
        if (value_ >= 0) ::close(value_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    [[nodiscard]] int get() const noexcept { return value_; }

private:
    int value_;
};

/// Size of a regular file; 0 for anything whose length is not known in advance.
std::size_t expected_size(int descriptor) noexcept {
    struct stat status {};
    if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return 0;
    return static_cast<std::size_t>(std::max<off_t>(status.st_size, 0));
}

/// Path by which an open unnamed file can be linked.
std::string descriptor_path(int descriptor) { return "/proc/self/fd/" + std::to_string(descriptor); }

/// Target of a chain of symbolic links, whether or not it exists. A file created through a link is created at its target, as with
/// shell redirection.
fs::path link_target(fs::path path) {
    constexpr int max_links = 40;  // the kernel's limit
    std::error_code failed;
    for (int links = 0; links < max_links && fs::is_symlink(path, failed); ++links)
        path = path.parent_path() / fs::read_symlink(path, failed);
    return path;
}

/// Prefix of a temporary file name in the folder of `target`, short enough to append a suffix.
std::string temporary_stem(const fs::path& target) {
    constexpr std::size_t max_length = 200;  // bytes; a file name may have 255
    const fs::path name = target.filename().string().substr(0, max_length);
    return (target.has_parent_path() ? target.parent_path() / name : name).string();
}

mode_t mode_for_new_file() noexcept {
    const mode_t mask = ::umask(0);  // the mask can be read only by setting it
    ::umask(mask);
    return static_cast<mode_t>(0666 & ~mask);
}

}  // namespace

Bytes read_descriptor(int descriptor, std::string_view name, std::size_t limit, std::string_view signature) {
    constexpr std::size_t chunk = std::size_t{1} << 16;
    Bytes bytes;
    // One byte more than expected, so that the end of a file of known size is detected without growing the buffer.
    bytes.resize(std::max(chunk, std::min(expected_size(descriptor), limit) + 1));
    std::size_t filled = 0;
    while (true) {
        if (filled == bytes.size()) bytes.resize(bytes.size() * 2);
        const ssize_t got = ::read(descriptor, bytes.data() + filled, bytes.size() - filled);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0 && errno == EISDIR) throw Error(ExitCode::cannot_open, name, "is a folder", "name a file");
        if (got < 0) throw Error(ExitCode::io_error, name, "cannot be read: " + reason(errno));
        if (got == 0) break;
        filled += static_cast<std::size_t>(got);
        if (!signature.empty() && filled >= signature.size() &&
            std::memcmp(bytes.data(), signature.data(), signature.size()) != 0)
            break;
        if (filled > limit) throw Error(ExitCode::bad_input, name, "longer than " + std::to_string(limit) + " bytes");
    }
    bytes.resize(filled);
    return bytes;
}

Bytes read_file(const fs::path& path, std::size_t limit, std::string_view signature) {
    const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
    if (file.get() < 0) throw Error(ExitCode::cannot_open, printable(path), "cannot be opened: " + reason(errno));
    return read_descriptor(file.get(), printable(path), limit, signature);
}

Bytes read_regular_file(const fs::path& path, std::size_t limit) {
    // Without O_NONBLOCK, opening a named pipe would block until a writer opens it.
    const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)};
    if (file.get() < 0) throw Error(ExitCode::cannot_open, printable(path), "cannot be opened: " + reason(errno));
    struct stat status {};
    if (::fstat(file.get(), &status) != 0 || !(S_ISREG(status.st_mode) || S_ISDIR(status.st_mode)))
        throw Error(ExitCode::cannot_open, printable(path), "is a device or a pipe", "name a file");
    return read_descriptor(file.get(), printable(path), limit);
}

WriteStatus write_all(int descriptor, std::span<const std::byte> bytes, std::string_view name) {
    while (!bytes.empty()) {
        const ssize_t put = ::write(descriptor, bytes.data(), bytes.size());
        if (put < 0 && errno == EINTR) continue;
        if (put < 0 && errno == EPIPE) return WriteStatus::reader_closed;
        if (put < 0) throw Error(ExitCode::io_error, name, "cannot be written: " + reason(errno));
        bytes = bytes.subspan(static_cast<std::size_t>(put));
    }
    return WriteStatus::complete;
}

AtomicFile::AtomicFile(const fs::path& path) : name_(printable(path)), target_(path) {
    struct stat status {};
    const bool exists = ::stat(target_.c_str(), &status) == 0;
    if (!exists && (errno == ENAMETOOLONG || errno == ELOOP))
        throw Error(ExitCode::cannot_create, name_, "cannot be created: " + reason(errno));
    if (exists && S_ISDIR(status.st_mode)) throw Error(ExitCode::cannot_create, name_, "is a folder", "name a file");
    renames_ = !exists || S_ISREG(status.st_mode);
    // /dev/stdout is a link as well, but its target need not have a path.
    if (renames_) target_ = link_target(path);
    if (!renames_) {
        written_ = target_;
        descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    } else {
        descriptor_ = open_beside_target();
    }
    if (descriptor_ < 0) throw Error(ExitCode::cannot_create, name_, "cannot be created: " + reason(errno));
    // Temporary files are private to their owner; a file that replaces another one takes over its permissions.
    if (renames_) static_cast<void>(::fchmod(descriptor_, exists ? status.st_mode & 07777 : mode_for_new_file()));
}

AtomicFile::~AtomicFile() { discard(); }

int AtomicFile::open_beside_target() {
#ifdef O_TMPFILE
    const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path{"."};
    const int unnamed = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600);
    if (unnamed >= 0 && ::access(descriptor_path(unnamed).c_str(), F_OK) == 0) return unnamed;
    if (unnamed >= 0) ::close(unnamed);  // without /proc it cannot be given a name
#endif
    std::string pattern = temporary_stem(target_) + ".XXXXXX";
    const int named = ::mkostemp(pattern.data(), O_CLOEXEC);
    written_ = pattern;
    return named;
}

/// Links the unnamed file at the target, or under a temporary name where a file exists, which linkat cannot replace. Returns errno, or 0.
int AtomicFile::link_unnamed() {
    const auto link = [&](const fs::path& name) {
        return ::linkat(AT_FDCWD, descriptor_path(descriptor_).c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
    };
    if (link(target_)) {
        renames_ = false;
        return 0;
    }
    for (int attempt = 0;; ++attempt) {
        const fs::path name =
            temporary_stem(target_) + "." + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".tmp";
        if (link(name)) {
            written_ = name;
            return 0;
        }
        if (errno != EEXIST) return errno;
    }
}

WriteStatus AtomicFile::write(std::span<const std::byte> bytes) { return write_all(descriptor_, bytes, name_); }

void AtomicFile::commit() {
    // Closing reports failures of delayed writes. A duplicate is closed, so that only the rename follows the link. Signals to this
    // thread wait until both are done; a process that ends between them, where it replaces a file, leaves the temporary name.
    int error = ::close(::dup(descriptor_)) == 0 ? 0 : errno;
    sigset_t all, before;
    sigfillset(&all);
    ::pthread_sigmask(SIG_BLOCK, &all, &before);
    if (error == 0 && written_.empty()) error = link_unnamed();
    if (error == 0 && renames_ && ::rename(written_.c_str(), target_.c_str()) != 0) error = errno;
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
    ::close(std::exchange(descriptor_, -1));
    if (error == 0) return;
    if (renames_ && !written_.empty()) ::unlink(written_.c_str());
    throw Error(ExitCode::io_error, name_, "cannot be written: " + reason(error));
}

void AtomicFile::discard() noexcept {
    if (descriptor_ < 0) return;
    ::close(std::exchange(descriptor_, -1));
    if (renames_ && !written_.empty()) ::unlink(written_.c_str());
}

}  // namespace soft::core
