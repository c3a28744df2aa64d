#pragma once
/// Input and output of bytes: files, pipes, and atomic files, which appear under their name only once they are complete.
/// Tested by core/files_test.
#include <cstddef>
#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace soft::core {

using Bytes = std::vector<std::byte>;
inline constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();

/// Reads to the end of the stream. `name` is the location in errors: io_error for a failed read, cannot_open for a folder,
/// bad_input beyond `limit` bytes. Reading stops early if the stream does not begin with `signature`; the bytes read so far are
/// returned for the caller to reject. An endless stream of another format therefore does not fill the memory.
[[nodiscard]] Bytes read_descriptor(int descriptor, std::string_view name, std::size_t limit = no_limit,
                                    std::string_view signature = {});

/// Reads a file. Error(cannot_open) with the reason.
[[nodiscard]] Bytes read_file(const std::filesystem::path& path, std::size_t limit = no_limit,
                              std::string_view signature = {});

/// Reads a file whose name comes from input data instead of the command line. Only regular files are accepted, because a device,
/// a pipe or a terminal may never end, or may consume the input of another program. Error(cannot_open) with the reason,
/// Error(bad_input) beyond the limit.
[[nodiscard]] Bytes read_regular_file(const std::filesystem::path& path, std::size_t limit);

/// A reader that closes its end of the pipe is not an error: the caller stops writing.
enum class WriteStatus { complete, reader_closed };

/// Writes all bytes; continues after short writes and interrupts. Error(io_error) if a write fails, for example on a full disk.
/// The process must ignore SIGPIPE (cli::run_guarded does this).
[[nodiscard]] WriteStatus write_all(int descriptor, std::span<const std::byte> bytes, std::string_view name);

/// Writes a file atomically: a reader sees either the old file or the complete new one. The data go to an unnamed file if the file
/// system supports that (O_TMPFILE), and commit() gives it the target name. Without commit() nothing remains, even after SIGKILL; within
/// commit() of a file that replaces another one, between two system calls, SIGKILL leaves it under a temporary name.
/// On other file systems the data go to a temporary file in the target's folder, which remains after SIGKILL.
/// Symbolic links are followed and kept, even if their target does not exist yet. A target that is not a regular file
/// (/dev/null, a named pipe) is written directly.
class AtomicFile {
public:
    explicit AtomicFile(const std::filesystem::path& path);  ///< Error(cannot_create) with the reason
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    [[nodiscard]] int descriptor() const noexcept { return descriptor_; }
    [[nodiscard]] WriteStatus write(std::span<const std::byte> bytes);
    /// Closes and renames the file. Error(io_error) if either fails; the temporary file is then removed.
    void commit();

private:
    [[nodiscard]] int open_beside_target();
    [[nodiscard]] int link_unnamed();
    void discard() noexcept;

    std::string name_;  ///< as the user wrote it, for errors
    std::filesystem::path target_;
    std::filesystem::path written_;  ///< file being written; empty for an unnamed file before commit()
    int descriptor_ = -1;
    bool renames_ = true;
};

}  // namespace soft::core
