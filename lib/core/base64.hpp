#pragma once
/// Base64 encoding (RFC 4648, with padding) for binary data in XML and HTML. Tested by core/base64_test.
#include <cstddef>
#include <span>
#include <string>

namespace soft::core {

[[nodiscard]] std::string base64(std::span<const std::byte> bytes);

}  // namespace soft::core
