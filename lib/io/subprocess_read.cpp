#include "io/trial.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <new>

#include "core/subprocess.hpp"
#include "core/memory.hpp"
#include "core/text.hpp"

namespace soft::io {
namespace {

/// A text that the process made for the trial writes and this one reads.
class SharedNote {
public:
    SharedNote() : start_(::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
        if (start_ == MAP_FAILED) throw std::bad_alloc{};
    }
    ~SharedNote() { ::munmap(start_, size); }
    SharedNote(const SharedNote&) = delete;
    SharedNote& operator=(const SharedNote&) = delete;

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

/// Exit code and message; empty where nothing was thrown.
core::Bytes verdict_of(const std::function<void(const Origin&)>& read, const Origin& origin) {
    try {
        read(origin);
        return {};
    } catch (const Error& error) {
        if (error.code() == ExitCode::io_error) throw std::bad_alloc{};  // the limit of the trial, not the machine's
        core::Bytes verdict{static_cast<std::byte>(error.code())};
        const auto message = std::as_bytes(std::span{std::string_view{error.what()}});
        verdict.insert(verdict.end(), message.begin(), message.end());
        return verdict;
    }
}

}  // namespace

void try_apart(const Origin& origin, const std::function<void(const Origin& noted)>& read) {
    const SharedNote note;
    Origin noted = origin;
    noted.note = note.characters();
    const core::SubprocessLimits limits = limits_for(origin.image_bytes);
    const core::SubprocessEnd end = core::run_in_subprocess([&] { return verdict_of(read, noted); }, limits);
    if (!end.result) {
        core::require_memory(limits.memory);  // where the machine has less, the file is not to blame
        const std::string place = note.text();
        throw Error(ExitCode::bad_input, place.empty() ? origin.source : core::one_line(place),
                    "HDF5 cannot read on from here: " + end.reason + "; the file is damaged and has no seal",
                    origin.remedy);
    }
    if (end.result->empty()) return;
    const auto* text = reinterpret_cast<const char*>(end.result->data());
    throw Error(static_cast<ExitCode>(end.result->front()), "", {text + 1, end.result->size() - 1});
}

}  // namespace soft::io
