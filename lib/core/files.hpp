#pragma once
/// Bytes in and out: whole files, pipes, and files that appear under their name only when they are whole.
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

/// Everything up to the end of the stream. `name` stands in errors: io_error for a failed read, cannot_open for a
/// folder, bad_input beyond `limit` bytes. Bytes that do not begin with `signature` are read no further: what there is, is
/// returned, to be refused, and an endless stream does not fill the memory.
[[nodiscard]] Bytes read_descriptor(int descriptor, std::string_view name, std::size_t limit = no_limit,
                                    std::string_view signature = {});

/// The whole file; Error(cannot_open) with the reason.
[[nodiscard]] Bytes read_file(const std::filesystem::path& path, std::size_t limit = no_limit,
                              std::string_view signature = {});

/// A file that data name rather than the user of the program. Only a regular one is read: a device, a pipe or a terminal may
/// never end, or take what was meant for others. Error(cannot_open) with the reason, Error(bad_input) beyond the limit.
[[nodiscard]] Bytes read_regular_file(const std::filesystem::path& path, std::size_t limit);

/// A reader that closes its end of the pipe is no failure of the writer: the caller just stops.
enum class Delivery { whole, reader_left };

/// Writes all bytes, going on after short writes and interrupts. Error(io_error) if the disk is full or the like.
/// SIGPIPE must be ignored by the process (cli::run_guarded does).
[[nodiscard]] Delivery write_all(int descriptor, std::span<const std::byte> bytes, std::string_view name);

/// A file that is written without a name, where the file system allows that, and renamed to its place by commit(): a reader
/// sees the old file or the whole new one, and without commit() nothing is left behind, not after a kill either (elsewhere it
/// has a temporary name beside its place, which a kill leaves). Symbolic links are followed and stay, also those
/// that lead to no file yet; a target that is no regular file (/dev/null, a named pipe) is written directly.
class AtomicFile {
public:
    explicit AtomicFile(const std::filesystem::path& path);  ///< Error(cannot_create) with the reason
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    [[nodiscard]] int descriptor() const noexcept { return descriptor_; }
    [[nodiscard]] Delivery write(std::span<const std::byte> bytes);
    /// Closes and renames; Error(io_error) if either fails, and then nothing is left behind.
    void commit();

private:
    [[nodiscard]] int open_beside_target();
    [[nodiscard]] int give_name();
    void discard() noexcept;

    std::string name_;  ///< as the user wrote it, for errors
    std::filesystem::path target_;
    std::filesystem::path written_;  ///< empty: without a name until commit()
    int descriptor_ = -1;
    bool renames_ = true;
};

}  // namespace soft::core
