#pragma once
/// Small pieces of text: numbers in their shortest exact form, one-line messages, "did you mean". Independent of the
/// locale throughout. Tested by core/text_test.
#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soft::core {

/// Shortest decimal text that reads back to the same double ("0.1", "1e-09", "nan").
[[nodiscard]] std::string number_text(double value);

/// `digits` significant digits without trailing zeros, for messages where exactness does not matter.
[[nodiscard]] std::string rounded_text(double value, int digits);

/// "1 step", "2 steps".
template <std::integral Count>
[[nodiscard]] std::string counted(Count count, std::string_view thing) {
    return std::to_string(count).append(" ").append(thing).append(count == 1 ? "" : "s");
}

/// "a, b, c"
[[nodiscard]] std::string join(std::span<const std::string> words, std::string_view separator = ", ");

/// `text` fit for one line of a terminal: control characters and what is not UTF-8 become '?', more than `longest` bytes are cut with "...".
[[nodiscard]] std::string one_line(std::string_view text, std::size_t longest = 120);

/// one_line within single quotes.
[[nodiscard]] std::string quoted(std::string_view text);

/// The candidate with the least edit distance (insert, delete, replace, swap neighbours; letter case is free), if it
/// is near enough to be a slip of the keyboard: at most a third of the longer word, at least one. First of equals.
[[nodiscard]] std::optional<std::string> nearest(std::string_view word, std::span<const std::string> candidates);

/// "did you mean 'wall'?" when one is near, else "known: a, b, c"; empty without candidates.
[[nodiscard]] std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

/// The words of a line, as a shell takes it apart (POSIX, 2.2): blanks part them; 'as it is'; within "..." a backslash before " or \ takes
/// that character as it is, outside of quotes before any. No variables, patterns or comments. nullopt for a quote that is not
/// closed and for a backslash at the end.
[[nodiscard]] std::optional<std::vector<std::string>> shell_words(std::string_view line);

/// Without blanks (space, tab, carriage return, newline) at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text) noexcept;

/// Offset of the first byte that is not well-formed UTF-8 (surrogates and overlong forms included), or nullopt.
[[nodiscard]] std::optional<std::size_t> first_invalid_utf8(std::string_view text) noexcept;

}  // namespace soft::core
