#pragma once
/// SHA-256 (FIPS 180-4) of bytes, as lower-case hex. Tested by core/hash_test with the standard's own vectors.
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace soft::core {

[[nodiscard]] std::string sha256_hex(std::span<const std::byte> bytes);
[[nodiscard]] std::string sha256_hex(std::string_view text);

}  // namespace soft::core
