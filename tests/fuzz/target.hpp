#pragma once
/// Interface of the fuzz targets. Each target is one file that defines read(); the fuzzer (entry.cpp) or the replay of stored inputs
/// (replay.cpp) calls it through fault_of().
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace soft::fuzz {

/// Passes the bytes to a reader. Throws Claim if the data read violate a property.
void read(std::span<const std::byte> bytes);

/// A violated property of the reader, for example that written data read back unchanged.
struct Claim {
    std::string text;
};
void require(bool is_true, std::string_view claim);

/// Runs one of several readers and ignores a valid rejection, so that the next reader runs too. A faulty rejection throws Claim.
void even_so(const std::function<void()>& reads);

/// Fault of the reader for these bytes; nullopt if it accepts or correctly rejects them. A correct rejection is an Error that blames
/// the input (not `internal`, not `ok`) in one line of printable UTF-8.
[[nodiscard]] std::optional<std::string> fault_of(std::span<const std::byte> bytes);

[[nodiscard]] inline std::string_view text_of(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace soft::fuzz
