#pragma once
/// SHA-256 digest (FIPS 180-4) as lower-case hex, and base64 (RFC 4648, with padding) for binary data in XML and HTML.
/// Tested by core/hash_test with the test vectors of the standards.
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace soft::core {

[[nodiscard]] std::string sha256_hex(std::span<const std::byte> bytes);
[[nodiscard]] std::string sha256_hex(std::string_view text);
[[nodiscard]] std::string base64(std::span<const std::byte> bytes);

}  // namespace soft::core
