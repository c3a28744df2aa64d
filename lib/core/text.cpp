#include "core/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

namespace soft::core {
namespace {

char lower(char c) noexcept { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Optimal string alignment: an edit distance that counts a swap of neighbouring letters once.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) above[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (same ? 0u : 1u)});
            const bool swapped =
                i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
            if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
        }
        std::swap(before, above);
        std::swap(above, row);
    }
    return above[b.size()];
}

/// Length of the UTF-8 sequence of a lead byte and the range of its second byte; length 0 for an invalid lead byte.
struct Sequence {
    std::size_t length;
    unsigned char low, high;
};
Sequence utf8_sequence(unsigned char lead) noexcept {
    if (lead < 0x80) return {1, 0, 0};
    if (lead >= 0xC2 && lead <= 0xDF) return {2, 0x80, 0xBF};
    if (lead == 0xE0) return {3, 0xA0, 0xBF};
    if (lead == 0xED) return {3, 0x80, 0x9F};  // 0xA0 and up would be surrogates
    if (lead >= 0xE1 && lead <= 0xEF) return {3, 0x80, 0xBF};
    if (lead == 0xF0) return {4, 0x90, 0xBF};
    if (lead >= 0xF1 && lead <= 0xF3) return {4, 0x80, 0xBF};
    if (lead == 0xF4) return {4, 0x80, 0x8F};
    return {0, 0, 0};
}

}  // namespace

std::string number_text(double value) {
    std::array<char, 32> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    return {buffer.data(), end};
}

std::string rounded_text(double value, int digits) {
    std::array<char, 64> buffer;
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits).ptr;
    return {buffer.data(), end};
}

std::string join(std::span<const std::string> words, std::string_view separator) {
    std::string text;
    for (const std::string& word : words) {
        if (!text.empty()) text += separator;
        text += word;
    }
    return text;
}

std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> parts;
    while (true) {
        const std::size_t end = text.find(separator);
        parts.emplace_back(trimmed(text.substr(0, end)));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

std::string single_quoted(std::string_view text, std::string_view escaped_quote) {
    std::string quoted = "'";
    for (const char c : text) quoted.append(c == '\'' ? escaped_quote : std::string_view{&c, 1});
    return quoted + "'";
}

std::string one_line(std::string_view text, std::size_t max_length) {
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
    std::size_t size = std::min(text.size(), max_length);
    constexpr int max_continuation_bytes = 3;  // bytes before its last
    for (int k = 0; k < max_continuation_bytes && size > 0 && (byte(size) & 0xC0U) == 0x80U; ++k)
        --size;  // do not split a multi-byte character
    std::string line{text.substr(0, size)};
    for (std::size_t i = 0; i < size; ++i) {
        const bool is_c1 = byte(i) == 0xC2U && byte(i + 1) < 0xA0U;  // C1 control characters also act on terminals
        if (byte(i) < 0x20U || byte(i) == 0x7FU || is_c1) line[i] = '?';
    }
    for (std::size_t from = 0; const auto bad = first_invalid_utf8(std::string_view{line}.substr(from));) {
        line[from + *bad] = '?';
        from += *bad + 1;
    }
    return size < text.size() ? line + "..." : line;
}

std::string quoted(std::string_view text) {
    std::string line{"'"};
    line += one_line(text);
    line += '\'';
    return line;
}

std::optional<std::string> nearest(std::string_view word, std::span<const std::string> candidates) {
    constexpr std::size_t max_word = 64;  // bounds the cost for malicious input
    if (word.size() > max_word) return std::nullopt;
    const std::string* best = nullptr;
    std::size_t min_distance = 0;
    for (const std::string& candidate : candidates) {
        const std::size_t distance = edit_distance(word, candidate);
        const std::size_t near = std::max<std::size_t>(1, std::max(word.size(), candidate.size()) / 3);
        if (distance > near || (best != nullptr && distance >= min_distance)) continue;
        best = &candidate;
        min_distance = distance;
    }
    return best == nullptr ? std::nullopt : std::optional{*best};
}

std::string did_you_mean(std::string_view word, std::span<const std::string> candidates) {
    if (candidates.empty()) return {};
    if (const auto near = nearest(word, candidates)) return "did you mean " + core::quoted(*near) + "?";
    constexpr std::size_t max_length = 1000;  // the number of candidates from a file is unbounded
    return "known: " + one_line(join(candidates), max_length);
}

std::optional<std::vector<std::string>> shell_words(std::string_view line) {
    std::vector<std::string> words;
    bool in_word = false;
    char quote = 0;  // the open quote; 0: none
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        const bool is_blank = quote == 0 && (c == ' ' || c == '\t' || c == '\r' || c == '\n');
        if (!is_blank && !in_word) words.emplace_back();
        in_word = !is_blank;
        if (is_blank) continue;
        if (c == quote) {
            quote = 0;
        } else if (quote == 0 && (c == '\'' || c == '"')) {
            quote = c;
        } else if (c == '\\' && quote != '\'') {
            if (i + 1 == line.size()) return std::nullopt;
            const char next = line[i + 1];
            const bool escapes = quote == 0 || next == '"' || next == '\\';
            words.back() += escapes ? next : c;
            if (escapes) ++i;
        } else {
            words.back() += c;
        }
    }
    if (quote != 0) return std::nullopt;
    return words;
}

std::string shell_quoted(std::string_view word) {
    const bool plain = !word.empty() && word.find_first_of(" \t\n\"'\\$`*?[]{}()<>|&;#~!") == std::string_view::npos;
    return plain ? std::string{word} : single_quoted(word, "'\\''");
}

std::string_view trimmed(std::string_view text) noexcept {
    constexpr std::string_view blanks = " \t\r\n";
    const auto first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::optional<std::size_t> first_invalid_utf8(std::string_view text) noexcept {
    std::size_t i = 0;
    while (i < text.size()) {
        const Sequence sequence = utf8_sequence(static_cast<unsigned char>(text[i]));
        if (sequence.length == 0 || i + sequence.length > text.size()) return i;
        for (std::size_t k = 1; k < sequence.length; ++k) {
            const auto byte = static_cast<unsigned char>(text[i + k]);
            const unsigned char low = k == 1 ? sequence.low : 0x80, high = k == 1 ? sequence.high : 0xBF;
            if (byte < low || byte > high) return i;
        }
        i += sequence.length;
    }
    return std::nullopt;
}

}  // namespace soft::core
