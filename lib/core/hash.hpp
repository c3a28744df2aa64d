#pragma once
/// SHA-256 digest (FIPS 180-4) as lower-case hex. Tested by core/hash_test with the test vectors of the standard.
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace soft::core {

[[nodiscard]] std::string sha256_hex(std::span<const std::byte> bytes);
[[nodiscard]] std::string sha256_hex(std::string_view text);

}  // namespace soft::core
