#include "view/text.hpp"

#include <charconv>
#include <vector>

#include "core/hash.hpp"
#include "core/text.hpp"

namespace soft::view {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD

/// Appends one ASCII character, escaped.
void append_escaped(std::string& out, char c) {
    switch (c) {
        case '&': out += "&amp;"; return;
        case '<': out += "&lt;"; return;
        case '>': out += "&gt;"; return;
        case '"': out += "&quot;"; return;
        case '\'': out += "&#39;"; return;
        case '\t':
        case '\n': out += c; return;
        default: break;
    }
    const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
    if (control)
        out += replacement;
    else
        out += c;
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string out;
    while (true) {
        const auto bad = core::first_invalid_utf8(text);
        for (const char c : text.substr(0, bad.value_or(text.size()))) append_escaped(out, c);
        if (!bad) return out;
        out += replacement;
        text.remove_prefix(*bad + 1);
    }
}

std::string json_in_page(std::string json) {
    for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos; at += 6) json.replace(at, 1, "\\u003c");
    return json;
}

std::string joined(std::span<const std::string_view> pieces) {
    std::string text;
    for (const std::string_view piece : pieces) text += piece;
    return text;
}

std::string base64(std::string_view text) { return core::base64(std::as_bytes(std::span(text.data(), text.size()))); }

std::string policy_hash(std::string_view script) {
    const std::string hex = core::sha256_hex(script);
    std::vector<std::byte> bytes;
    for (std::size_t i = 0; i < hex.size(); i += 2) {
        unsigned value = 0;
        std::from_chars(hex.data() + i, hex.data() + i + 2, value, 16);
        bytes.push_back(static_cast<std::byte>(value));
    }
    return std::string{"sha256-"} + core::base64(bytes);
}

}  // namespace soft::view
