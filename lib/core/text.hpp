#pragma once
/// Text utilities: numbers in their shortest exact form, one-line messages, "did you mean". Independent of the locale.
/// Tested by core/text_test.
#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soft::core {

/// Shortest decimal text that parses to the same double ("0.1", "1e-09", "nan").
[[nodiscard]] std::string number_text(double value);

/// `digits` significant digits without trailing zeros, for messages.
[[nodiscard]] std::string rounded_text(double value, int digits);

/// "1 step", "2 steps".
template <std::integral Count>
[[nodiscard]] std::string counted(Count count, std::string_view noun) {
    return std::to_string(count).append(" ").append(noun).append(count == 1 ? "" : "s");
}

/// "a, b, c"
[[nodiscard]] std::string join(std::span<const std::string> words, std::string_view separator = ", ");

/// The parts of `text` between the separators, trimmed; one empty part for an empty text.
[[nodiscard]] std::vector<std::string> split(std::string_view text, char separator);

/// `text` in single quotes. A quote in it becomes `escaped_quote`: '' in YAML and gnuplot.
[[nodiscard]] std::string single_quoted(std::string_view text, std::string_view escaped_quote = "''");

/// `text` as one line for a terminal: control characters and invalid UTF-8 become '?'; text beyond `max_length` bytes is replaced
/// by "...".
[[nodiscard]] std::string one_line(std::string_view text, std::size_t max_length = 120);

/// one_line within single quotes.
[[nodiscard]] std::string quoted(std::string_view text);

/// The candidate with the smallest edit distance (insert, delete, replace, swap neighbours; case-insensitive), if that distance is
/// at most a third of the longer word, or 1: a likely typing error. The first of several equal candidates.
[[nodiscard]] std::optional<std::string> nearest(std::string_view word, std::span<const std::string> candidates);

/// "did you mean 'wall'?" if a candidate is near, otherwise "known: a, b, c"; empty without candidates.
[[nodiscard]] std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

/// The words of a line, split as by a POSIX shell (2.2 Quoting): blanks separate words; '...' is literal; within "..." a backslash
/// escapes " and \, outside of quotes any character. Variables, patterns and comments are not supported. nullopt for an unclosed
/// quote and for a backslash at the end.
[[nodiscard]] std::optional<std::vector<std::string>> shell_words(std::string_view line);

/// A word as a shell reads it back; quoted only if necessary. The inverse of shell_words.
[[nodiscard]] std::string shell_quoted(std::string_view word);

/// `text` without leading and trailing blanks (space, tab, carriage return, newline).
[[nodiscard]] std::string_view trimmed(std::string_view text) noexcept;

/// Offset of the first byte that is not well-formed UTF-8 (surrogates and overlong forms included), or nullopt.
[[nodiscard]] std::optional<std::size_t> first_invalid_utf8(std::string_view text) noexcept;

}  // namespace soft::core
