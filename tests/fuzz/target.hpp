#pragma once
/// Readers under hostile input. One file a reader defines read(); the fuzzer (entry.cpp) or the replay of kept files (replay.cpp)
/// calls it with the bytes, through fault_of().
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace soft::fuzz {

/// Hands the bytes to a reader. Throws Claim where what was read contradicts itself.
void read(std::span<const std::byte> bytes);

/// A property of the reader that does not hold, such as: what was written out reads back to the same.
struct Claim {
    std::string text;
};
void require(bool holds, std::string_view claim);

/// Runs one reader of several: what this one refuses, the others may take. A fault in the refusal is one of the target.
void even_so(const std::function<void()>& reads);

/// What is wrong with how the reader takes the bytes; nullopt where it takes or refuses them as it should: the only thing that
/// may leave it is an Error that blames the input (not `internal`, not `ok`), in one line of printable text.
[[nodiscard]] std::optional<std::string> fault_of(std::span<const std::byte> bytes);

[[nodiscard]] inline std::string_view text_of(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace soft::fuzz
