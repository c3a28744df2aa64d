#include <algorithm>
#include <exception>

#include "core/error.hpp"
#include "core/text.hpp"
#include "target.hpp"

namespace soft::fuzz {
namespace {

std::optional<std::string> fault_of(const Error& error) {
    const std::string_view text = error.what();
    if (error.code() == ExitCode::internal || error.code() == ExitCode::ok)
        return "the Error blames the program: " + std::string{text};
    const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == '\x7f'; };
    if (core::first_invalid_utf8(text)) return "the Error is not UTF-8: " + core::one_line(text);
    if (std::ranges::any_of(text, is_control)) return "the Error is not one line: " + core::one_line(text);
    constexpr std::size_t longest = 2000;
    if (text.size() > longest) return "the Error is " + std::to_string(text.size()) + " bytes long";
    return std::nullopt;
}

}  // namespace

void require(bool is_true, std::string_view claim) {
    if (!is_true) throw Claim{std::string{claim}};
}

void even_so(const std::function<void()>& reads) {
    try {
        reads();
    } catch (const Error& error) {
        if (const auto fault = fault_of(error)) throw Claim{*fault};
    }
}

std::optional<std::string> fault_of(std::span<const std::byte> bytes) {
    try {
        read(bytes);
        return std::nullopt;
    } catch (const Error& error) {
        return fault_of(error);
    } catch (const Claim& claim) {
        return "not true: " + claim.text;
    } catch (const std::exception& error) {
        return std::string{"another exception: "} + error.what();
    }
}

}  // namespace soft::fuzz
