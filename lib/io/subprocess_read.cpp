#include "io/subprocess_read.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <new>

#include "core/memory.hpp"
#include "core/subprocess.hpp"
#include "core/text.hpp"

namespace soft::io {
namespace {

/// Shared memory for a text that the subprocess writes and this process reads.
class SharedText {
public:
    SharedText() : start_(::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
        if (start_ == MAP_FAILED) throw std::bad_alloc{};
    }
    ~SharedText() { ::munmap(start_, size); }
    SharedText(const SharedText&) = delete;
    SharedText& operator=(const SharedText&) = delete;

    [[nodiscard]] std::span<char> characters() const { return {static_cast<char*>(start_), size}; }
    [[nodiscard]] std::string text() const {
        const auto all = characters();
        return {all.begin(), std::ranges::find(all, '\0')};
    }

private:
    static constexpr std::size_t size = 4096;
    void* start_;
};

core::SubprocessLimits limits_for(std::size_t image_bytes) {
    constexpr std::size_t bytes_a_second = 10'000'000;
    const std::chrono::seconds processor{10 + static_cast<long>(image_bytes / bytes_a_second)};
    return {.wall = 10 * processor, .processor = processor, .memory = (std::size_t{1} << 28) + 64 * image_bytes};
}

/// Exit code and message of the Error that `read` throws; empty if it throws none.
core::Bytes encode_error(const std::function<void(const Origin&)>& read, const Origin& origin) {
    try {
        read(origin);
        return {};
    } catch (const Error& error) {
        if (error.code() == ExitCode::io_error)
            throw std::bad_alloc{};  // the memory limit of the subprocess was reached
        core::Bytes encoded{static_cast<std::byte>(error.code())};
        const auto message = std::as_bytes(std::span{std::string_view{error.what()}});
        encoded.insert(encoded.end(), message.begin(), message.end());
        return encoded;
    }
}

}  // namespace

void read_in_subprocess(const Origin& origin, const std::function<void(const Origin& noted)>& read) {
    const SharedText note;
    Origin noted = origin;
    noted.note = note.characters();
    const core::SubprocessLimits limits = limits_for(origin.image_bytes);
    const core::SubprocessOutcome end = core::run_in_subprocess([&] { return encode_error(read, noted); }, limits);
    if (!end.result) {
        core::require_memory(limits.memory);  // out of memory on this machine is not an error of the file
        const std::string location = note.text();
        throw Error(ExitCode::bad_input, location.empty() ? origin.source : core::one_line(location),
                    "HDF5 cannot read this damaged file, which has no seal: " + end.reason, origin.remedy);
    }
    if (end.result->empty()) return;
    const auto* text = reinterpret_cast<const char*>(end.result->data());
    throw Error(static_cast<ExitCode>(end.result->front()), "", {text + 1, end.result->size() - 1});
}

}  // namespace soft::io
