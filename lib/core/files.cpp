#include "core/files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "core/text.hpp"

namespace soft::core {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) { return std::generic_category().message(error); }

/// A name may hold any character; in a message it keeps to one line.
std::string shown(const fs::path& path) {
    constexpr std::size_t longest = 4096;  // PATH_MAX
    return one_line(path.string(), longest);
}

/// Closes on the way out; a failed close of something only read tells nothing.
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

/// Size of a regular file, 0 for everything whose length is not known beforehand.
std::size_t expected_size(int descriptor) noexcept {
    struct stat status {};
    if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return 0;
    return static_cast<std::size_t>(std::max<off_t>(status.st_size, 0));
}

/// The only way to an open file without a name.
std::string own_link(int descriptor) { return "/proc/self/fd/" + std::to_string(descriptor); }

/// Where a chain of symbolic links leads, also where nothing is there: what is made through a link is made there, as by a shell's
/// redirection.
fs::path link_target(fs::path path) {
    constexpr int longest_chain = 40;  // the kernel's limit
    std::error_code failed;
    for (int links = 0; links < longest_chain && fs::is_symlink(path, failed); ++links)
        path = path.parent_path() / fs::read_symlink(path, failed);
    return path;
}

/// The beginning of a name beside `target` for a file that gets its name later: short enough for an ending of its own.
std::string temporary_stem(const fs::path& target) {
    constexpr std::size_t longest = 200;  // bytes, of the 255 of a name
    const fs::path name = target.filename().string().substr(0, longest);
    return (target.has_parent_path() ? target.parent_path() / name : name).string();
}

mode_t mode_for_new_file() noexcept {
    const mode_t mask = ::umask(0);  // reading the mask means setting it
    ::umask(mask);
    return static_cast<mode_t>(0666 & ~mask);
}

}  // namespace

Bytes read_descriptor(int descriptor, std::string_view name, std::size_t limit, std::string_view signature) {
    constexpr std::size_t chunk = std::size_t{1} << 16;
    Bytes bytes;
    // One byte more than expected, so that a file of known size is read without growing the buffer at its end.
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
    if (file.get() < 0) throw Error(ExitCode::cannot_open, shown(path), "cannot be opened: " + reason(errno));
    return read_descriptor(file.get(), shown(path), limit, signature);
}

Bytes read_regular_file(const fs::path& path, std::size_t limit) {
    // Without O_NONBLOCK opening a named pipe would wait for a writer.
    const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)};
    if (file.get() < 0) throw Error(ExitCode::cannot_open, shown(path), "cannot be opened: " + reason(errno));
    struct stat status {};
    if (::fstat(file.get(), &status) != 0 || !(S_ISREG(status.st_mode) || S_ISDIR(status.st_mode)))
        throw Error(ExitCode::cannot_open, shown(path), "is a device or a pipe", "name a file");
    return read_descriptor(file.get(), shown(path), limit);
}

Delivery write_all(int descriptor, std::span<const std::byte> bytes, std::string_view name) {
    while (!bytes.empty()) {
        const ssize_t put = ::write(descriptor, bytes.data(), bytes.size());
        if (put < 0 && errno == EINTR) continue;
        if (put < 0 && errno == EPIPE) return Delivery::reader_left;
        if (put < 0) throw Error(ExitCode::io_error, name, "cannot be written: " + reason(errno));
        bytes = bytes.subspan(static_cast<std::size_t>(put));
    }
    return Delivery::whole;
}

AtomicFile::AtomicFile(const fs::path& path) : name_(shown(path)), target_(path) {
    struct stat status {};
    const bool exists = ::stat(target_.c_str(), &status) == 0;
    if (!exists && (errno == ENAMETOOLONG || errno == ELOOP))
        throw Error(ExitCode::cannot_create, name_, "cannot be created: " + reason(errno));
    if (exists && S_ISDIR(status.st_mode)) throw Error(ExitCode::cannot_create, name_, "is a folder", "name a file");
    renames_ = !exists || S_ISREG(status.st_mode);
    // /dev/stdout is a link too, but one whose end need not have a path.
    if (renames_) target_ = link_target(path);
    if (!renames_) {
        written_ = target_;
        descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    } else {
        descriptor_ = open_beside_target();
    }
    if (descriptor_ < 0) throw Error(ExitCode::cannot_create, name_, "cannot be created: " + reason(errno));
    // A temporary is private to its owner; the file that replaces another takes over who may read it.
    if (renames_) static_cast<void>(::fchmod(descriptor_, exists ? status.st_mode & 07777 : mode_for_new_file()));
}

AtomicFile::~AtomicFile() { discard(); }

int AtomicFile::open_beside_target() {
#ifdef O_TMPFILE
    const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path{"."};
    const int nameless = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600);
    if (nameless >= 0 && ::access(own_link(nameless).c_str(), F_OK) == 0) return nameless;
    if (nameless >= 0) ::close(nameless);  // no /proc, through which it would get its name
#endif
    std::string pattern = temporary_stem(target_) + ".XXXXXX";
    const int named = ::mkostemp(pattern.data(), O_CLOEXEC);
    written_ = pattern;
    return named;
}

/// A temporary one: a link cannot replace a file. Returns errno, or 0.
int AtomicFile::give_name() {
    for (int attempt = 0;; ++attempt) {
        const fs::path name =
            temporary_stem(target_) + "." + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".tmp";
        if (::linkat(AT_FDCWD, own_link(descriptor_).c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0) {
            written_ = name;
            return 0;
        }
        if (errno != EEXIST) return errno;
    }
}

Delivery AtomicFile::write(std::span<const std::byte> bytes) { return write_all(descriptor_, bytes, name_); }

void AtomicFile::commit() {
    int error = written_.empty() ? give_name() : 0;
    const int descriptor = std::exchange(descriptor_, -1);
    if (::close(descriptor) != 0 && error == 0) error = errno;
    if (error == 0 && renames_ && ::rename(written_.c_str(), target_.c_str()) != 0) error = errno;
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
